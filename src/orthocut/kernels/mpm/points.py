"""One pass over the material points: grid to point, constitutive update, point to the next grid.

Velocities are taken from the grid whole, and positions and deformations move with that same field: x += v dt,
F <- (1 + dt grad v) F. This pair is consistent for a loop that does not extrapolate velocities twice a step; other
pairs let points drift away from their deformation gradients. On the way back a point hands on its velocity and a share
of the velocity gradient: none is PIC, which flattens every gradient a little in each step; all of it keeps linear
velocity fields, as APIC does (Jiang et al. 2015, ACM Trans. Graph. 34, 51), but also noise.
"""

import math

from orthocut.kernels.jit import jit, part
from orthocut.kernels.laws.hardening import energy_plastic
from orthocut.kernels.laws.neo_hookean_j2 import energy_elastic, pressure_kirchhoff, update
from orthocut.kernels.mpm.layout import (
    BLOCK,
    BXX,
    BXY,
    BYY,
    CORNER,
    DXX,
    DXY,
    DYX,
    DYY,
    EPS,
    FXX,
    FXY,
    FYX,
    FYY,
    GX,
    GY,
    LANES,
    MASS,
    RX,
    RY,
    TXX,
    TXY,
    TYY,
    VX,
    VY,
    WX,
    WY,
    X,
    Y,
)
from orthocut.kernels.mpm.shape import gimp_weights, nearest_node
from orthocut.kernels.mpm.transfers import gather_point, scatter_point


@part
def weigh_lanes(work, frame):
    """Shape functions of each lane and the lower left of its 3 x 3 nodes."""
    origin_x, origin_y, inv_cell = frame.origin_x, frame.origin_y, frame.inv_cell
    count_x, count_y, half = frame.count_x, frame.count_y, frame.half_point
    for lane in range(LANES):
        x = (work[X * LANES + lane] - origin_x) * inv_cell
        y = (work[Y * LANES + lane] - origin_y) * inv_cell
        i = nearest_node(x, count_x)
        j = nearest_node(y, count_y)
        w0, w1, w2, g0, g1, g2 = gimp_weights(x - i, half)
        work[WX * LANES + lane] = w0
        work[(WX + 1) * LANES + lane] = w1
        work[(WX + 2) * LANES + lane] = w2
        work[GX * LANES + lane] = g0
        work[(GX + 1) * LANES + lane] = g1
        work[(GX + 2) * LANES + lane] = g2
        w0, w1, w2, g0, g1, g2 = gimp_weights(y - j, half)
        work[WY * LANES + lane] = w0
        work[(WY + 1) * LANES + lane] = w1
        work[(WY + 2) * LANES + lane] = w2
        work[GY * LANES + lane] = g0
        work[(GY + 1) * LANES + lane] = g1
        work[(GY + 2) * LANES + lane] = g2
        work[RX * LANES + lane] = x - i
        work[RY * LANES + lane] = y - j
        work[CORNER * LANES + lane] = (j - 1.0) * count_x + (i - 1.0)


@part
def deform_lanes(work, solid, frame, time_step):
    """Update deformation, state and Kirchhoff stress (times initial volume over cell size) of each lane."""
    modulus_bulk, modulus_shear, hardening = solid.modulus_bulk, solid.modulus_shear, solid.hardening
    rate = time_step * frame.inv_cell
    volume_of_mass = frame.inv_cell / solid.density
    for lane in range(LANES):
        dxx = 1.0 + rate * work[DXX * LANES + lane]
        dxy = rate * work[DXY * LANES + lane]
        dyx = rate * work[DYX * LANES + lane]
        dyy = 1.0 + rate * work[DYY * LANES + lane]
        fxx, fxy = work[FXX * LANES + lane], work[FXY * LANES + lane]
        fyx, fyy = work[FYX * LANES + lane], work[FYY * LANES + lane]
        hxx = dxx * fxx + dxy * fyx
        hxy = dxx * fxy + dxy * fyy
        hyx = dyx * fxx + dyy * fyx
        hyy = dyx * fxy + dyy * fyy
        work[FXX * LANES + lane] = hxx
        work[FXY * LANES + lane] = hxy
        work[FYX * LANES + lane] = hyx
        work[FYY * LANES + lane] = hyy
        bxx, byy, bxy, strain_plastic, sxx, syy, sxy = update(
            work[BXX * LANES + lane],
            work[BYY * LANES + lane],
            work[BXY * LANES + lane],
            work[EPS * LANES + lane],
            dxx,
            dxy,
            dyx,
            dyy,
            modulus_shear,
            hardening,
        )
        work[BXX * LANES + lane] = bxx
        work[BYY * LANES + lane] = byy
        work[BXY * LANES + lane] = bxy
        work[EPS * LANES + lane] = strain_plastic
        pressure = pressure_kirchhoff(hxx * hyy - hxy * hyx, modulus_bulk)
        volume = work[MASS * LANES + lane] * volume_of_mass
        work[TXX * LANES + lane] = volume * (sxx + pressure)
        work[TYY * LANES + lane] = volume * (syy + pressure)
        work[TXY * LANES + lane] = volume * sxy


@part
def set_extent(extent, low_x, high_x, low_y, high_y, frame):
    """Set the first and last column, first and last row of the nodes that points between these bounds reach."""
    extent[0] = int(nearest_node((low_x - frame.origin_x) * frame.inv_cell, frame.count_x)) - 1
    extent[1] = int(nearest_node((high_x - frame.origin_x) * frame.inv_cell, frame.count_x)) + 1
    extent[2] = int(nearest_node((low_y - frame.origin_y) * frame.inv_cell, frame.count_y)) - 1
    extent[3] = int(nearest_node((high_y - frame.origin_y) * frame.inv_cell, frame.count_y)) + 1


@part
def advance_points(points, blocks, grid, grid_next, work, extent, solid, frame, time_step):
    """Carry the points of one body through a step.

    Parameters
    ----------
    points : float array
        Fields of all points in blocks, see `layout`; modified in place.
    blocks : int array, shape (2,)
        First block of the body and first block after it.
    grid : float array, shape (count_y * count_x * NODE,)
        Nodes of the body with their velocities at the end of the step [m/s].
    grid_next : float array, same shape
        Cleared nodes; receive mass, momentum and internal force of the next step.
    work : float array, shape (WORK,)
        Work space.
    extent : int array, shape (4,)
        Nodes that the body reaches: first and last column, first and last row; set here.
    solid : Solid
        Material.
    frame : Frame
        Grid.
    time_step : float
        Time step; zero fills the next grid from points at rest [s].

    Returns
    -------
    float
        Kinetic energy of the points [J/m].
    """
    kinetic = 0.0
    low_x, high_x, low_y, high_y = math.inf, -math.inf, math.inf, -math.inf
    body = points[blocks[0] * BLOCK : blocks[1] * BLOCK]
    for block in range(body.size // BLOCK):
        start = block * BLOCK  # counted from zero: numba sees that no index is negative, and the copies vectorise
        for k in range(BLOCK):
            work[k] = body[start + k]
        weigh_lanes(work, frame)
        for lane in range(LANES):
            gather_point(grid, int(work[CORNER * LANES + lane]), frame.count_x, work, lane)
        for lane in range(LANES):
            work[X * LANES + lane] += time_step * work[VX * LANES + lane]
            work[Y * LANES + lane] += time_step * work[VY * LANES + lane]
        deform_lanes(work, solid, frame, time_step)
        weigh_lanes(work, frame)
        for lane in range(LANES):
            scatter_point(grid_next, int(work[CORNER * LANES + lane]), frame.count_x, work, lane, frame.affine)
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


@jit
def sum_energies(points, solid):
    """Elastic energy, plastic work and kinetic energy of all points [J/m]."""
    elastic = plastic = kinetic = 0.0
    for block in range(points.size // BLOCK):
        for at in range(block * BLOCK, block * BLOCK + LANES):
            mass = points[at + MASS * LANES]
            if mass == 0.0:
                continue
            bxx, byy, bxy = points[at + BXX * LANES], points[at + BYY * LANES], points[at + BXY * LANES]
            fxx, fxy = points[at + FXX * LANES], points[at + FXY * LANES]
            fyx, fyy = points[at + FYX * LANES], points[at + FYY * LANES]
            vx, vy = points[at + VX * LANES], points[at + VY * LANES]
            trace = bxx + byy + 1.0 / (bxx * byy - bxy * bxy)
            volume = mass / solid.density
            elastic += volume * energy_elastic(fxx * fyy - fxy * fyx, trace, solid.modulus_bulk, solid.modulus_shear)
            plastic += volume * energy_plastic(solid.hardening, points[at + EPS * LANES])
            kinetic += 0.5 * mass * (vx * vx + vy * vy)
    return elastic, plastic, kinetic
