"""Grids of a body in the loop of `usavg`: one for each contact pass of a step."""

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.layout import NFX, NFY, NM, NMARK, NODE, NPX, NPY, NVX, NVY


@part
def set_velocities(grid, target, extent, frame, free):
    """Set the velocities of a target grid to momentum over mass of a grid; clamped nodes stand still.

    Parameters
    ----------
    grid, target : float array
        Nodes of a body; they may be the same.
    extent : int array, shape (4,)
        First and last column, first and last row of the nodes in use.
    frame : Frame
        Grid.
    free : int array, shape (4,)
        First and last column, first and last row of the nodes that are not held; only the rows count here.
    """
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE, NODE):
            mass = grid[at + NM]
            scale = 1.0 / mass if mass > frame.mass_small and j >= free[2] else 0.0
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
def work_of_stresses(first, second, third, extent, frame):
    """Work of the internal forces of a step on the mean of the velocities that deform the points [J/m].

    Parameters
    ----------
    first, second, third : float array
        Nodes of a body. The forces of the first grid are those of the interface alone, the second one has all.
    extent : int array, shape (4,)
        First and last column, first and last row of the nodes in use.
    frame : Frame
        Grid and time step.
    """
    power = 0.0
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE, NODE):
            fx, fy = second[at + NFX] - first[at + NFX], second[at + NFY] - first[at + NFY]
            power += fx * (first[at + NVX] + third[at + NVX]) + fy * (first[at + NVY] + third[at + NVY])
    return 0.5 * frame.time_step * power
