"""Passes over the material points in the loop of `usavg`.

All passes of a step use the weights of the positions at its start; the last one moves the points.
"""

import math

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.layout import (
    BLOCK,
    CORNER,
    HX,
    LANES,
    MASS,
    UX,
    VX,
    VY,
    X,
    Y,
)
from orthocut.kernels.mpm.points import deform_lanes, set_extent, weigh_lanes
from orthocut.kernels.mpm.transfers import gather_point, scatter_force_point, scatter_momentum_point


@part
def load_points(points, blocks, grid, grid_next, work, solid, frame):
    """First half of the update of deformations and stresses, and internal forces.

    Parameters
    ----------
    points : float array
        Fields of all points in blocks, see `layout`; modified in place.
    blocks : int array, shape (2,)
        First block of the body and first block after it.
    grid : float array, shape (count_y * count_x * NODE,)
        Nodes of the body with the velocities that the points deform with [m/s].
    grid_next : float array, same shape
        Receives the internal forces.
    work : float array, shape (WORK,)
        Work space.
    solid : Solid
        Material.
    frame : Frame
        Grid and time step.
    """
    body = points[blocks[0] * BLOCK : blocks[1] * BLOCK]
    for block in range(body.size // BLOCK):
        start = block * BLOCK
        for k in range(BLOCK):
            work[k] = body[start + k]
        weigh_lanes(work, frame)
        for lane in range(LANES):
            gather_point(grid, int(work[CORNER * LANES + lane]), frame.count_x, work, lane)
        deform_lanes(work, solid, frame, 0.5 * frame.time_step)
        for lane in range(LANES):
            scatter_force_point(grid_next, int(work[CORNER * LANES + lane]), frame.count_x, work, lane)
        for k in range(2 * LANES):  # the velocities are still those before the step
            work[VX * LANES + k] = body[start + VX * LANES + k]
        for k in range(BLOCK):
            body[start + k] = work[k]


@part
def accelerate_points(points, blocks, moves, grid, grid_next, work, usavg, frame):
    """New velocities of the points and their displacements, Nairn (2015), eqs (8) to (10).

    With the velocities before and after the update of the grid at the point, V0 and V1, and its own velocity v before
    the update, the velocity changes by (V1 - V0) - (1 - flip)(v - V0), and the displacement is

        order 0, eq (9):                                dt V1
        order 1, eq (10) without the acceleration:      dt V1 - dt/2 (1 - flip)(v - V0)
        order 2, eq (10):                               dt V1 - dt/2 [(V1 - V0) + (1 - flip)(v - V0)]

    Parameters
    ----------
    points, blocks, work, frame
        See `load_points`.
    moves : float array, shape (n_blocks * 2 * LANES,)
        Receives the displacements [m].
    grid : float array
        Nodes of the body with their velocities after the update.
    grid_next : float array
        Nodes with the velocities before the update; receive the new mass and momentum of the points.
    usavg : Usavg
        Choices of the loop.
    """
    time_step, damped = frame.time_step, 1.0 - usavg.flip
    by_acceleration = 0.5 * time_step if usavg.position_order == 2 else 0.0
    by_damping = 0.5 * time_step * damped if usavg.position_order > 0 else 0.0
    body = points[blocks[0] * BLOCK : blocks[1] * BLOCK]
    body_moves = moves[blocks[0] * 2 * LANES : blocks[1] * 2 * LANES]
    for block in range(body.size // BLOCK):
        start = block * BLOCK
        for k in range(BLOCK):
            work[k] = body[start + k]
        weigh_lanes(work, frame)
        for k in range(2 * LANES):
            work[UX * LANES + k] = work[VX * LANES + k]
        for lane in range(LANES):
            gather_point(grid_next, int(work[CORNER * LANES + lane]), frame.count_x, work, lane)
        for k in range(2 * LANES):
            work[HX * LANES + k] = work[VX * LANES + k]
        for lane in range(LANES):
            gather_point(grid, int(work[CORNER * LANES + lane]), frame.count_x, work, lane)
        for k in range(2 * LANES):
            own, before, after = work[UX * LANES + k], work[HX * LANES + k], work[VX * LANES + k]
            work[VX * LANES + k] = own + (after - before) - damped * (own - before)
            work[UX * LANES + k] = time_step * after - by_acceleration * (after - before) - by_damping * (own - before)
        for lane in range(LANES):
            scatter_momentum_point(grid_next, int(work[CORNER * LANES + lane]), frame.count_x, work, lane)
        for k in range(2 * LANES):
            body[start + VX * LANES + k] = work[VX * LANES + k]
            body_moves[block * 2 * LANES + k] = work[UX * LANES + k]


@part
def settle_points(points, blocks, moves, grid, grid_next, work, extent, solid, frame):
    """Second half of the update of deformations and stresses; move the points and fill the grid of the next step.

    Parameters
    ----------
    points, blocks, moves, work, solid, frame
        See `load_points` and `accelerate_points`.
    grid : float array
        Nodes of the body with the velocities that the points deform with [m/s].
    grid_next : float array
        Cleared nodes; receive mass and momentum of the next step.
    extent : int array, shape (4,)
        Nodes that the body then reaches: first and last column, first and last row; set here.

    Returns
    -------
    float
        Kinetic energy of the points [J/m].
    """
    kinetic = 0.0
    low_x, high_x, low_y, high_y = math.inf, -math.inf, math.inf, -math.inf
    body = points[blocks[0] * BLOCK : blocks[1] * BLOCK]
    body_moves = moves[blocks[0] * 2 * LANES : blocks[1] * 2 * LANES]
    for block in range(body.size // BLOCK):
        start = block * BLOCK
        for k in range(BLOCK):
            work[k] = body[start + k]
        weigh_lanes(work, frame)
        for lane in range(LANES):
            gather_point(grid, int(work[CORNER * LANES + lane]), frame.count_x, work, lane)
        deform_lanes(work, solid, frame, 0.5 * frame.time_step)
        for k in range(2 * LANES):
            work[VX * LANES + k] = body[start + VX * LANES + k]
            work[X * LANES + k] += body_moves[block * 2 * LANES + k]
        weigh_lanes(work, frame)
        for lane in range(LANES):
            scatter_momentum_point(grid_next, int(work[CORNER * LANES + lane]), frame.count_x, work, lane)
        for k in range(BLOCK):
            body[start + k] = work[k]
        for lane in range(LANES):
            vx, vy = work[VX * LANES + lane], work[VY * LANES + lane]
            kinetic += 0.5 * work[MASS * LANES + lane] * (vx * vx + vy * vy)
            low_x = min(low_x, work[X * LANES + lane])
            high_x = max(high_x, work[X * LANES + lane])
            low_y = min(low_y, work[Y * LANES + lane])
            high_y = max(high_y, work[Y * LANES + lane])
    set_extent(extent, low_x, high_x, low_y, high_y, frame)
    return kinetic
