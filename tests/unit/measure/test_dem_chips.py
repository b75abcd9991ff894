"""Chips of constructed scenes: rows of discs, some joints broken."""

import numpy as np
import pytest

from orthocut.measure.dem_chips import chips, fragments

FIRST, SECOND = np.arange(7), np.arange(1, 8)
WHOLE = np.ones(7)
RADIUS = np.array([1.0, 1.0, 1.0, 2.0, 1.0, 1.0, 1.0, 3.0])


def broken(*joints):
    intact = np.ones(7)
    intact[list(joints)] = 0.0
    return intact


def test_fragments_are_what_intact_joints_connect():
    assert len(set(fragments(FIRST, SECOND, WHOLE, 8))) == 1
    number = fragments(FIRST, SECOND, broken(2, 5), 8)
    assert [len(set(number[part])) for part in (slice(0, 3), slice(3, 6), slice(6, 8))] == [1, 1, 1]
    assert len(set(number)) == 3
    half = broken(2, 5)
    half[2] = 0.5
    assert len(set(fragments(FIRST, SECOND, half, 8))) == 2


def test_chips_hold_no_fixed_disc_and_the_largest_comes_first():
    found = chips(FIRST, SECOND, broken(1, 4), WHOLE, RADIUS, np.array([0]))
    assert found.areas == pytest.approx(np.pi * np.array([1 + 1 + 9, 1 + 4 + 1]))
    assert (found.grains, found.grain_area) == (0, 0.0)


def test_single_discs_are_grains():
    found = chips(FIRST, SECOND, broken(2, 3, 6), WHOLE, RADIUS, np.array([0]))
    assert found.areas == pytest.approx([3 * np.pi])
    assert found.grains == 2
    assert found.grain_area == pytest.approx(np.pi * (4 + 9))


def test_discs_without_joints_before_the_cut_are_no_chips():
    found = chips(FIRST[:6], SECOND[:6], WHOLE[:6], WHOLE[:6], RADIUS, np.array([0]))
    assert (len(found.areas), found.grains) == (0, 0)
    slit = np.ones(6)
    slit[0] = 0.0
    found = chips(FIRST[:6], SECOND[:6], slit, slit, RADIUS, np.array([6]))
    assert (len(found.areas), found.grains) == (0, 0)


def test_all_fragments_with_a_fixed_disc_belong_to_the_block():
    found = chips(FIRST, SECOND, broken(3), WHOLE, RADIUS, np.array([0, 7]))
    assert len(found.areas) == 0
