"""Momentum update of the nodes: forces, damping, clamp, and the energies it reports."""

import numpy as np
import pytest

from orthocut.kernels.mpm import layout
from orthocut.kernels.mpm.frame import Frame
from orthocut.kernels.mpm.grid import clear_grid, update_grid, work_of_forces

FRAME = Frame(0.0, 0.0, 1e-4, 1e4, 4, 3, -1, 1e-12, 0.0, 1e-6, 0.0)
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
    return grid


def update(grid, free=ALL, damping=0.0):
    return update_grid(grid.ravel(), ALL, FRAME, np.array(free), damping)


def velocity(grid):
    return grid[:, [layout.NVX, layout.NVY]]


def test_forces_and_damping_change_the_velocity():
    grid = nodes()
    mass = grid[:, [layout.NM]]
    old = grid[:, [layout.NPX, layout.NPY]] / mass
    expected = old + 1e-6 * (grid[:, [layout.NFX, layout.NFY]] / mass - 3e4 * old)
    update(grid, damping=3e4)
    np.testing.assert_allclose(velocity(grid), expected, rtol=1e-12)


def test_change_of_kinetic_energy_is_work_of_forces_less_damping():
    grid = nodes()
    mass, force = grid[:, [layout.NM]], grid[:, [layout.NFX, layout.NFY]]
    old = grid[:, [layout.NPX, layout.NPY]] / mass
    kinetic, damped, *_ = update(grid, damping=3e4)
    work = work_of_forces(grid.ravel(), np.zeros_like(grid).ravel(), ALL, FRAME)
    assert work == pytest.approx(1e-6 * (force * 0.5 * (old + velocity(grid))).sum(), rel=1e-12)
    assert kinetic == pytest.approx(0.5 * (mass * old**2).sum(), rel=1e-12)
    kinetic_new = 0.5 * (mass * velocity(grid) ** 2).sum()
    assert kinetic_new - kinetic == pytest.approx(work - damped, rel=1e-9)
    assert damped > 0.0


def test_clamped_rows_stand_still_and_their_impulse_is_reported():
    grid = nodes()
    row = grid[:4].copy()
    *_, impulse_x, impulse_y = update(grid, free=(0, 3, 1, 2))
    assert (velocity(grid)[:4] == 0.0).all()
    assert (velocity(grid)[4:] != 0.0).all()
    assert impulse_x == pytest.approx(-(row[:, layout.NPX] + 1e-6 * row[:, layout.NFX]).sum(), rel=1e-12)
    assert impulse_y == pytest.approx(-(row[:, layout.NPY] + 1e-6 * row[:, layout.NFY]).sum(), rel=1e-12)


def test_forces_work_on_the_mean_of_the_velocities_that_points_move_with():
    grid, before = nodes(), nodes(seed=6)
    before[:, layout.NVX], before[:, layout.NVY] = 1.0, -2.0
    update(grid)
    force = grid[:, [layout.NFX, layout.NFY]]
    expected = 0.5e-6 * (force * (np.array([1.0, -2.0]) + velocity(grid))).sum()
    assert work_of_forces(grid.ravel(), before.ravel(), ALL, FRAME) == pytest.approx(expected, rel=1e-9)


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


def test_nodes_beside_the_free_columns_stand_still():
    grid = nodes()
    _, _, impulse_x, impulse_y = update(grid, free=(1, 2, 0, 2))
    held = np.arange(12) % 4 % 3 == 0
    assert (velocity(grid)[held] == 0.0).all()
    assert (velocity(grid)[~held] != 0.0).all()
    pushed = grid[held][:, [layout.NPX, layout.NPY]] + FRAME.time_step * grid[held][:, [layout.NFX, layout.NFY]]
    assert (impulse_x, impulse_y) == pytest.approx(-pushed.sum(axis=0), rel=1e-12)
