"""Passes of the loop of the paper's program: updates of eqs (8) to (10), forces, transfers, velocities of a grid."""

import numpy as np
import pytest

from orthocut.kernels.mpm import layout, points, usavg_grid, usavg_points
from orthocut.kernels.mpm.frame import Usavg
from orthocut.mpm import setup
from orthocut.mpm.setup import fill_blocks
from orthocut.params.case import load

CELL, TIME_STEP = 0.1, 1e-4
BUILT = setup.build(load("mpm", {"points_per_depth": 4}))
SOLID = BUILT.solid
FRAME = BUILT.frame._replace(
    origin_x=-0.5,
    origin_y=-0.4,
    cell=CELL,
    inv_cell=1 / CELL,
    count_x=24,
    count_y=20,
    mass_small=1e-12,
    mass_firm=0.0,
    time_step=TIME_STEP,
    affine=0.0,
)
ALL = np.array([0, FRAME.count_x - 1, 0, FRAME.count_y - 1])
BEFORE = (lambda x, y: 2 + 3 * x - 4 * y, lambda x, y: -1 + 5 * x + 6 * y)
AFTER = (lambda x, y: 1 - 2 * x + y, lambda x, y: 3 + x - 7 * y)


def grid_of(velocity=None):
    grid = np.zeros((FRAME.count_y, FRAME.count_x, layout.NODE))
    if velocity:
        j, i = np.mgrid[: FRAME.count_y, : FRAME.count_x]
        x, y = FRAME.origin_x + i * CELL, FRAME.origin_y + j * CELL
        grid[..., layout.NVX], grid[..., layout.NVY] = velocity[0](x, y), velocity[1](x, y)
    return grid.ravel()


class Body:
    """A random cloud of points that move at random."""

    def __init__(self, count=100):
        rng = np.random.default_rng(4)
        self.points = fill_blocks(rng.uniform(0, 1, count), rng.uniform(0, 0.8, count), 0.25).ravel()
        self.blocks = np.array([0, self.points.size // layout.BLOCK])
        self.moves = np.zeros(2 * self.points.size // layout.POINT_FIELDS)
        self.work = np.zeros(layout.WORK)
        self.rows(layout.VX)[:] = rng.normal(size=self.rows(layout.VX).shape)
        self.rows(layout.VY)[:] = rng.normal(size=self.rows(layout.VY).shape)

    def rows(self, field):
        return self.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)[:, field, :]

    def moved(self, direction):
        return self.moves.reshape(-1, 2, layout.LANES)[:, direction, :]


def sums(grid):
    return grid.reshape(-1, layout.NODE).sum(axis=0)


@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("flip", [0.0, 0.3, 1.0])
def test_velocities_and_displacements_are_those_of_the_paper(order, flip):
    body = Body()
    x, y = body.rows(layout.X).copy(), body.rows(layout.Y).copy()
    own = body.rows(layout.VX).copy(), body.rows(layout.VY).copy()
    target = grid_of(BEFORE)
    usavg_points.accelerate_points(
        body.points, body.blocks, body.moves, grid_of(AFTER), target, body.work, Usavg(flip, order), FRAME
    )
    for direction, field in enumerate((layout.VX, layout.VY)):
        before, after = BEFORE[direction](x, y), AFTER[direction](x, y)
        acceleration = (after - before) / TIME_STEP
        damping = (1 - flip) / TIME_STEP * (own[direction] - before)
        np.testing.assert_allclose(
            body.rows(field), own[direction] + TIME_STEP * (acceleration - damping), rtol=1e-10, atol=1e-11
        )
        second = (acceleration if order == 2 else 0) + (damping if order > 0 else 0)
        np.testing.assert_allclose(
            body.moved(direction), TIME_STEP * after - 0.5 * TIME_STEP**2 * second, rtol=1e-10, atol=1e-15
        )
    mass = body.rows(layout.MASS)
    assert sums(target)[layout.NM] == pytest.approx(mass.sum(), rel=1e-12)
    assert sums(target)[layout.NPX] == pytest.approx((mass * body.rows(layout.VX)).sum(), rel=1e-10)
    assert sums(target)[layout.NPY] == pytest.approx((mass * body.rows(layout.VY)).sum(), rel=1e-10)
    np.testing.assert_array_equal(body.rows(layout.X), x)


def test_two_halves_deform_as_one_step_and_keep_velocities():
    """Half a step with a uniform gradient twice is the square of the half step; points move by what was stored."""
    body = Body()
    own, x = body.rows(layout.VX).copy(), body.rows(layout.X).copy()
    body.moves[:] = 1e-3
    field = grid_of(BEFORE)
    usavg_points.load_points(body.points, body.blocks, field, grid_of(), body.work, SOLID, FRAME)
    np.testing.assert_array_equal(body.rows(layout.X), x)
    extent, target = np.zeros(4, dtype=np.int64), grid_of()
    kinetic = usavg_points.settle_points(
        body.points, body.blocks, body.moves, field, target, body.work, extent, SOLID, FRAME
    )
    half = np.eye(2) + 0.5 * TIME_STEP * np.array([[3.0, -4.0], [5.0, 6.0]])
    whole = half @ half
    for field_index, expected in zip((layout.FXX, layout.FXY, layout.FYX, layout.FYY), whole.ravel(), strict=True):
        np.testing.assert_allclose(body.rows(field_index), expected, atol=1e-13)
    np.testing.assert_array_equal(body.rows(layout.VX), own)
    np.testing.assert_allclose(body.rows(layout.X), x + 1e-3, rtol=1e-15)
    mass = body.rows(layout.MASS)
    assert kinetic == pytest.approx(0.5 * (mass * (own**2 + body.rows(layout.VY) ** 2)).sum(), rel=1e-12)
    used = target.reshape(FRAME.count_y, FRAME.count_x, layout.NODE)[..., layout.NM] > 0
    columns = np.nonzero(used.any(axis=0))[0]
    assert extent[0] <= columns[0]
    assert columns[-1] <= extent[1]


def test_forces_and_momenta_are_those_of_the_other_loop():
    """With no time to deform, the transfers are those of `points.advance_points`, without a share of the gradient."""
    body = Body()
    bent = (lambda x, y: 30 * np.sin(5 * x) * y, lambda x, y: 20 * np.cos(4 * y) + x)
    extent, other = np.zeros(4, dtype=np.int64), grid_of()
    points.advance_points(
        body.points, body.blocks, grid_of(bent), grid_of(), body.work, extent, SOLID, FRAME, TIME_STEP
    )
    rest = FRAME._replace(time_step=0.0)
    forces, momenta = grid_of(), grid_of()
    usavg_points.load_points(body.points, body.blocks, grid_of(), forces, body.work, SOLID, rest)
    usavg_points.settle_points(body.points, body.blocks, body.moves, grid_of(), momenta, body.work, extent, SOLID, rest)
    velocities = grid_of()
    velocities[:] = 0.0
    copy = Body()
    copy.points[:] = body.points
    # the other loop takes velocities from the grid: forces do not depend on them
    points.advance_points(copy.points, copy.blocks, velocities, other, copy.work, extent, SOLID, FRAME, 0.0)
    for quantity in (layout.NFX, layout.NFY):
        expected = other.reshape(-1, layout.NODE)[:, quantity]
        assert np.abs(expected).max() > 1.0
        np.testing.assert_allclose(
            forces.reshape(-1, layout.NODE)[:, quantity], expected, atol=1e-11 * np.abs(expected).max()
        )
    np.testing.assert_allclose(
        momenta.reshape(-1, layout.NODE)[:, layout.NM], other.reshape(-1, layout.NODE)[:, layout.NM], atol=1e-12
    )
    assert sums(forces)[layout.NM] == 0.0


def test_velocities_are_momentum_over_mass_and_clamped_nodes_stand_still():
    grid, target = grid_of().reshape(FRAME.count_y, FRAME.count_x, -1), grid_of().reshape(FRAME.count_y, -1)
    grid[..., layout.NM], grid[..., layout.NPX], grid[..., layout.NPY] = 0.5, 2.0, -3.0
    grid[7, 3, layout.NM] = 1e-13
    free = np.array([0, FRAME.count_x - 1, 5, FRAME.count_y - 1])
    usavg_grid.set_velocities(grid.ravel(), target.ravel(), ALL, FRAME, free)
    target = target.reshape(FRAME.count_y, FRAME.count_x, -1)
    assert (target[:5] == 0.0).all()
    assert (target[7, 3] == 0.0).all()
    target[7, 3] = target[8, 3]
    assert (target[5:, :, layout.NVX] == 4.0).all()
    assert (target[5:, :, layout.NVY] == -6.0).all()


def test_stresses_work_on_the_mean_velocity_without_the_forces_of_the_interface():
    rng = np.random.default_rng(1)
    first, second, third = (rng.normal(size=grid_of().size) for _ in range(3))
    one, two, three = (grid.reshape(-1, layout.NODE) for grid in (first, second, third))
    force = (two - one)[:, [layout.NFX, layout.NFY]]
    mean = 0.5 * (one + three)[:, [layout.NVX, layout.NVY]]
    found = usavg_grid.work_of_stresses(first, second, third, ALL, FRAME)
    assert found == pytest.approx(TIME_STEP * (force * mean).sum(), rel=1e-10)
