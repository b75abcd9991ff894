"""Grid of one body: clearing, and the momentum update."""

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.layout import NFX, NFY, NM, NMARK, NODE, NPX, NPY, NVX, NVY
from orthocut.kernels.mpm.support import LOOSE


@part
def clear_grid(grid, extent, frame):
    """Set all quantities to zero on the nodes of an extent (first and last column, first and last row)."""
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE):
            grid[at] = 0.0


@part
def moving_mass(grid, at):
    """Mass that a node moves: its own and that of the loose nodes that follow it [kg/m]."""
    return max(grid[at + NM] + grid[at + NMARK], 0.5 * grid[at + NM])


@part
def update_grid(grid, extent, frame, free, damping, kept=0.0):
    """New velocities of the nodes from momentum, force and damping; held nodes stand still.

    Parameters
    ----------
    grid : float array
        Nodes of one body; velocities are set. Marks hold masses that move with the nodes beside their
        own; loose nodes are left alone, see `orthocut.kernels.mpm.support`.
    extent : int array, shape (4,)
        First and last column, first and last row of the nodes in use.
    frame : Frame
        Grid and time step.
    free : int array, shape (4,)
        First and last column, first and last row of the nodes that are not held; rows below are clamped in both
        directions, or on dashpots.
    damping : float
        Feedback damping rate [1/s].
    kept : float
        Share of the momentum of held nodes that their points keep: that of FLIP.

    Returns
    -------
    kinetic : float
        Kinetic energy of the nodes that are free, before the update [J/m].
    damped : float
        Energy removed by damping and by dashpots [J/m].
    impulse_x, impulse_y : float
        Impulse of the clamp and of the held nodes on the body [N s/m].
    """
    time_step = frame.time_step
    kinetic = damped = impulse_x = impulse_y = 0.0
    for j in range(extent[2], extent[3] + 1):
        clamped = j < free[2]
        row = j * frame.count_x
        for i in range(extent[0], extent[1] + 1):
            at = (row + i) * NODE
            mass = grid[at + NM]
            if grid[at + NMARK] == LOOSE or mass <= frame.mass_small:
                continue
            px, py = grid[at + NPX], grid[at + NPY]
            fx, fy = grid[at + NFX], grid[at + NFY]
            resting = i < free[0] or i > free[1]
            if clamped and frame.dashpot_normal > 0.0 and not resting:
                vx, vy = px / mass, py / mass
                new_vx = (px + time_step * fx) / (mass + time_step * frame.dashpot_shear)
                new_vy = (py + time_step * fy) / (mass + time_step * frame.dashpot_normal)
                push_x = -time_step * frame.dashpot_shear * new_vx
                push_y = -time_step * frame.dashpot_normal * new_vy
                grid[at + NVX] = new_vx
                grid[at + NVY] = new_vy
                impulse_x += push_x
                impulse_y += push_y
                kinetic += 0.5 * (px * vx + py * vy)
                damped -= 0.5 * (push_x * (vx + new_vx) + push_y * (vy + new_vy))
                continue
            if clamped or resting:
                impulse_x -= (1.0 - kept) * px + time_step * fx
                impulse_y -= (1.0 - kept) * py + time_step * fy
                grid[at + NVX] = 0.0
                grid[at + NVY] = 0.0
                continue
            vx, vy = px / mass, py / mass
            rate = time_step / moving_mass(grid, at)
            new_vx = vx + rate * fx - time_step * damping * vx
            new_vy = vy + rate * fy - time_step * damping * vy
            grid[at + NVX] = new_vx
            grid[at + NVY] = new_vy
            kinetic += 0.5 * (px * vx + py * vy)
            damped += 0.5 * time_step * damping * (px * (vx + new_vx) + py * (vy + new_vy))
    return kinetic, damped, impulse_x, impulse_y


@part
def work_of_forces(grid, grid_before, extent, frame):
    """Work of the forces of a step on the nodes, loose ones left out [J/m].

    Points deform and pairs of the interface move with the velocities at the ends of steps. A force is that of the time
    between two of these, and works on the mean of both, contact included.

    Parameters
    ----------
    grid : float array
        Nodes of one body with their velocities at the end of the step.
    grid_before : float array, same shape
        Nodes at the end of the step before, with their velocities then.
    extent : int array, shape (4,)
        Columns and rows in use.
    frame : Frame
        Grid and time step.
    """
    work = 0.0
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + extent[1] + 1) * NODE, NODE):
            if grid[at + NM] <= frame.mass_small or grid[at + NMARK] == LOOSE:
                continue
            work += grid[at + NFX] * grid[at + NVX] + grid[at + NFY] * grid[at + NVY]
            if grid_before[at + NM] > frame.mass_small:
                work += grid[at + NFX] * grid_before[at + NVX] + grid[at + NFY] * grid_before[at + NVY]
            else:
                work += (grid[at + NFX] * grid[at + NPX] + grid[at + NFY] * grid[at + NPY]) / grid[at + NM]
    return 0.5 * frame.time_step * work


@part
def join_bodies(chip, base, extent, frame):
    """Give chip and base one velocity beyond the end of the path; return the energy that this takes [J/m].

    Parameters
    ----------
    chip, base : float array
        Nodes of both bodies with their new velocities; modified in place.
    extent : int array, shape (4,)
        Columns and rows in use of the chip.
    frame : Frame
        Grid; `last_whole_column` says where.
    """
    lost = 0.0
    for j in range(extent[2], extent[3] + 1):
        row = j * frame.count_x
        for at in range((row + extent[0]) * NODE, (row + frame.last_whole_column + 1) * NODE, NODE):
            mass_chip, mass_base = chip[at + NM], base[at + NM]
            if mass_chip <= frame.mass_small or mass_base <= frame.mass_small:
                continue
            if chip[at + NMARK] == LOOSE or base[at + NMARK] == LOOSE:
                continue
            moving_chip, moving_base = moving_mass(chip, at), moving_mass(base, at)
            mass = moving_chip * moving_base / (moving_chip + moving_base)
            for k in range(2):
                gap = chip[at + NVX + k] - base[at + NVX + k]
                start = chip[at + NPX + k] / mass_chip - base[at + NPX + k] / mass_base
                chip[at + NVX + k] -= mass / moving_chip * gap
                base[at + NVX + k] += mass / moving_base * gap
                lost += 0.5 * mass * gap * start
    return lost
