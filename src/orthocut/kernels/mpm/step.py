"""The order of one time step, for many steps without returning to Python.

Update stress last, extrapolate velocities once: forces and momenta on the grid give new velocities; contact acts on
these, and loose nodes follow; points, deformations, interface and tool all move with them.
"""

import math

from orthocut.kernels.jit import jit
from orthocut.kernels.mpm.contact import push_with_tool
from orthocut.kernels.mpm.contact_cells import remove_tool
from orthocut.kernels.mpm.contact_search import RELIST, list_near, mark_touching, place_tool
from orthocut.kernels.mpm.grid import clear_grid, join_bodies, update_grid, work_of_forces
from orthocut.kernels.mpm.interface import UPPER_X, lost_in_closing, move_pairs, pull_together, push_apart, set_normals
from orthocut.kernels.mpm.layout import BASE, CHIP
from orthocut.kernels.mpm.points import advance_points
from orthocut.kernels.mpm.rest import PAIRS, rest_behind, wake_ahead
from orthocut.kernels.mpm.support import follow_firm_nodes, lean_on_firm_nodes, work_of_loose_forces

# totals since the start
CHIP_X, CHIP_Y, BASE_X, BASE_Y = 0, 1, 2, 3  # impulse of the tool on each body [N s/m]
CLAMP_X, CLAMP_Y = 4, 5  # impulse of the clamp [N s/m]
WORK, FRICTION, IMPACT, NUMERICAL, DAMPED, COHESIVE = 6, 7, 8, 9, 10, 11  # energies [J/m]
# values now
KINETIC = 12  # kinetic energy of the points [J/m]
TIME = 13  # [s]
DAMPING = 14  # rate of the feedback damping [1/s]
TIP = 15  # place of the tool tip along the cut [m]
RESTED = 16  # place of the tool tip when material far from it was last put to rest [m]
TOTALS = 17


@jit
def run_steps(
    steps,
    points,
    blocks,
    awake,
    free,
    grids,
    extents,
    current,
    interface,
    totals,
    solid,
    cohesion,
    wedge,
    frame,
    space,
    mass_body,
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
    awake : int array, shape (AWAKE, 2)
        First block of each body that is awake and first one after those; first pair and number of pairs.
    free : int array, shape (2, 4)
        First and last column, first and last row of the nodes of each body that are not held.
    grids : float array, shape (2, 2, n_nodes * NODE)
        Two grids of each body, used in turns; the current one holds mass, momentum and force of the points.
    extents : int array, shape (2, 2, 4)
        Columns and rows in use of each grid.
    current : int
        Which of the two grids is current, 0 or 1.
    interface : float array, shape (INTERFACE_ROWS, n_pairs)
        Cohesive pairs; modified in place.
    totals : float array, shape (TOTALS,)
        Impulses and energies since the start, time, tool; modified in place.
    solid, cohesion, wedge, frame
        Constants, see `orthocut.kernels.mpm.frame`.
    space : Workspace
        Work space.
    mass_body : float
        Mass of all points [kg/m].

    Returns
    -------
    int
        The grid that is current afterwards.
    """
    near_chip = near_base = 0
    listed_at = math.inf
    for _ in range(steps):
        ramping = totals[TIME] < wedge.ramp_time
        speed = wedge.speed * min(totals[TIME] / wedge.ramp_time, 1.0)
        chip, base = grids[CHIP, current], grids[BASE, current]
        if listed_at - totals[TIP] > RELIST * frame.cell:
            listed_at = totals[TIP]
            near_chip, near_base = list_near(points, awake, wedge, listed_at, frame, space)

        set_normals(interface, awake[PAIRS, 0])
        closed = pull_together(
            interface,
            awake[PAIRS, 0],
            chip,
            base,
            space.closing,
            space.closing_normal,
            space.closing_slot,
            cohesion,
            totals[TIME],
            totals[TIP],
            frame,
        )
        kinetic_old = work = 0.0
        loose_chip = loose_base = 0
        for body in (CHIP, BASE):
            grid, extent = grids[body, current], extents[body, current]
            loose, weights = space.loose[body], space.loose_weights[body]
            count = 0
            if frame.mass_firm > 0.0:
                count = lean_on_firm_nodes(grid, extent, loose, weights, frame, free[body])
            before, damped, clamp_x, clamp_y = update_grid(
                grid, extent, frame, free[body], totals[DAMPING] if ramping else 0.0
            )
            if body == CHIP:
                loose_chip = count
            else:
                loose_base = count
            kinetic_old += before
            work -= damped
            totals[DAMPED] += damped
            totals[CLAMP_X] += clamp_x
            totals[CLAMP_Y] += clamp_y
        if ramping:
            totals[DAMPING] += 2.0 * frame.time_step * wedge.feedback * kinetic_old / mass_body

        if frame.last_whole_column >= 0:
            lost = join_bodies(chip, base, extents[CHIP, current], frame)
            work -= lost
            totals[IMPACT] += lost
        push_apart(chip, base, space.closing, space.closing_normal, space.closing_impulse, closed, frame)
        seen = place_tool(extents[CHIP, current], extents[BASE, current], wedge, totals[TIP], frame, space)
        for body in (CHIP, BASE):
            near = near_chip if body == CHIP else near_base
            count = mark_touching(points, near, seen, body, wedge, totals[TIP], frame, space)
            impulse_x, impulse_y, impact, friction = push_with_tool(
                grids[body, current], space.marked[body], count, body, wedge, speed, frame
            )
            work -= impulse_x * speed + impact + friction
            totals[CHIP_X + 2 * body] += impulse_x
            totals[CHIP_Y + 2 * body] += impulse_y
            totals[WORK] -= impulse_x * speed
            totals[IMPACT] += impact
            totals[FRICTION] += friction
        lost = lost_in_closing(chip, base, space.closing, space.closing_impulse, closed)
        work -= lost
        totals[IMPACT] += lost
        remove_tool(space.tool_sums, space.tool_nodes, seen)
        for body in (CHIP, BASE):
            grid, grid_before = grids[body, current], grids[body, 1 - current]
            loose, weights = space.loose[body], space.loose_weights[body]
            count = loose_chip if body == CHIP else loose_base
            follow_firm_nodes(grid, loose, weights, count, frame)
            work += work_of_forces(grid, grid_before, extents[body, current], frame)
            work += work_of_loose_forces(grid, grid_before, loose, weights, count, frame)

        totals[COHESIVE] += move_pairs(interface, awake[PAIRS, 0], chip, base, frame)
        tip = totals[TIP]
        passed = totals[RESTED] - tip > frame.cell
        if passed:
            totals[RESTED] = tip
            wake_ahead(points, blocks, awake, tip, frame)
        kinetic = 0.0
        for body in (CHIP, BASE):
            clear_grid(grids[body, 1 - current], extents[body, 1 - current], frame)
            kinetic += advance_points(
                points,
                awake[body],
                grids[body, current],
                grids[body, 1 - current],
                space.lanes,
                extents[body, 1 - current],
                solid,
                frame,
                frame.time_step,
            )
        if passed:
            rest_behind(points, blocks, interface[UPPER_X], awake, free, tip, frame)
        totals[NUMERICAL] += totals[KINETIC] - kinetic + work
        totals[KINETIC] = kinetic
        totals[TIP] -= frame.time_step * speed
        totals[TIME] += frame.time_step
        current = 1 - current
    return current
