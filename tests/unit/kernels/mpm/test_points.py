"""Transfers between points and grid against plain numpy, and what they must conserve."""

import math

import numpy as np
import pytest

from orthocut.kernels.laws.hardening import Elastic, Linear, Ludwik, Voce
from orthocut.kernels.laws.neo_hookean_j2 import update
from orthocut.kernels.mpm import layout, points
from orthocut.kernels.mpm.frame import Frame, Solid
from orthocut.kernels.mpm.shape import gimp_weights
from orthocut.mpm.setup import fill_blocks

CELL = 0.1
SOLID = Solid(980e6, 376e6, 1000.0, Linear(25e6, 0.0))
FRAME = Frame(-0.5, -0.4, CELL, 1 / CELL, 24, 20, -1, 1e-12, 0.0, 1e-6, 0.0)


class Body:
    """A random cloud of points on a grid."""

    def __init__(self, count=100, seed=3):
        rng = np.random.default_rng(seed)
        self.points = fill_blocks(rng.uniform(0, 1, count), rng.uniform(0, 0.8, count), 0.25).ravel()
        self.blocks = np.array([0, self.points.size // layout.BLOCK])
        self.before = np.zeros(FRAME.count_x * FRAME.count_y * layout.NODE)
        self.after = np.zeros_like(self.before)
        self.work = np.zeros(layout.WORK)
        self.extent = np.zeros(4, dtype=np.int64)

    def rows(self, field):
        return self.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)[:, field, :].ravel()

    def set_velocity(self, function):
        """Nodal velocities from a function of place."""
        nodes = self.before.reshape(FRAME.count_y, FRAME.count_x, layout.NODE)
        j, i = np.mgrid[: FRAME.count_y, : FRAME.count_x]
        vx, vy = function(FRAME.origin_x + i * CELL, FRAME.origin_y + j * CELL)
        nodes[..., layout.NVX], nodes[..., layout.NVY] = vx, vy

    def advance(self, time_step, affine=0.0, solid=SOLID):
        return points.advance_points(
            self.points,
            self.blocks,
            self.before,
            self.after,
            self.work,
            self.extent,
            solid,
            FRAME._replace(affine=affine),
            time_step,
        )

    def node_sums(self):
        return self.after.reshape(-1, layout.NODE).sum(axis=0)


def test_linear_velocity_field_is_gathered_exactly():
    body = Body()
    x, y = body.rows(layout.X).copy(), body.rows(layout.Y).copy()
    body.set_velocity(lambda x, y: (2 + 3 * x - 4 * y, -1 + 5 * x + 6 * y))
    body.advance(1e-6)
    np.testing.assert_allclose(body.rows(layout.VX), 2 + 3 * x - 4 * y, rtol=1e-12)
    np.testing.assert_allclose(body.rows(layout.VY), -1 + 5 * x + 6 * y, rtol=1e-12)
    np.testing.assert_allclose(body.rows(layout.X), x + 1e-6 * (2 + 3 * x - 4 * y), rtol=1e-14)
    for field, expected in ((layout.FXX, 1 + 3e-6), (layout.FXY, -4e-6), (layout.FYX, 5e-6), (layout.FYY, 1 + 6e-6)):
        np.testing.assert_allclose(body.rows(field), expected, atol=1e-15)


def test_scatter_is_that_of_plain_numpy():
    body = Body()
    body.set_velocity(lambda x, y: (30 * np.sin(5 * x) * y, 20 * np.cos(4 * y) + x))
    body.advance(1e-4)
    expected = np.zeros((FRAME.count_y, FRAME.count_x, layout.NODE))
    fields = {name: body.rows(getattr(layout, name)) for name in ("X", "Y", "VX", "VY", "MASS")}
    fxx, fxy, fyx, fyy = (body.rows(f) for f in (layout.FXX, layout.FXY, layout.FYX, layout.FYY))
    bxx, byy, bxy = (body.rows(f) for f in (layout.BXX, layout.BYY, layout.BXY))
    third = (bxx + byy + 1 / (bxx * byy - bxy**2)) / 3
    pressure = 0.5 * SOLID.modulus_bulk * ((fxx * fyy - fxy * fyx) ** 2 - 1)
    txx = SOLID.modulus_shear * (bxx - third) + pressure
    tyy = SOLID.modulus_shear * (byy - third) + pressure
    txy = SOLID.modulus_shear * bxy
    for p in range(fields["X"].size):
        x, y = (fields["X"][p] - FRAME.origin_x) / CELL, (fields["Y"][p] - FRAME.origin_y) / CELL
        i, j = math.floor(x + 0.5), math.floor(y + 0.5)
        wx, wy = np.array(gimp_weights.py_func(x - i, 0.25)), np.array(gimp_weights.py_func(y - j, 0.25))
        mass = fields["MASS"][p]
        for k in range(3):
            for c in range(3):
                node = expected[j + k - 1, i + c - 1]
                weight = wx[c] * wy[k]
                slope_x, slope_y = wx[3 + c] * wy[k] / CELL, wx[c] * wy[3 + k] / CELL
                volume = mass / SOLID.density
                node[layout.NM] += mass * weight
                node[layout.NPX] += mass * weight * fields["VX"][p]
                node[layout.NPY] += mass * weight * fields["VY"][p]
                node[layout.NFX] -= volume * (txx[p] * slope_x + txy[p] * slope_y)
                node[layout.NFY] -= volume * (txy[p] * slope_x + tyy[p] * slope_y)
    result = body.after.reshape(expected.shape)
    for quantity in (layout.NM, layout.NPX, layout.NPY, layout.NFX, layout.NFY):
        scale = np.abs(expected[..., quantity]).max()
        np.testing.assert_allclose(result[..., quantity], expected[..., quantity], atol=1e-11 * scale)


def test_scatter_conserves_mass_and_momentum_and_internal_forces_balance():
    body = Body()
    body.set_velocity(lambda x, y: (3 * x * y, 4 * np.sin(x) - y))
    kinetic = body.advance(1e-4)
    mass, vx, vy = body.rows(layout.MASS), body.rows(layout.VX), body.rows(layout.VY)
    sums = body.node_sums()
    assert sums[layout.NM] == pytest.approx(mass.sum(), rel=1e-13)
    assert sums[layout.NPX] == pytest.approx(mass @ vx, rel=1e-12)
    assert sums[layout.NPY] == pytest.approx(mass @ vy, rel=1e-12)
    size = np.abs(body.after.reshape(-1, layout.NODE)[:, layout.NFX]).sum()
    assert size > 1.0
    assert abs(sums[layout.NFX]) < 1e-12 * size
    assert abs(sums[layout.NFY]) < 1e-12 * size
    assert kinetic == pytest.approx(0.5 * mass @ (vx**2 + vy**2), rel=1e-13)


@pytest.mark.parametrize("hardening", [Linear(25e6, 1e8), Ludwik(25e6, 1e8, 0.3), Voce(25e6, 5e7, 0.02), Elastic()])
def test_compiled_code_follows_the_law_of_the_material(hardening):
    """The law is chosen by its type when the kernel is compiled; plain Python looks it up."""
    body = Body()
    body.set_velocity(lambda x, y: (300 * np.sin(5 * x) * y, 200 * np.cos(4 * y) + x))
    body.advance(1e-4, solid=SOLID._replace(hardening=hardening))
    increments = np.stack([body.rows(row) for row in (layout.FXX, layout.FXY, layout.FYX, layout.FYY)], axis=1)
    states = [update.py_func(1.0, 1.0, 0.0, 0.0, *f, SOLID.modulus_shear, hardening)[:4] for f in increments]
    found = np.stack([body.rows(row) for row in (layout.BXX, layout.BYY, layout.BXY, layout.EPS)], axis=1)
    np.testing.assert_allclose(found, states, rtol=1e-10, atol=1e-14)
    assert (found[:, 3] > 0).any() != isinstance(hardening, Elastic)


def test_extent_holds_all_nodes_with_mass():
    body = Body()
    body.advance(0.0)
    used = body.after.reshape(FRAME.count_y, FRAME.count_x, layout.NODE)[..., layout.NM] > 0
    rows, columns = np.nonzero(used.any(axis=1))[0], np.nonzero(used.any(axis=0))[0]
    assert body.extent[0] <= columns[0]
    assert columns[-1] <= body.extent[1]
    assert body.extent[2] <= rows[0]
    assert rows[-1] <= body.extent[3]


def test_rigid_rotation_is_free_of_stress():
    """A quarter turn by velocities that carry each point along its chord, as the position update does."""
    body = Body()
    steps = 500
    angle = math.pi / 2 / steps
    c, s = math.cos(angle) - 1, math.sin(angle)
    body.set_velocity(lambda x, y: (c * (x - 0.5) - s * (y - 0.4), s * (x - 0.5) + c * (y - 0.4)))
    for _ in range(steps):
        body.advance(1.0)
    bxx, byy, bxy = (body.rows(f) for f in (layout.BXX, layout.BYY, layout.BXY))
    fxx, fxy, fyx, fyy = (body.rows(f) for f in (layout.FXX, layout.FXY, layout.FYX, layout.FYY))
    np.testing.assert_allclose(fyx, 1.0, atol=1e-9)
    np.testing.assert_allclose(fxx * fyy - fxy * fyx, 1.0, atol=1e-9)
    assert max(np.abs(bxx - 1).max(), np.abs(byy - 1).max(), np.abs(bxy).max()) < 1e-6


@pytest.mark.parametrize("place", [1e9, -1e9, np.inf, -np.inf, np.nan, 5.0])
@pytest.mark.parametrize("field", [layout.X, layout.Y])
def test_points_beyond_the_grid_do_not_write_outside(field, place):
    body = Body()
    body.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)[0, field, 0] = place
    guard = 5 * FRAME.count_x * layout.NODE
    guarded = np.full(body.after.size + 2 * guard, 7.0)
    body.after = guarded[guard:-guard]
    body.after[:] = 0.0
    body.advance(0.0)
    assert (guarded[:guard] == 7.0).all()
    assert (guarded[-guard:] == 7.0).all()


@pytest.mark.parametrize("affine", [0.0, 0.4, 1.0])
def test_affine_points_hand_on_their_share_of_a_linear_velocity_field(affine):
    """With the whole gradient the field comes back exactly, also at the edges; else that share of what is missing."""
    plain, carrying = Body(), Body()
    for body, share in ((plain, 0.0), (carrying, affine)):
        body.set_velocity(lambda x, y: (2 + 3 * x - 4 * y, -1 + 5 * x + 6 * y))
        body.advance(0.0, share)
    pic, found = (body.after.reshape(FRAME.count_y, FRAME.count_x, layout.NODE) for body in (plain, carrying))
    j, i = np.nonzero(found[..., layout.NM] > 1e-9)
    x, y = FRAME.origin_x + i * CELL, FRAME.origin_y + j * CELL
    mass = found[j, i, layout.NM]
    for momentum, exact in ((layout.NPX, 2 + 3 * x - 4 * y), (layout.NPY, -1 + 5 * x + 6 * y)):
        smoothed = pic[j, i, momentum] / mass
        assert abs(smoothed - exact).max() > 0.1
        np.testing.assert_allclose(found[j, i, momentum] / mass, smoothed + affine * (exact - smoothed), atol=1e-9)


def test_affine_points_change_no_total():
    plain, carrying = Body(), Body()
    for body, share in ((plain, 0.0), (carrying, 1.0)):
        body.set_velocity(lambda x, y: (30 * np.sin(5 * x) * y, 20 * np.cos(4 * y) + x))
        body.advance(1e-4, share)
    np.testing.assert_allclose(carrying.node_sums(), plain.node_sums(), rtol=1e-12, atol=1e-9)
