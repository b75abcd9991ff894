"""One pass over the material points: grid to point, constitutive update, point to the next grid.

Velocities are taken from the grid whole (PIC), and positions and deformations move with that same field: x += v dt,
F <- (1 + dt grad v) F. This pair is consistent for a loop that does not extrapolate velocities twice a step; other pairs let
points drift away from their deformation gradients.
"""

import math

from orthocut.kernels.jit import jit
from orthocut.kernels.laws.neo_hookean_j2 import energy_elastic, energy_plastic, pressure_kirchhoff, update
from orthocut.kernels.mpm.layout import (
    BLOCK,
    BXX,
    BXY,
    BYY,
    EPS,
    FXX,
    FXY,
    FYX,
    FYY,
    LANES,
    MASS,
    NFX,
    NFY,
    NM,
    NODE,
    NPX,
    NPY,
    NVX,
    NVY,
    POINT_FIELDS,
    VX,
    VY,
    X,
    Y,
)
from orthocut.kernels.mpm.shape import gimp_weights, nearest_node

# A block is copied to a work array that holds, behind the fields, what lives only within the pass: with one array and
# constant offsets LLVM needs no alias checks and vectorises the loops over lanes.
_WX, _GX, _WY, _GY = POINT_FIELDS, POINT_FIELDS + 3, POINT_FIELDS + 6, POINT_FIELDS + 9
_CORNER = POINT_FIELDS + 12
_DXX, _DXY, _DYX, _DYY = POINT_FIELDS + 13, POINT_FIELDS + 14, POINT_FIELDS + 15, POINT_FIELDS + 16
_TXX, _TYY, _TXY = POINT_FIELDS + 17, POINT_FIELDS + 18, POINT_FIELDS + 19
WORK = (POINT_FIELDS + 20) * LANES


@jit
def weigh_lanes(work, origin_x, origin_y, inv_cell, count_x, count_y):
    """Shape functions of each lane and the lower left of its 3 x 3 nodes."""
    for lane in range(LANES):
        x = (work[X * LANES + lane] - origin_x) * inv_cell
        y = (work[Y * LANES + lane] - origin_y) * inv_cell
        i = nearest_node(x, count_x)
        j = nearest_node(y, count_y)
        w0, w1, w2, g0, g1, g2 = gimp_weights(x - i)
        work[_WX * LANES + lane] = w0
        work[(_WX + 1) * LANES + lane] = w1
        work[(_WX + 2) * LANES + lane] = w2
        work[_GX * LANES + lane] = g0
        work[(_GX + 1) * LANES + lane] = g1
        work[(_GX + 2) * LANES + lane] = g2
        w0, w1, w2, g0, g1, g2 = gimp_weights(y - j)
        work[_WY * LANES + lane] = w0
        work[(_WY + 1) * LANES + lane] = w1
        work[(_WY + 2) * LANES + lane] = w2
        work[_GY * LANES + lane] = g0
        work[(_GY + 1) * LANES + lane] = g1
        work[(_GY + 2) * LANES + lane] = g2
        work[_CORNER * LANES + lane] = (j - 1.0) * count_x + (i - 1.0)


@jit
def gather_lanes(work, grid, count_x):
    """Velocity and velocity gradient (times cell size) of each lane from the 3 x 3 nodes around it."""
    for lane in range(LANES):
        row = int(work[_CORNER * LANES + lane]) * NODE
        wx0, wx1, wx2 = work[_WX * LANES + lane], work[(_WX + 1) * LANES + lane], work[(_WX + 2) * LANES + lane]
        gx0, gx1, gx2 = work[_GX * LANES + lane], work[(_GX + 1) * LANES + lane], work[(_GX + 2) * LANES + lane]
        vx = vy = dxx = dxy = dyx = dyy = 0.0
        for k in range(3):
            at = row + k * count_x * NODE
            ux0, uy0 = grid[at + NVX], grid[at + NVY]
            ux1, uy1 = grid[at + NODE + NVX], grid[at + NODE + NVY]
            ux2, uy2 = grid[at + 2 * NODE + NVX], grid[at + 2 * NODE + NVY]
            sx = wx0 * ux0 + wx1 * ux1 + wx2 * ux2
            sy = wx0 * uy0 + wx1 * uy1 + wx2 * uy2
            wy = work[(_WY + k) * LANES + lane]
            gy = work[(_GY + k) * LANES + lane]
            vx += wy * sx
            vy += wy * sy
            dxy += gy * sx
            dyy += gy * sy
            dxx += wy * (gx0 * ux0 + gx1 * ux1 + gx2 * ux2)
            dyx += wy * (gx0 * uy0 + gx1 * uy1 + gx2 * uy2)
        work[VX * LANES + lane] = vx
        work[VY * LANES + lane] = vy
        work[_DXX * LANES + lane] = dxx
        work[_DXY * LANES + lane] = dxy
        work[_DYX * LANES + lane] = dyx
        work[_DYY * LANES + lane] = dyy


@jit
def update_lanes(work, material, time_step, inv_cell):
    """Move each lane and update deformation, state and Kirchhoff stress (times initial volume over cell size)."""
    modulus_bulk, modulus_shear = material[0], material[1]
    stress_yield, modulus_plastic = material[2], material[3]
    rate = time_step * inv_cell
    volume_of_mass = inv_cell / material[4]
    for lane in range(LANES):
        work[X * LANES + lane] += time_step * work[VX * LANES + lane]
        work[Y * LANES + lane] += time_step * work[VY * LANES + lane]
        dxx = 1.0 + rate * work[_DXX * LANES + lane]
        dxy = rate * work[_DXY * LANES + lane]
        dyx = rate * work[_DYX * LANES + lane]
        dyy = 1.0 + rate * work[_DYY * LANES + lane]
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
            stress_yield,
            modulus_plastic,
        )
        work[BXX * LANES + lane] = bxx
        work[BYY * LANES + lane] = byy
        work[BXY * LANES + lane] = bxy
        work[EPS * LANES + lane] = strain_plastic
        pressure = pressure_kirchhoff(hxx * hyy - hxy * hyx, modulus_bulk)
        volume = work[MASS * LANES + lane] * volume_of_mass
        work[_TXX * LANES + lane] = volume * (sxx + pressure)
        work[_TYY * LANES + lane] = volume * (syy + pressure)
        work[_TXY * LANES + lane] = volume * sxy


@jit
def scatter_lanes(work, grid, count_x):
    """Add mass, momentum and internal force of each lane to the 3 x 3 nodes around it."""
    for lane in range(LANES):
        mass = work[MASS * LANES + lane]
        vx, vy = work[VX * LANES + lane], work[VY * LANES + lane]
        txx, tyy, txy = work[_TXX * LANES + lane], work[_TYY * LANES + lane], work[_TXY * LANES + lane]
        row = int(work[_CORNER * LANES + lane]) * NODE
        for k in range(3):
            wy = work[(_WY + k) * LANES + lane]
            gy = work[(_GY + k) * LANES + lane]
            for c in range(3):
                at = row + (k * count_x + c) * NODE
                wx = work[(_WX + c) * LANES + lane]
                slope_x = work[(_GX + c) * LANES + lane] * wy
                slope_y = wx * gy
                m = mass * wy * wx
                grid[at + NM] += m
                grid[at + NPX] += m * vx
                grid[at + NPY] += m * vy
                grid[at + NFX] -= txx * slope_x + txy * slope_y
                grid[at + NFY] -= txy * slope_x + tyy * slope_y


@jit
def advance_points(
    points, blocks, grid, grid_next, work, extent, material, time_step, origin_x, origin_y, inv_cell, count_x, count_y
):
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
    material : float array, shape (5,)
        Bulk modulus, shear modulus, yield stress, plastic modulus [Pa], density [kg/m^3].
    time_step : float
        Time step [s].
    origin_x, origin_y : float
        Position of node (0, 0) [m].
    inv_cell : float
        One over the cell size [1/m].
    count_x, count_y : int
        Number of nodes in each direction.

    Returns
    -------
    float
        Kinetic energy of the points [J/m].
    """
    kinetic = 0.0
    low_x, high_x, low_y, high_y = math.inf, -math.inf, math.inf, -math.inf
    for block in range(blocks[0], blocks[1]):
        start = block * BLOCK
        work[:BLOCK] = points[start : start + BLOCK]
        weigh_lanes(work, origin_x, origin_y, inv_cell, count_x, count_y)
        gather_lanes(work, grid, count_x)
        update_lanes(work, material, time_step, inv_cell)
        weigh_lanes(work, origin_x, origin_y, inv_cell, count_x, count_y)
        scatter_lanes(work, grid_next, count_x)
        points[start : start + BLOCK] = work[:BLOCK]
        for lane in range(LANES):
            vx, vy = work[VX * LANES + lane], work[VY * LANES + lane]
            kinetic += 0.5 * work[MASS * LANES + lane] * (vx * vx + vy * vy)
            low_x = min(low_x, work[X * LANES + lane])
            high_x = max(high_x, work[X * LANES + lane])
            low_y = min(low_y, work[Y * LANES + lane])
            high_y = max(high_y, work[Y * LANES + lane])
    extent[0] = int(nearest_node((low_x - origin_x) * inv_cell, count_x)) - 1
    extent[1] = int(nearest_node((high_x - origin_x) * inv_cell, count_x)) + 1
    extent[2] = int(nearest_node((low_y - origin_y) * inv_cell, count_y)) - 1
    extent[3] = int(nearest_node((high_y - origin_y) * inv_cell, count_y)) + 1
    return kinetic


@jit
def sum_energies(points, block_count, material):
    """Elastic energy, plastic work and kinetic energy of all points [J/m]."""
    modulus_bulk, modulus_shear, stress_yield, modulus_plastic, density = (
        material[0],
        material[1],
        material[2],
        material[3],
        material[4],
    )
    elastic = plastic = kinetic = 0.0
    for block in range(block_count):
        start = block * BLOCK
        for lane in range(LANES):
            mass = points[start + MASS * LANES + lane]
            if mass == 0.0:
                continue
            at = start + lane
            bxx, byy, bxy = points[at + BXX * LANES], points[at + BYY * LANES], points[at + BXY * LANES]
            trace = bxx + byy + 1.0 / (bxx * byy - bxy * bxy)
            volume_ratio = (
                points[at + FXX * LANES] * points[at + FYY * LANES]
                - points[at + FXY * LANES] * points[at + FYX * LANES]
            )
            volume = mass / density
            vx, vy = points[at + VX * LANES], points[at + VY * LANES]
            elastic += volume * energy_elastic(volume_ratio, trace, modulus_bulk, modulus_shear)
            plastic += volume * energy_plastic(points[at + EPS * LANES], stress_yield, modulus_plastic)
            kinetic += 0.5 * mass * (vx * vx + vy * vy)
    return elastic, plastic, kinetic
