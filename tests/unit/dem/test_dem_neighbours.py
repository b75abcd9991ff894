"""Searches find what brute force finds."""

import numpy as np
import pytest

from orthocut.dem.pairs import close_pairs
from orthocut.kernels.dem.integrate import count_strays
from orthocut.kernels.dem.neighbours import find_pairs
from orthocut.kernels.dem.walls import wedge_distance


def brute_force(x, y, radius, skin):
    distance = np.hypot(x[:, None] - x, y[:, None] - y)
    close = distance < radius[:, None] + radius + skin
    return {(i, j) for i, j in zip(*np.nonzero(close), strict=True) if i < j}


@pytest.mark.parametrize("spread", [1.0, 1.5])
def test_pairs_agree_with_brute_force_inside_and_outside_the_grid(spread):
    random = np.random.default_rng(3)
    n = 300
    x, y = random.uniform(-2 * (spread - 1), 20 * spread, (2, n))
    radius = random.uniform(0.5, 0.9, n)
    skin, size, cells = 0.3, 2.2, 10
    position = np.column_stack([x, y, np.zeros(n), np.zeros(n)]).ravel()
    start, second = np.zeros(n + 1, dtype=np.int64), np.zeros(20 * n, dtype=np.int64)
    scratch = (np.zeros(cells * cells + 1, dtype=np.int64), *np.zeros((2, n), dtype=np.int64))
    grid = (0.0, 0.0, size, cells, cells)
    count = find_pairs(start, second, *scratch, position, radius, skin, grid)
    owner = np.repeat(np.arange(n), np.diff(start))
    found = set(zip(owner.tolist(), second[:count].tolist(), strict=True))
    assert found == brute_force(x, y, radius, skin)
    assert find_pairs(start, second[:5], *scratch, position, radius, skin, grid) == -1


@pytest.mark.parametrize(("lost", "expected"), [(np.nan, -1), (np.inf, 0), (-np.inf, 0), (1e300, 0), (-1e300, 0)])
@pytest.mark.parametrize("axis", [0, 1])
def test_search_with_a_lost_disc_stays_inside_its_arrays(lost, expected, axis):
    n, cells = 4, 3
    position = np.array([[1.0, 1.0, 0, 0], [4.0, 1.0, 0, 0], [1.0, 4.0, 0, 0], [4.0, 4.0, 0, 0]])
    position[1, axis] = lost
    memory = np.full(3 * 40, 99, dtype=np.int64)
    start, second, cell_start = (memory[40 * k + 10 :][:size] for k, size in enumerate((n + 1, 8, cells * cells + 1)))
    scratch = np.zeros((2, n), dtype=np.int64)
    grid = (0.0, 0.0, 2.0, cells, cells)
    found = find_pairs(start, second, cell_start, *scratch, position.ravel(), np.full(n, 0.5), 0.3, grid)
    assert found == expected
    outside = np.ones(memory.size, dtype=bool)
    for k, size in enumerate((n + 1, 8, cells * cells + 1)):
        outside[40 * k + 10 : 40 * k + 10 + size] = False
    assert (memory[outside] == 99).all()


def test_a_disc_whose_place_is_not_a_number_has_strayed():
    position = np.zeros(12)
    assert count_strays(position, np.zeros(12), 1.0) == 0
    position[4] = np.nan
    position[9] = 2.0
    assert count_strays(position, np.zeros(12), 1.0) == 2


def test_touching_pairs_agree_with_brute_force():
    random = np.random.default_rng(4)
    x, y = random.uniform(0, 10, (2, 200))
    radius = random.uniform(0.2, 0.5, 200)
    pairs = close_pairs(x, y, radius)
    assert set(map(tuple, pairs.tolist())) == brute_force(x, y, radius, 0.0)
    assert pairs.tolist() == sorted(pairs.tolist())


@pytest.mark.parametrize(("rake", "clearance"), [(-15, 15), (30, 5), (50, 10), (-40, 3), (0, 0)])
def test_distance_to_a_wedge_is_that_of_its_closest_point(rake, clearance):
    rake, clearance = np.radians([rake, clearance])
    first, second = (-np.cos(rake), np.sin(rake)), (np.sin(clearance), -np.cos(clearance))
    along = np.linspace(0, 30, 30_001)
    face = np.concatenate(
        [np.outer(along, [np.sin(rake), np.cos(rake)]), np.outer(along, [np.cos(clearance), np.sin(clearance)])]
    )
    random = np.random.default_rng(5)
    kinds = set()
    for point in random.uniform(-3, 3, (200, 2)):
        distance, *normal = wedge_distance.py_func(*point, *first, *second)
        squares = np.sum((face - point) ** 2, axis=1)
        nearest = face[np.argmin(squares)]
        inside = point @ first < 0 and point @ second < 0
        assert distance == pytest.approx((-1 if inside else 1) * np.sqrt(squares.min()), abs=2e-3)
        assert np.hypot(*normal) == pytest.approx(1)
        assert point - distance * np.array(normal) == pytest.approx(nearest, abs=3e-2)
        kinds.add("inside" if inside else "tip" if np.hypot(*nearest) < 1e-9 else "face")
    assert kinds == {"inside", "tip", "face"}


def test_plane_wall_is_a_wedge_with_equal_normals():
    assert wedge_distance.py_func(3.0, -2.0, 0.0, 1.0, 0.0, 1.0) == (-2.0, 0.0, 1.0)
