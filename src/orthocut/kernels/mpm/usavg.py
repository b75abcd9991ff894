"""The order of one time step in the program of Nairn (2015): update stress on average, extrapolate velocities again.

Three contact passes a step, each on a grid of its own, all with the weights of the positions at its start:

1. mass and momentum of the points; these velocities drive the first half of the update of stresses and nothing else;
2. momentum before contact, and forces; the tool's forces are those of this pass;
3. momentum of the updated points; these velocities drive the second half of the update of stresses.

The interface moves with the third velocities at the end of the step, so that tractions and motion make a stable pair:
with the mean of the first and the third, the field that deforms the points, tractions of the start of the step feed
vibrations of the interface.
"""

import math

from orthocut.kernels.jit import jit, part
from orthocut.kernels.mpm.contact import push_with_tool
from orthocut.kernels.mpm.contact_cells import remove_tool
from orthocut.kernels.mpm.contact_search import RELIST, list_near, mark_touching, place_tool
from orthocut.kernels.mpm.grid import clear_grid, join_bodies, update_grid
from orthocut.kernels.mpm.interface import lost_in_closing, move_pairs, pull_together, push_apart, set_normals
from orthocut.kernels.mpm.layout import BASE, CHIP
from orthocut.kernels.mpm.step import (
    BASE_X,
    BASE_Y,
    CHIP_X,
    CHIP_Y,
    CLAMP_X,
    CLAMP_Y,
    COHESIVE,
    DAMPED,
    DAMPING,
    FRICTION,
    IMPACT,
    KINETIC,
    NUMERICAL,
    TIME,
    TIP,
    WORK,
)
from orthocut.kernels.mpm.usavg_grid import copy_loads, set_velocities, work_of_stresses
from orthocut.kernels.mpm.usavg_points import accelerate_points, load_points, settle_points

FIRST, SECOND, THIRD = 0, 1, 2
"""Grids of a body, by contact pass. Between steps the first one holds mass and momentum, the others are zero."""


@part
def touch(chip, base, extent, closed, touching_chip, touching_base, wedge, speed, frame, space):
    """Contact of a pass, closing interface and tool; return what the interface loses and what `push_with_tool` does."""
    joined = 0.0
    if frame.last_whole_column >= 0:
        joined = join_bodies(chip, base, extent, frame)
    push_apart(chip, base, space.closing, space.closing_normal, space.closing_impulse, closed, frame)
    on_chip = push_with_tool(chip, space.marked[CHIP], touching_chip, CHIP, wedge, speed, frame)
    on_base = push_with_tool(base, space.marked[BASE], touching_base, BASE, wedge, speed, frame)
    lost = joined + lost_in_closing(chip, base, space.closing, space.closing_impulse, closed)
    return lost, on_chip, on_base


@jit
def run_steps_usavg(
    steps,
    points,
    blocks,
    free,
    grids,
    extents,
    interface,
    totals,
    usavg,
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
    steps, points, blocks, free, interface, totals, solid, cohesion, wedge, frame, space, mass_body
        See `orthocut.kernels.mpm.step.run_steps`.
    grids : float array, shape (2, 3, n_nodes * NODE)
        Three grids of each body.
    extents : int array, shape (2, 2, 4)
        Columns and rows in use of the grids of each body; the second row is work space.
    usavg : Usavg
        Choices of the loop.
    """
    near_chip = near_base = 0
    listed_at = math.inf
    for _ in range(steps):
        ramping = totals[TIME] < wedge.ramp_time
        speed = wedge.speed * min(totals[TIME] / wedge.ramp_time, 1.0)
        tip = totals[TIP]
        if listed_at - tip > RELIST * frame.cell:
            listed_at = tip
            near_chip, near_base = list_near(points, blocks, wedge, tip, frame, space)
        seen = place_tool(extents[CHIP, 0], extents[BASE, 0], wedge, tip, frame, space)
        on_chip = mark_touching(points, near_chip, seen, CHIP, wedge, tip, frame, space)
        on_base = mark_touching(points, near_base, seen, BASE, wedge, tip, frame, space)
        remove_tool(space.tool_sums, space.tool_nodes, seen)
        set_normals(interface, 0)
        closed = pull_together(
            interface,
            0,
            grids[CHIP, FIRST],
            grids[BASE, FIRST],
            space.closing,
            space.closing_normal,
            space.closing_slot,
            cohesion,
            totals[TIME],
            tip,
            frame,
        )

        for body in (CHIP, BASE):
            grid = grids[body, FIRST]
            set_velocities(grid, grid, extents[body, 0], frame, free[body])
        touch(
            grids[CHIP, FIRST],
            grids[BASE, FIRST],
            extents[CHIP, 0],
            closed,
            on_chip,
            on_base,
            wedge,
            speed,
            frame,
            space,
        )
        kinetic_old = work = 0.0
        for body in (CHIP, BASE):
            grid = grids[body, SECOND]
            copy_loads(grids[body, FIRST], grid, extents[body, 0], frame)
            load_points(points, blocks[body], grids[body, FIRST], grid, space.lanes, solid, frame)
            before, damped, clamp_x, clamp_y = update_grid(
                grid, extents[body, 0], frame, free[body], totals[DAMPING] if ramping else 0.0, usavg.flip
            )
            kinetic_old += before
            work -= damped
            totals[DAMPED] += damped
            totals[CLAMP_X] += clamp_x
            totals[CLAMP_Y] += clamp_y
        if ramping:
            totals[DAMPING] += 2.0 * frame.time_step * wedge.feedback * kinetic_old / mass_body

        lost, chip, base = touch(
            grids[CHIP, SECOND],
            grids[BASE, SECOND],
            extents[CHIP, 0],
            closed,
            on_chip,
            on_base,
            wedge,
            speed,
            frame,
            space,
        )
        totals[CHIP_X] += chip[0]
        totals[CHIP_Y] += chip[1]
        totals[BASE_X] += base[0]
        totals[BASE_Y] += base[1]
        totals[WORK] -= (chip[0] + base[0]) * speed
        totals[IMPACT] += lost + chip[2] + base[2]
        totals[FRICTION] += chip[3] + base[3]
        work -= (chip[0] + base[0]) * speed + lost + chip[2] + base[2] + chip[3] + base[3]

        for body in (CHIP, BASE):
            grid = grids[body, THIRD]
            set_velocities(grids[body, FIRST], grid, extents[body, 0], frame, free[body])
            accelerate_points(points, blocks[body], space.moves, grids[body, SECOND], grid, space.lanes, usavg, frame)
            set_velocities(grid, grid, extents[body, 0], frame, free[body])
        touch(
            grids[CHIP, THIRD],
            grids[BASE, THIRD],
            extents[CHIP, 0],
            closed,
            on_chip,
            on_base,
            wedge,
            speed,
            frame,
            space,
        )
        for body in (CHIP, BASE):
            work += work_of_stresses(
                grids[body, FIRST], grids[body, SECOND], grids[body, THIRD], extents[body, 0], frame
            )
        opened = move_pairs(interface, 0, grids[CHIP, THIRD], grids[BASE, THIRD], frame)
        work -= opened
        totals[COHESIVE] += opened

        kinetic = 0.0
        for body in (CHIP, BASE):
            clear_grid(grids[body, FIRST], extents[body, 0], frame)
            kinetic += settle_points(
                points,
                blocks[body],
                space.moves,
                grids[body, THIRD],
                grids[body, FIRST],
                space.lanes,
                extents[body, 1],
                solid,
                frame,
            )
            for used in (SECOND, THIRD):
                clear_grid(grids[body, used], extents[body, 0], frame)
            for k in range(4):
                extents[body, 0, k] = extents[body, 1, k]
        totals[NUMERICAL] += totals[KINETIC] - kinetic + work
        totals[KINETIC] = kinetic
        totals[TIP] -= frame.time_step * speed
        totals[TIME] += frame.time_step
