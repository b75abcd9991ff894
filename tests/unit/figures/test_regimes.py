"""Where a series of cuts turns from touching to bending."""

import math

import pytest

from orthocut.figures.regimes import transition


def test_lies_between_neighbours():
    found = transition([(3e-3, False), (1e-3, True), (2e-3, True), (2.1e-3, False)])
    assert (found.low, found.high, found.strays) == (2e-3, 2.1e-3, 0)
    assert found.found
    assert found.middle == pytest.approx(2.05e-3)
    assert found.half_width == pytest.approx(0.05e-3)
    assert found.standard_error == pytest.approx(0.1e-3 / math.sqrt(12))


@pytest.mark.parametrize(("touching", "low", "high"), [(True, 2e-3, math.inf), (False, 0.0, 1e-3)])
def test_one_regime_bounds_it_from_one_side(touching, low, high):
    found = transition([(1e-3, touching), (2e-3, touching)])
    assert (found.low, found.high) == (low, high)
    assert not found.found
    assert math.isnan(found.middle)
    assert math.isnan(found.half_width)


def test_strays_are_counted_and_do_not_move_it():
    cuts = [(1, True), (2, True), (3, False), (4, False), (5, True), (6, False)]
    assert transition(cuts) == (2, 3, 1)


def test_no_cuts():
    assert not transition([]).found
