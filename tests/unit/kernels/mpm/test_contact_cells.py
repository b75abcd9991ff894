"""Contact by particles of the tool on the grid against plain numpy."""

import math

import numpy as np
import pytest

from orthocut.kernels.mpm import contact_cells, layout
from orthocut.kernels.mpm.contact import normal_of
from orthocut.kernels.mpm.frame import Wedge
from orthocut.kernels.mpm.shape import gimp_weights
from orthocut.mpm import setup
from orthocut.mpm.setup import fill_blocks
from orthocut.params.case import load

CELL, TIP = 1.0, 0.3
COUNT_X, COUNT_Y = 24, 20
FRAME = setup.build(load("mpm", {"points_per_depth": 4})).frame._replace(
    origin_x=-12.0, origin_y=-8.0, cell=CELL, inv_cell=1 / CELL, count_x=COUNT_X, count_y=COUNT_Y
)
RIGHT, TOP = FRAME.origin_x + (COUNT_X - 1) * CELL, FRAME.origin_y + (COUNT_Y - 1) * CELL


def wedge(rake=30.0):
    return Wedge(math.radians(rake), math.radians(5.0), 0.0, 5.0, 1.0, 0.0, True)


def weights(x, y):
    """Weights of a particle at all nodes, shape (COUNT_Y, COUNT_X)."""
    result = np.zeros((COUNT_Y, COUNT_X))
    u, v = (x - FRAME.origin_x) / CELL, (y - FRAME.origin_y) / CELL
    i, j = math.floor(u + 0.5), math.floor(v + 0.5)
    along, up = gimp_weights.py_func(u - i, 0.25)[:3], gimp_weights.py_func(v - j, 0.25)[:3]
    if 1 <= i <= COUNT_X - 2 and 1 <= j <= COUNT_Y - 2:
        result[j - 1 : j + 2, i - 1 : i + 2] = np.outer(up, along)
    return result


def tool(rake):
    """Sums of the tool by numpy: volume and moments from the tip."""
    result = np.zeros((COUNT_Y, COUNT_X, 3))
    for row in range(60):
        for column in range(60):
            if min(row, column) >= 4:
                continue
            s, t = 0.5 * (row + 0.5), 0.5 * (column + 0.5)
            dx, dy = s * math.tan(math.radians(rake)) + t, s + t * math.tan(math.radians(5.0))
            result += weights(TIP + dx, dy)[..., None] * np.array([1.0, dx, dy])
    return result


def placed(rake):
    sums, nodes = np.zeros((COUNT_X * COUNT_Y, 3)), np.zeros(COUNT_X * COUNT_Y, dtype=np.int64)
    count = contact_cells.sum_tool(sums, nodes, wedge(rake), TIP, RIGHT, TOP, FRAME)
    return sums, nodes, count


@pytest.mark.parametrize("rake", [-20.0, 0.0, 30.0])
def test_tool_fills_two_cells_behind_both_faces(rake):
    sums, nodes, count = placed(rake)
    near = np.s_[:15, :20]  # where no particle is missing beyond the edges of the grid
    np.testing.assert_allclose(sums.reshape(COUNT_Y, COUNT_X, 3)[near], tool(rake)[near], atol=1e-11)
    assert set(nodes[:count]) == set(np.nonzero(sums[:, 0])[0])
    if rake == 0.0:
        assert sums.reshape(COUNT_Y, COUNT_X, 3)[10, 14, 0] == pytest.approx(4.0, rel=0.1)
    contact_cells.remove_tool(sums, nodes, count)
    assert not sums.any()


@pytest.mark.parametrize("body", [layout.CHIP, layout.BASE])
@pytest.mark.parametrize("rake", [-20.0, 30.0])
def test_nodes_touch_where_mean_positions_are_near(body, rake):
    rng = np.random.default_rng(3)
    x, y = rng.uniform(-4, 2, 150), rng.uniform(-3, 5, 150)
    points = fill_blocks(x, y, 0.25).ravel()
    near = np.concatenate([np.arange(64), 64 + np.arange(64), 128 + np.arange(22)])
    sums, nodes, count = placed(rake)
    marked, body_sums = np.zeros(COUNT_X * COUNT_Y, dtype=np.int64), np.zeros((COUNT_X * COUNT_Y, 2))
    found = contact_cells.mark_cells(
        marked, sums, nodes, count, body_sums, points, near, near.size, body, wedge(rake), TIP, FRAME
    )
    assert not body_sums.any()
    normal = np.array(normal_of(body, wedge(rake)))
    material = sum(weights(a, b)[..., None] * np.array([1.0, a - TIP, b]) for a, b in zip(x, y, strict=True))
    tools = sums.reshape(COUNT_Y, COUNT_X, 3)
    both = (material[..., 0] > 0) & (tools[..., 0] > 0)
    gap = np.full(both.shape, np.inf)
    gap[both] = (tools[both][:, 1:] / tools[both][:, :1] - material[both][:, 1:] / material[both][:, :1]) @ normal
    expected = set(np.flatnonzero(gap.ravel() < 0.8 * CELL) * layout.NODE)
    assert set(marked[:found]) == expected
    assert 0 < len(expected) < both.sum()
