"""Loose nodes: forces keep their sum and moment, linear fields stay exact, energy is accounted for."""

import numpy as np
import pytest

from orthocut.kernels.mpm import layout
from orthocut.kernels.mpm.contact import push_with_tool
from orthocut.kernels.mpm.frame import Frame, Wedge
from orthocut.kernels.mpm.grid import update_grid, work_of_forces
from orthocut.kernels.mpm.layout import BASE
from orthocut.kernels.mpm.support import DIRECTIONS, LOOSE, follow_firm_nodes, lean_on_firm_nodes, work_of_loose_forces

COLUMNS, ROWS = 9, 8
STEP = 1e-6
FRAME = Frame(0.0, 0.0, 1e-4, 1e4, COLUMNS, ROWS, -1, 1e-12, 1e-6, STEP, 1.0)
ALL = np.array([0, COLUMNS - 1, 0, ROWS - 1])
X, Y = (axis.ravel().astype(float) for axis in np.meshgrid(np.arange(COLUMNS), np.arange(ROWS)))
INSIDE = (X >= 2) & (X <= 6) & (Y >= 2) & (Y <= 5)
FRINGE = (X >= 1) & (X <= 7) & (Y >= 1) & (Y <= 6) & ~INSIDE


class Body:
    """A block of firm nodes with a fringe of loose ones around it."""

    def __init__(self, fringe=2e-7, seed=3):
        random = np.random.default_rng(seed)
        self.grid = np.zeros((COLUMNS * ROWS, layout.NODE))
        self.grid[INSIDE, layout.NM] = random.uniform(1e-5, 2e-5, INSIDE.sum())
        self.grid[FRINGE, layout.NM] = fringe
        self.loose = np.zeros(COLUMNS * ROWS, dtype=np.int64)
        self.weights = np.zeros((COLUMNS * ROWS, DIRECTIONS))
        self.count = 0

    def put(self, first, x, y):
        mass = self.grid[:, layout.NM]
        scale = mass if first == layout.NPX else (mass > 0)
        self.grid[:, first], self.grid[:, first + 1] = scale * x, scale * y

    def get(self, first):
        return self.grid[:, first : first + 2]

    def lean(self, free=ALL):
        self.count = lean_on_firm_nodes(self.grid.ravel(), ALL, self.loose, self.weights, FRAME, free)

    def update(self, free=ALL):
        self.lean(free)
        update_grid(self.grid.ravel(), ALL, FRAME, free, 0.0)
        follow_firm_nodes(self.grid.ravel(), self.loose, self.weights, self.count, FRAME)


def forces(seed=4):
    return np.random.default_rng(seed).normal(size=(2, COLUMNS * ROWS))


def test_forces_keep_their_sum_and_their_moment():
    body = Body(fringe=1e-11)  # so little mass that the whole force is handed on
    body.put(layout.NFX, *forces())
    before = body.get(layout.NFX).copy()
    body.lean()
    assert body.count == FRINGE.sum()
    after = np.where(INSIDE[:, None], body.get(layout.NFX), 0.0)
    np.testing.assert_allclose(after.sum(0), before.sum(0), rtol=1e-4)
    moment = [(X * part[:, 1] - Y * part[:, 0]).sum() for part in (after, before)]
    assert moment[0] == pytest.approx(moment[1], rel=1e-3)


def test_masses_are_handed_on_whole():
    body = Body()
    body.lean()
    given = (1 - (2e-7 / FRAME.mass_firm) ** 2) * 2e-7 * FRINGE.sum()
    assert body.grid[INSIDE, layout.NMARK].sum() == pytest.approx(given, rel=1e-12)
    assert (body.grid[FRINGE, layout.NMARK] == LOOSE).all()


def test_force_that_all_feel_alike_moves_all_alike():
    body = Body(fringe=4e-7)
    mass = body.grid[:, layout.NM]
    body.grid[:, layout.NFX], body.grid[:, layout.NFY] = 2e3 * mass, -1e3 * mass
    body.update()
    np.testing.assert_allclose(body.get(layout.NVX)[INSIDE | FRINGE], [[2e-3, -1e-3]] * 42, rtol=1e-12)


def test_changes_of_velocity_that_are_linear_in_space_stay_so():
    """Forces on firm nodes that accelerate them by a linear field, none on the loose ones of no mass."""
    body = Body(fringe=1e-11)
    field = 3.0 + 0.5 * X - 0.2 * Y, -1.0 + 0.1 * X + 0.7 * Y
    mass = np.where(INSIDE, body.grid[:, layout.NM], 0.0)
    body.grid[:, layout.NFX], body.grid[:, layout.NFY] = mass * field[0] / STEP, mass * field[1] / STEP
    body.update()
    filled = INSIDE | FRINGE
    np.testing.assert_allclose(body.get(layout.NVX)[filled], np.transpose(field)[filled], atol=1e-3)


def test_nodes_with_the_mass_of_firm_ones_move_on_their_own():
    body = Body(fringe=FRAME.mass_firm * (1 - 1e-9))
    body.put(layout.NFX, *forces())
    force, mass = body.get(layout.NFX).copy(), body.grid[:, [layout.NM]]
    body.update()
    filled = INSIDE | FRINGE
    expected = STEP * force / np.maximum(mass, 1e-30)
    np.testing.assert_allclose(body.get(layout.NVX)[filled], expected[filled], atol=1e-6)


def test_work_is_that_of_all_forces_as_they_were():
    body, before = Body(), Body()
    before.put(layout.NVX, *forces(8))
    body.put(layout.NPX, *forces(5))
    body.put(layout.NFX, *forces())
    force = body.get(layout.NFX).copy()
    body.update()
    old, new = before.grid.ravel(), body.grid.ravel()
    work = work_of_forces(new, old, ALL, FRAME)
    work += work_of_loose_forces(new, old, body.loose, body.weights, body.count, FRAME)
    expected = 0.5 * STEP * (force * (body.get(layout.NVX) + before.get(layout.NVX))).sum()
    assert work == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("fringe", [1e-11, 2e-7, 6e-7])
def test_loose_nodes_stop_with_firm_ones_that_the_tool_stops(fringe):
    """The tool gives the momentum of all nodes; loose nodes take it from the firm ones, up to their own motion."""
    body = Body(fringe=fringe)
    body.put(layout.NPX, 0.0, 2.0)
    body.lean()
    update_grid(body.grid.ravel(), ALL, FRAME, ALL, 0.0)
    marked = np.flatnonzero(INSIDE | FRINGE) * layout.NODE
    wedge = Wedge(0.5, 0.0, 0.0, 5.0, 0.0, 0.0)
    _, impulse, _, _ = push_with_tool(body.grid.ravel(), marked, marked.size, BASE, wedge, 5.0, FRAME)
    follow_firm_nodes(body.grid.ravel(), body.loose, body.weights, body.count, FRAME)
    mass = body.grid[:, layout.NM]
    np.testing.assert_allclose(body.grid[INSIDE, layout.NVY], 0.0, atol=1e-12)
    np.testing.assert_allclose(body.grid[FRINGE, layout.NVY], 2.0 * (fringe / FRAME.mass_firm) ** 2, atol=1e-12)
    change = (mass * body.grid[:, layout.NVY] - body.grid[:, layout.NPY]).sum()
    assert impulse == pytest.approx(change, rel=1e-12)


def test_no_node_leans_on_clamped_rows():
    body = Body()
    body.lean(np.array([0, COLUMNS - 1, 3, ROWS - 1]))
    found = body.loose[: body.count]
    assert (Y[found] > 2).all()
    assert not body.weights[: body.count][Y[found] == 3][:, :3].any()


def test_no_node_leans_on_columns_that_are_held():
    body = Body()
    body.lean(np.array([3, 6, 0, ROWS - 1]))
    found = body.loose[: body.count]
    assert set(X[found]) == {3, 4, 5, 6}
    weights = body.weights[: body.count].reshape(-1, 8)
    assert not weights[X[found] == 3][:, [0, 3, 5]].any()
    assert not weights[X[found] == 6][:, [2, 4, 7]].any()


def test_nodes_without_firm_lines_are_left_alone():
    body = Body()
    body.grid[INSIDE, layout.NM] = 2e-7
    body.lean()
    assert body.count == 0
    assert (body.grid[:, layout.NMARK] == 0.0).all()
