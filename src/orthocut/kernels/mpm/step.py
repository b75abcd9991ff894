"""The order of one time step, for many steps without returning to Python.

Update stress last, extrapolate velocities once: forces and momenta on the grid give new velocities; contact acts on these;
points, deformations, interface and tool all move with them.
"""

import math

from orthocut.kernels.jit import jit
from orthocut.kernels.mpm.contact import list_near_points, mark_contact_nodes, push_with_tool
from orthocut.kernels.mpm.grid import clear_grid, update_grid
from orthocut.kernels.mpm.interface import move_pairs, pull_together, push_apart, set_normals
from orthocut.kernels.mpm.layout import BASE, CHIP
from orthocut.kernels.mpm.points import advance_points

# totals since the start
CHIP_X, CHIP_Y, BASE_X, BASE_Y = 0, 1, 2, 3  # impulse of the tool on each body [N s/m]
CLAMP_X, CLAMP_Y = 4, 5  # impulse of the clamp [N s/m]
WORK, FRICTION, IMPACT, NUMERICAL, DAMPED, COHESIVE = 6, 7, 8, 9, 10, 11  # energies [J/m]
KINETIC = 12  # kinetic energy of the points now [J/m]
TIME = 13  # [s]
DAMPING = 14  # rate of the feedback damping [1/s]
TOTALS = 15

# tool
RAKE, CLEARANCE, FRICTION_TOOL, TIP_X, TIP_Y, SPEED, RAMP_TIME, FEEDBACK = 0, 1, 2, 3, 4, 5, 6, 7
TOOL = 8


@jit
def run_steps(
    steps,
    points,
    blocks,
    grids,
    extents,
    interface,
    tool,
    totals,
    material,
    cohesive,
    near,
    marked,
    closing,
    closing_normal,
    closing_slot,
    work,
    time_step,
    cell,
    origin_x,
    origin_y,
    count_x,
    count_y,
    last_clamped_row,
    mass_body,
    parity,
):
    """Advance the cut by a number of steps.

    Parameters
    ----------
    steps : int
        Number of steps.
    points : float array
        Fields of all points in blocks; modified in place.
    blocks : int array, shape (2, 2)
        First block of each body and first block after it.
    grids : float array, shape (2, 2, n_nodes * NODE)
        Two grids of each body, used in turns; the current one holds mass, momentum and force of the points.
    extents : int array, shape (2, 2, 4)
        Columns and rows in use of each grid.
    interface : float array, shape (INTERFACE_ROWS, n_pairs)
        Cohesive pairs; modified in place.
    tool : float array, shape (TOOL,)
        Angles, friction, tip, final speed, ramp time, feedback gain; the tip is moved.
    totals : float array, shape (TOTALS,)
        Sums since the start; modified in place.
    material : float array, shape (5,)
        See `advance_points`.
    cohesive : float array, shape (2,)
        Cohesive stress [Pa], critical opening [m].
    near, marked, closing, closing_normal, closing_slot, work
        Work space.
    time_step, cell : float
        Time step [s] and cell size [m].
    origin_x, origin_y : float
        Position of node (0, 0) [m].
    count_x, count_y : int
        Nodes in each direction.
    last_clamped_row : int
        Rows of the base up to this one are clamped.
    mass_body : float
        Mass of all points [kg/m].
    parity : int
        Which of the two grids is current, 0 or 1.

    Returns
    -------
    int
        The grid that is current afterwards.
    """
    inv_cell = 1.0 / cell
    half_width = 0.25 * cell
    area = 0.5 * cell
    mass_small = 1e-9 * material[4] * cell * cell
    near_counts = (0, 0)
    near_tip = math.inf
    for _ in range(steps):
        speed = tool[SPEED] * min(totals[TIME] / tool[RAMP_TIME], 1.0)
        ramping = totals[TIME] < tool[RAMP_TIME]
        chip, base = grids[CHIP, parity], grids[BASE, parity]
        # points that may touch the tool, listed anew when it has moved a quarter of a cell
        if near_tip - tool[TIP_X] > 0.25 * cell:
            near_tip = tool[TIP_X]
            near_chip = list_near_points(
                near[CHIP],
                points,
                blocks[CHIP],
                CHIP,
                tool[RAKE],
                tool[CLEARANCE],
                tool[TIP_X],
                tool[TIP_Y],
                2.0 * cell,
            )
            near_base = list_near_points(
                near[BASE],
                points,
                blocks[BASE],
                BASE,
                tool[RAKE],
                tool[CLEARANCE],
                tool[TIP_X],
                tool[TIP_Y],
                2.0 * cell,
            )
            near_counts = (near_chip, near_base)
        # cohesive tractions
        set_normals(interface)
        closed = pull_together(
            interface,
            chip,
            base,
            closing,
            closing_normal,
            closing_slot,
            area,
            cohesive[0],
            cohesive[1],
            totals[TIME],
            origin_x,
            origin_y,
            inv_cell,
            count_x,
        )
        # momentum
        kinetic_old = kinetic_new = 0.0
        for body in (CHIP, BASE):
            clamped_row = last_clamped_row if body == BASE else -1
            before, after, damped, clamp_x, clamp_y = update_grid(
                grids[body, parity],
                extents[body, parity],
                count_x,
                clamped_row,
                mass_small,
                time_step,
                totals[DAMPING] if ramping else 0.0,
            )
            kinetic_old += before
            kinetic_new += after
            totals[DAMPED] += damped
            totals[CLAMP_X] += clamp_x
            totals[CLAMP_Y] += clamp_y
        if ramping:
            totals[DAMPING] += 2.0 * time_step * tool[FEEDBACK] * kinetic_old / mass_body
        # contact
        change, lost = push_apart(chip, base, closing, closing_normal, closed, mass_small)
        totals[IMPACT] += lost
        kinetic_new += change
        for body in (CHIP, BASE):
            grid = grids[body, parity]
            count = mark_contact_nodes(
                marked,
                grid,
                points,
                near[body],
                near_counts[body],
                body,
                tool,
                half_width,
                origin_x,
                origin_y,
                inv_cell,
                count_x,
                count_y,
            )
            impulse_x, impulse_y, change, impact, friction = push_with_tool(
                grid, marked, count, body, tool, speed, mass_small
            )
            totals[CHIP_X + 2 * body] += impulse_x
            totals[CHIP_Y + 2 * body] += impulse_y
            totals[WORK] -= impulse_x * speed
            totals[IMPACT] += impact
            totals[FRICTION] += friction
            kinetic_new += change
        # everything moves
        totals[COHESIVE] += move_pairs(interface, chip, base, time_step, area, origin_x, origin_y, inv_cell, count_x)
        kinetic = 0.0
        for body in (CHIP, BASE):
            clear_grid(grids[body, 1 - parity], extents[body, 1 - parity], count_x)
            kinetic += advance_points(
                points,
                blocks[body],
                grids[body, parity],
                grids[body, 1 - parity],
                work,
                extents[body, 1 - parity],
                material,
                time_step,
                origin_x,
                origin_y,
                inv_cell,
                count_x,
                count_y,
            )
        totals[NUMERICAL] += totals[KINETIC] - kinetic_old + kinetic_new - kinetic
        totals[KINETIC] = kinetic
        tool[TIP_X] -= time_step * speed
        totals[TIME] += time_step
        parity = 1 - parity
    return parity
