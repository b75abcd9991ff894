"""Grid of one body: clearing, and the momentum update."""

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.layout import NFX, NFY, NM, NMARK, NODE, NPX, NPY, NVX, NVY


@part
def clear_grid(grid, extent, frame):
    """Set all quantities to zero on the nodes of an extent (first and last column, first and last row)."""
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE):
            grid[at] = 0.0


@part
def update_grid(grid, grid_before, extent, frame, last_clamped_row, damping):
    """New velocities of the nodes from momentum, force and damping; clamped nodes stand still.

    Parameters
    ----------
    grid : float array
        Nodes of one body; velocities are set, marks cleared.
    grid_before : float array, same shape
        Nodes at the end of the step before, with their velocities then.
    extent : int array, shape (4,)
        First and last column, first and last row of the nodes in use.
    frame : Frame
        Grid and time step.
    last_clamped_row : int
        Rows up to this one are clamped in both directions; -1 for none.
    damping : float
        Feedback damping rate [1/s].

    Returns
    -------
    kinetic, kinetic_new : float
        Kinetic energy of the nodes that are free, before and after the update [J/m].
    damped : float
        Energy removed by damping [J/m].
    drag : float
        Energy lost where forces act on velocities that the transfers have changed since the step before [J/m]: points
        deform with the velocities at the ends of steps, so a force works on the mean of two of these, but it changes
        the kinetic energy by its product with the mean of the velocities before and after this update.
    impulse_x, impulse_y : float
        Impulse of the clamp on the body [N s/m].
    """
    time_step = frame.time_step
    kinetic = kinetic_new = damped = drag = impulse_x = impulse_y = 0.0
    for j in range(extent[2], extent[3] + 1):
        clamped = j <= last_clamped_row
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE, NODE):
            mass = grid[at + NM]
            grid[at + NMARK] = 0.0
            if mass <= frame.mass_small:
                continue
            px, py = grid[at + NPX], grid[at + NPY]
            fx, fy = grid[at + NFX], grid[at + NFY]
            if clamped:
                impulse_x -= px + time_step * fx
                impulse_y -= py + time_step * fy
                grid[at + NVX] = 0.0
                grid[at + NVY] = 0.0
                continue
            vx, vy = px / mass, py / mass
            new_vx = vx + time_step * (fx / mass - damping * vx)
            new_vy = vy + time_step * (fy / mass - damping * vy)
            grid[at + NVX] = new_vx
            grid[at + NVY] = new_vy
            kinetic += 0.5 * (px * vx + py * vy)
            kinetic_new += 0.5 * mass * (new_vx * new_vx + new_vy * new_vy)
            damped += 0.5 * time_step * damping * (px * (vx + new_vx) + py * (vy + new_vy))
            if grid_before[at + NM] > frame.mass_small:
                drag += fx * (grid_before[at + NVX] - vx) + fy * (grid_before[at + NVY] - vy)
    return kinetic, kinetic_new, damped, 0.5 * time_step * drag, impulse_x, impulse_y
