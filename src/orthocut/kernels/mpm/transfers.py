"""Gather and scatter of one point over its 3 x 3 nodes in vector registers.

LLVM does not find these vectors by itself: the quantities of a node stand side by side, but the loop runs over points.
Two intrinsics write the vector code once, for any instruction set. A point's shape functions are products, so nodes are
combined row by row: with weights w and slopes g in each direction and velocities v of row k and column c,

    velocity   = sum_k wy_k sum_c wx_c v_kc
    gradient x = sum_k wy_k sum_c gx_c v_kc
    gradient y = sum_k gy_k sum_c wx_c v_kc
"""

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from orthocut.kernels.mpm.layout import (
    DXX,
    DXY,
    DYX,
    DYY,
    GX,
    GY,
    LANES,
    MASS,
    NFX,
    NM,
    NODE,
    NVX,
    RX,
    RY,
    TXX,
    TXY,
    TYY,
    VX,
    VY,
    WX,
    WY,
)

_DOUBLE = ir.DoubleType()
_INT = ir.IntType(64)
_FAST = ("contract",)


def _vector(length):
    return ir.VectorType(_DOUBLE, length)


def _constant(index):
    return ir.Constant(ir.IntType(32), index)


class _Writer:
    """Writes the vector instructions of one transfer.

    Parameters
    ----------
    context, builder
        As numba hands them to the code generator of an intrinsic.
    signature : numba signature
        Types of grid, corner, count_x, work and lane.
    values : sequence
        Their values.
    """

    def __init__(self, context, builder, signature, values):
        grid, self.corner, self.count_x, work, self.lane = values
        self.builder = builder
        self.grid = context.make_array(signature.args[0])(context, builder, grid).data
        self.work = context.make_array(signature.args[3])(context, builder, work).data

    def field_pointer(self, row):
        """Address of a row of the work array at the lane."""
        at = self.builder.add(self.lane, ir.Constant(_INT, row * LANES))
        return self.builder.gep(self.work, [at])

    def field(self, row):
        """Value of a row of the work array at the lane."""
        return self.builder.load(self.field_pointer(row))

    def node_pointer(self, k, c, quantity, length):
        """Address of `length` quantities of node (row k, column c), as a vector."""
        b = self.builder
        node = b.add(self.corner, b.add(b.mul(self.count_x, ir.Constant(_INT, k)), ir.Constant(_INT, c)))
        at = b.add(b.mul(node, ir.Constant(_INT, NODE)), ir.Constant(_INT, quantity))
        return b.bitcast(b.gep(self.grid, [at]), _vector(length).as_pointer())

    def pack(self, *scalars):
        """Vector of scalars; None stands for zero."""
        vector = ir.Constant(_vector(len(scalars)), [0.0] * len(scalars))
        for index, scalar in enumerate(scalars):
            if scalar is not None:
                vector = self.builder.insert_element(vector, scalar, _constant(index))
        return vector

    def splat(self, scalar, length):
        """Vector of equal elements."""
        first = self.builder.insert_element(ir.Constant(_vector(length), ir.Undefined), scalar, _constant(0))
        mask = ir.Constant(ir.VectorType(ir.IntType(32), length), [0] * length)
        return self.builder.shuffle_vector(first, ir.Constant(_vector(length), ir.Undefined), mask)

    def times(self, a, b):
        """Product, which may contract with a sum."""
        return self.builder.fmul(a, b, flags=_FAST)

    def plus_times(self, total, a, b):
        """Sum of a total and a product."""
        product = self.times(a, b)
        return product if total is None else self.builder.fadd(total, product, flags=_FAST)


@intrinsic
def gather_point(typing_context, grid, corner, count_x, work, lane):
    """Velocity and its gradient at a point from its nodes, written to the rows VX, VY, DXX .. DYY of the work array.

    Parameters
    ----------
    grid : float array
        Nodes of a body.
    corner : int
        Index of the lower left of the 3 x 3 nodes.
    count_x : int
        Nodes in a row.
    work : float array
        Rows of LANES values, see `layout`.
    lane : int
        The point.
    """

    def generate(context, builder, signature, values):
        w = _Writer(context, builder, signature, values)
        twice = ir.Constant(ir.VectorType(ir.IntType(32), 4), [0, 1, 0, 1])
        columns = []
        for c in range(3):
            weight, slope = w.field(WX + c), w.field(GX + c)
            columns.append(w.pack(weight, weight, slope, slope))
        by_weight = by_slope = None
        for k in range(3):
            row = None
            for c in range(3):
                pair = builder.load(w.node_pointer(k, c, NVX, 2), align=8)
                row = w.plus_times(row, columns[c], builder.shuffle_vector(pair, pair, twice))
            by_weight = w.plus_times(by_weight, row, w.splat(w.field(WY + k), 4))
            by_slope = w.plus_times(by_slope, row, w.splat(w.field(GY + k), 4))
        for row, vector, index in (
            (VX, by_weight, 0),
            (VY, by_weight, 1),
            (DXX, by_weight, 2),
            (DYX, by_weight, 3),
            (DXY, by_slope, 0),
            (DYY, by_slope, 1),
        ):
            builder.store(builder.extract_element(vector, _constant(index)), w.field_pointer(row))
        return context.get_dummy_value()

    return types.void(grid, types.int64, types.int64, work, types.int64), generate


@intrinsic
def scatter_point(typing_context, grid, corner, count_x, work, lane, affine):
    """Add mass, momentum and internal force of a point to its nodes.

    A point at p hands the momentum of the velocity v + affine * (grad v) (x - p) to the node at x. The other parameters
    are those of `gather_point`.
    """

    def generate(context, builder, signature, values):
        w = _Writer(context, builder, signature, values[:5])
        share = values[5]
        mass, vx, vy = w.field(MASS), w.field(VX), w.field(VY)
        txx, txy, tyy = (builder.fneg(w.field(row)) for row in (TXX, TXY, TYY))
        carried = builder.fmul(mass, share)
        dxx, dxy, dyx, dyy = (builder.fmul(carried, w.field(row)) for row in (DXX, DXY, DYX, DYY))
        centre = w.pack(mass, builder.fmul(mass, vx), builder.fmul(mass, vy), None)
        by_x, by_y = w.pack(None, dxx, dyx, None), w.pack(None, dxy, dyy, None)
        force_x, force_y = w.pack(txx, txy), w.pack(txy, tyy)
        weights = [w.field(WX + c) for c in range(3)]
        offsets_x, offsets_y = (
            [builder.fsub(ir.Constant(_DOUBLE, c - 1.0), w.field(row)) for c in range(3)] for row in (RX, RY)
        )
        for k in range(3):
            weight, slope = w.field(WY + k), w.field(GY + k)
            weight_4 = w.splat(weight, 4)
            at_row = w.times(w.plus_times(centre, by_y, w.splat(offsets_y[k], 4)), weight_4)
            along_row = w.times(by_x, weight_4)
            force_row_x, force_row_y = w.times(force_x, w.splat(weight, 2)), w.times(force_y, w.splat(slope, 2))
            for c in range(3):
                slope = w.field(GX + c)
                inertia = w.plus_times(at_row, along_row, w.splat(offsets_x[c], 4))
                pointer = w.node_pointer(k, c, NM, 4)
                node = builder.load(pointer, align=8)
                builder.store(w.plus_times(node, inertia, w.splat(weights[c], 4)), pointer, align=8)
                pointer = w.node_pointer(k, c, NFX, 2)
                node = w.plus_times(builder.load(pointer, align=8), force_row_x, w.splat(slope, 2))
                builder.store(w.plus_times(node, force_row_y, w.splat(weights[c], 2)), pointer, align=8)
        return context.get_dummy_value()

    return types.void(grid, types.int64, types.int64, work, types.int64, types.float64), generate


@intrinsic
def scatter_momentum_point(typing_context, grid, corner, count_x, work, lane):
    """Add mass and momentum of a point to its nodes; parameters as of `gather_point`."""

    def generate(context, builder, signature, values):
        w = _Writer(context, builder, signature, values)
        mass = w.field(MASS)
        inertia = w.pack(mass, builder.fmul(mass, w.field(VX)), builder.fmul(mass, w.field(VY)), None)
        columns = [w.splat(w.field(WX + c), 4) for c in range(3)]
        for k in range(3):
            row = w.times(inertia, w.splat(w.field(WY + k), 4))
            for c in range(3):
                pointer = w.node_pointer(k, c, NM, 4)
                node = builder.load(pointer, align=8)
                builder.store(w.plus_times(node, row, columns[c]), pointer, align=8)
        return context.get_dummy_value()

    return types.void(grid, types.int64, types.int64, work, types.int64), generate


@intrinsic
def scatter_force_point(typing_context, grid, corner, count_x, work, lane):
    """Add the internal force of a point to its nodes; parameters as of `gather_point`."""

    def generate(context, builder, signature, values):
        w = _Writer(context, builder, signature, values)
        txx, txy, tyy = (builder.fneg(w.field(row)) for row in (TXX, TXY, TYY))
        force_x, force_y = w.pack(txx, txy), w.pack(txy, tyy)
        slopes = [w.splat(w.field(GX + c), 2) for c in range(3)]
        weights = [w.splat(w.field(WX + c), 2) for c in range(3)]
        for k in range(3):
            row_x = w.times(force_x, w.splat(w.field(WY + k), 2))
            row_y = w.times(force_y, w.splat(w.field(GY + k), 2))
            for c in range(3):
                pointer = w.node_pointer(k, c, NFX, 2)
                node = w.plus_times(builder.load(pointer, align=8), row_x, slopes[c])
                builder.store(w.plus_times(node, row_y, weights[c]), pointer, align=8)
        return context.get_dummy_value()

    return types.void(grid, types.int64, types.int64, work, types.int64), generate
