"""Stress of points that a grid carries along exact paths of deformation (T4, T5, T6).

Nodes move with linear velocity fields, which points take over exactly, through the compiled pass over points.
"""

import math

import numpy as np
import pytest
from bodies import PLASTIC, Bodies, rectangle
from scipy.optimize import brentq

from orthocut.kernels.laws.hardening import Linear
from orthocut.kernels.mpm import layout, points

CELL = 1e-3
HARDENING = PLASTIC._replace(hardening=Linear(25e6, 1000.1e6 * 100e6 / (1000.1e6 - 100e6)))


class Path:
    """A block of four cells that is deformed uniformly."""

    def __init__(self, solid):
        self.body = Bodies(rectangle(0, 2, 0, 2, CELL), cell=CELL, room=8, solid=solid, affine=0.0)
        self.gradient = np.eye(2)

    def step(self, gradient):
        """Bring the deformation gradient of all points to a value by one pass over the points."""
        body = self.body
        change = np.asarray(gradient) @ np.linalg.inv(self.gradient) - np.eye(2)
        x, y = body.node_x, body.node_y
        grid = np.zeros((*x.shape, layout.NODE))
        grid[..., layout.NVX] = change[0, 0] * x + change[0, 1] * y
        grid[..., layout.NVY] = change[1, 0] * x + change[1, 1] * y
        state = body.state
        work, extent = np.zeros(layout.WORK), np.zeros(4, dtype=np.int64)
        points.advance_points(
            state.points,
            state.blocks[0],
            grid.ravel(),
            np.zeros(grid.size),
            work,
            extent,
            state.solid,
            state.frame,
            1.0,
        )
        self.gradient = np.asarray(gradient, dtype=float)
        return self

    def to(self, gradient, steps=400):
        start = self.gradient
        for k in range(1, steps + 1):
            self.step(start + (np.asarray(gradient) - start) * k / steps)
        return self

    @property
    def cauchy(self):
        """Stress xx, yy, xy [MPa]; that of all points."""
        stress = self.body.stress() / 1e6
        assert np.ptp(stress, axis=1).max() < 1e-6
        return stress[:, 0]

    @property
    def strain_plastic(self):
        return self.body.state.field(layout.EPS)[0]


@pytest.mark.parametrize(
    ("solid", "stretch", "xx", "yy", "strain"),
    [
        (PLASTIC, 1.10, 108.70, 85.97, 0.0425),
        (HARDENING, 1.10, 111.31, 84.66, 0.0388),
        (PLASTIC, 1.05, 63.71, 39.91, 0.0109),
        (HARDENING, 1.05, 64.41, 39.56, 0.0099),
    ],
)
def test_uniaxial_strain(solid, stretch, xx, yy, strain):
    """Exact: values at finite strain, computed apart, to the digits given; stresses in MPa."""
    path = Path(solid).to(np.diag([stretch, 1.0]))
    assert path.cauchy[0] == pytest.approx(xx, abs=0.015)
    assert path.cauchy[1] == pytest.approx(yy, abs=0.015)
    assert path.strain_plastic == pytest.approx(strain, abs=6e-5)


@pytest.mark.parametrize("solid", [PLASTIC, HARDENING])
def test_uniaxial_strain_that_is_small(solid):
    """Exact for small strain: q = sy + Ep (2 G e - sy)/(3 G + Ep), sigma_xx = K e + 2 q/3; at 4 %, to 3 % of it."""
    strain, shear, plastic = 0.04, solid.modulus_shear, solid.hardening.modulus_plastic
    first = solid.hardening.stress_yield
    q = first + plastic * (2 * shear * strain - first) / (3 * shear + plastic)
    stress = Path(solid).to(np.diag([math.exp(strain), 1.0])).cauchy
    assert stress[0] * 1e6 == pytest.approx(solid.modulus_bulk * strain + 2 / 3 * q, rel=0.03)
    assert (stress[0] - stress[1]) * 1e6 == pytest.approx(q, rel=0.05)


def test_simple_shear_yields_at_the_strain_and_stress_of_von_mises():
    """Exact: yields at gamma = sy/(sqrt(3) G) = 0.0384 and flows at sy/sqrt(3) = 14.43 MPa."""
    path = Path(PLASTIC)
    path.to([[1.0, 0.0383], [0.0, 1.0]], steps=100)
    assert path.strain_plastic == 0.0
    path.to([[1.0, 0.0386], [0.0, 1.0]], steps=10)
    assert path.strain_plastic > 0.0
    assert path.cauchy[2] == pytest.approx(14.43, abs=0.02)
    path.to([[1.0, 0.06], [0.0, 1.0]])
    assert path.cauchy[2] == pytest.approx(14.43, abs=0.02)


def test_plane_strain_tension_has_its_limit_at_28_87_megapascals():
    """Exact: a strip that is free to contract carries 2/sqrt(3) sy of Kirchhoff stress, 28.87 MPa without hardening."""
    path = Path(PLASTIC)
    height = stretch = 1.0
    for _ in range(200):
        stretch *= 1.001
        saved, gradient = path.body.state.points.copy(), path.gradient

        def lateral(trial, stretch=stretch, saved=saved, gradient=gradient):
            path.body.state.points[:], path.gradient = saved, gradient
            return path.step(np.diag([stretch, trial])).body.stress()[1, 0]

        height = brentq(lateral, height - 0.01, height + 0.01, xtol=1e-9)
        lateral(height)
    kirchhoff = path.cauchy[0] * stretch * height
    print(f"limit: {kirchhoff:.3f} MPa")
    assert kirchhoff == pytest.approx(2 / math.sqrt(3) * 25, abs=0.015)
