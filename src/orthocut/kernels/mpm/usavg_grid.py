"""Grids of a body in the loop of `usavg`: one for each contact pass of a step."""

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.layout import NFX, NFY, NM, NMARK, NODE, NPX, NPY, NVX, NVY


@part
def set_velocities(grid, target, extent, frame, last_clamped_row):
    """Set the velocities of a target grid to momentum over mass of a grid; clamped nodes stand still.

    Parameters
    ----------
    grid, target : float array
        Nodes of a body; they may be the same.
    extent : int array, shape (4,)
        First and last column, first and last row of the nodes in use.
    frame : Frame
        Grid.
    last_clamped_row : int
        Rows up to this one are clamped in both directions; -1 for none.
    """
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE, NODE):
            mass = grid[at + NM]
            scale = 1.0 / mass if mass > frame.mass_small and j > last_clamped_row else 0.0
            target[at + NVX] = scale * grid[at + NPX]
            target[at + NVY] = scale * grid[at + NPY]


@part
def copy_loads(grid, target, extent, frame):
    """Copy masses, momenta and forces."""
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE, NODE):
            for k in (NM, NPX, NPY, NMARK, NFX, NFY):
                target[at + k] = grid[at + k]


@part
def average_velocities(first, third, target, extent, frame):
    """Set the velocities of a target grid to the mean of those of two grids.

    Parameters
    ----------
    first, third, target : float array
        Nodes of a body.
    extent : int array, shape (4,)
        First and last column, first and last row of the nodes in use.
    frame : Frame
        Grid and time step.

    Returns
    -------
    float
        Work of the forces of the target grid on these velocities in a step [J/m].
    """
    power = 0.0
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE, NODE):
            vx = 0.5 * (first[at + NVX] + third[at + NVX])
            vy = 0.5 * (first[at + NVY] + third[at + NVY])
            target[at + NVX] = vx
            target[at + NVY] = vy
            power += target[at + NFX] * vx + target[at + NFY] * vy
    return frame.time_step * power
