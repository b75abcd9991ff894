"""Grid of one body: clearing, and the momentum update."""

from orthocut.kernels.jit import jit
from orthocut.kernels.mpm.layout import NFX, NFY, NM, NMARK, NODE, NPX, NPY, NVX, NVY


@jit
def clear_grid(grid, extent, count_x):
    """Set all quantities to zero on the nodes of an extent (first and last column, first and last row)."""
    for j in range(extent[2], extent[3] + 1):
        for at in range((j * count_x + extent[0]) * NODE, (j * count_x + extent[1] + 1) * NODE):
            grid[at] = 0.0


@jit
def update_grid(grid, extent, count_x, last_clamped_row, mass_small, time_step, damping):
    """New velocities of the nodes from momentum, force and damping; clamped nodes stand still.

    Parameters
    ----------
    grid : float array
        Nodes of one body; velocities are set, marks cleared.
    extent : int array, shape (4,)
        First and last column, first and last row of the nodes in use.
    count_x : int
        Nodes in a row.
    last_clamped_row : int
        Rows up to this one are clamped in both directions; -1 for none.
    mass_small : float
        Nodes of less mass are skipped [kg/m].
    time_step : float
        Time step [s].
    damping : float
        Feedback damping rate [1/s].

    Returns
    -------
    kinetic, kinetic_new : float
        Kinetic energy of the nodes that are free, before and after the update [J/m].
    damped : float
        Energy removed by damping [J/m].
    impulse_x, impulse_y : float
        Impulse of the clamp on the body [N s/m].
    """
    kinetic = kinetic_new = damped = impulse_x = impulse_y = 0.0
    for j in range(extent[2], extent[3] + 1):
        clamped = j <= last_clamped_row
        for at in range((j * count_x + extent[0]) * NODE, (j * count_x + extent[1] + 1) * NODE, NODE):
            mass = grid[at + NM]
            grid[at + NMARK] = 0.0
            if mass <= mass_small:
                continue
            px, py = grid[at + NPX], grid[at + NPY]
            vx, vy = px / mass, py / mass
            if clamped:
                impulse_x -= px + time_step * grid[at + NFX]
                impulse_y -= py + time_step * grid[at + NFY]
                grid[at + NVX] = 0.0
                grid[at + NVY] = 0.0
                continue
            kinetic += 0.5 * (px * vx + py * vy)
            factor = time_step / mass
            nx = vx + factor * grid[at + NFX] - time_step * damping * vx
            ny = vy + factor * grid[at + NFY] - time_step * damping * vy
            grid[at + NVX] = nx
            grid[at + NVY] = ny
            kinetic_new += 0.5 * mass * (nx * nx + ny * ny)
            damped += 0.5 * mass * time_step * damping * (vx * (vx + nx) + vy * (vy + ny))
    return kinetic, kinetic_new, damped, impulse_x, impulse_y
