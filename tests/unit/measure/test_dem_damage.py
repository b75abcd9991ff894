"""Damage of constructed lists of cracks."""

import numpy as np
import pytest

from orthocut.measure.dem_cracks import CrackList
from orthocut.measure.dem_damage import damage


def listed(heights, modes):
    zeros = np.zeros(len(heights))
    return CrackList(zeros, np.array(heights), zeros, zeros, np.array(modes, dtype=np.int8), zeros)


def test_only_cracks_below_the_cut_count():
    found = damage(listed([0.95, 0.92, 0.9, 0.8, 0.7, 0.85], [1, 0, 1, 1, 0, 1]), 0.9)
    assert (found.tension, found.shear) == (1, 2)
    assert found.depth == pytest.approx(0.2)


def test_a_single_deep_crack_hardly_moves_the_robust_depth():
    near = list(0.9 - np.linspace(0.001, 0.05, 99))
    with_one, without = damage(listed([*near, 0.1], [0] * 100), 0.9), damage(listed(near, [0] * 99), 0.9)
    assert with_one.depth == pytest.approx(0.8)
    assert with_one.depth_most == pytest.approx(without.depth_most, rel=0.03)


@pytest.mark.parametrize("heights", [[], [0.95, 0.91]])
def test_a_block_without_cracks_below_the_cut_is_undamaged(heights):
    assert damage(listed(heights, [1] * len(heights)), 0.9) == (0.0, 0.0, 0, 0)
