"""Momentum update of the nodes: forces, damping, clamp, and the energies it reports."""

import numpy as np
import pytest

from orthocut.kernels.mpm import layout
from orthocut.kernels.mpm.frame import Frame
from orthocut.kernels.mpm.grid import clear_grid, update_grid

FRAME = Frame(0.0, 0.0, 1e-4, 1e4, 4, 3, -1, 1e-12, 1e-6, 0.0)
ALL = np.array([0, 3, 0, 2])


def nodes(seed=5):
    """Grid with random masses, momenta and forces."""
    random = np.random.default_rng(seed)
    grid = np.zeros((12, layout.NODE))
    grid[:, layout.NM] = random.uniform(1e-6, 1e-5, 12)
    for quantity in (layout.NPX, layout.NPY):
        grid[:, quantity] = 1e-5 * random.normal(size=12)
    for quantity in (layout.NFX, layout.NFY):
        grid[:, quantity] = random.normal(size=12)
    grid[:, layout.NMARK] = 1.0
    return grid


def update(grid, before=None, clamped=-1, damping=0.0):
    before = np.zeros_like(grid) if before is None else before
    return update_grid(grid.ravel(), before.ravel(), ALL, FRAME, clamped, damping)


def velocity(grid):
    return grid[:, [layout.NVX, layout.NVY]]


def test_forces_and_damping_change_the_velocity():
    grid = nodes()
    mass = grid[:, [layout.NM]]
    old = grid[:, [layout.NPX, layout.NPY]] / mass
    expected = old + 1e-6 * (grid[:, [layout.NFX, layout.NFY]] / mass - 3e4 * old)
    update(grid, damping=3e4)
    np.testing.assert_allclose(velocity(grid), expected, rtol=1e-12)
    assert (grid[:, layout.NMARK] == 0.0).all()


def test_change_of_kinetic_energy_is_work_of_forces_less_damping():
    grid = nodes()
    mass, force = grid[:, [layout.NM]], grid[:, [layout.NFX, layout.NFY]]
    old = grid[:, [layout.NPX, layout.NPY]] / mass
    kinetic, kinetic_new, damped, *_ = update(grid, damping=3e4)
    work = 1e-6 * (force * 0.5 * (old + velocity(grid))).sum()
    assert kinetic == pytest.approx(0.5 * (mass * old**2).sum(), rel=1e-12)
    assert kinetic_new - kinetic == pytest.approx(work - damped, rel=1e-9)
    assert damped > 0.0


def test_clamped_rows_stand_still_and_their_impulse_is_reported():
    grid = nodes()
    row = grid[:4].copy()
    *_, impulse_x, impulse_y = update(grid, clamped=0)
    assert (velocity(grid)[:4] == 0.0).all()
    assert (velocity(grid)[4:] != 0.0).all()
    assert impulse_x == pytest.approx(-(row[:, layout.NPX] + 1e-6 * row[:, layout.NFX]).sum(), rel=1e-12)
    assert impulse_y == pytest.approx(-(row[:, layout.NPY] + 1e-6 * row[:, layout.NFY]).sum(), rel=1e-12)


def test_drag_is_the_work_on_the_velocity_that_transfers_took():
    grid, before = nodes(), nodes(seed=6)
    before[:, layout.NVX], before[:, layout.NVY] = 1.0, -2.0
    old = grid[:, [layout.NPX, layout.NPY]] / grid[:, [layout.NM]]
    force = grid[:, [layout.NFX, layout.NFY]]
    expected = 0.5e-6 * (force * (np.array([1.0, -2.0]) - old)).sum()
    assert update(grid, before)[3] == pytest.approx(expected, rel=1e-9)
    assert update(nodes())[3] == 0.0


def test_nodes_of_no_mass_are_left_alone():
    grid = nodes()
    grid[7, layout.NM] = 0.5e-12
    update(grid)
    assert (velocity(grid)[7] == 0.0).all()
    assert np.isfinite(grid).all()


def test_clearing_leaves_what_lies_outside():
    grid = nodes()
    clear_grid(grid.ravel(), np.array([1, 2, 1, 2]), FRAME)
    cleared = (grid == 0.0).all(axis=1).reshape(3, 4)
    assert cleared[1:, 1:3].all()
    assert cleared.sum() == 4
