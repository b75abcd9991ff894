"""Confidence intervals against tables of Student's t, and their coverage."""

import math

import numpy as np
import pytest

from orthocut.figures.confidence import interval, needed, prediction, quantile, ratio


@pytest.mark.parametrize(("count", "value"), [(2, 12.706), (3, 4.303), (8, 2.365), (31, 2.042)])
def test_quantiles_are_those_of_the_tables(count, value):
    assert quantile(count) == pytest.approx(value, abs=5e-4)


def test_interval_of_the_papers_replicates():
    known = interval((14.15, 15.40, 15.38))
    assert known.mean == pytest.approx(14.977, abs=1e-3)
    assert known.half == pytest.approx(4.303 * known.spread / math.sqrt(3), rel=1e-4)
    assert known.count == 3


def test_interval_holds_the_truth_nineteen_times_in_twenty():
    random = np.random.default_rng(5)
    found = [interval(values) for values in random.normal(3.0, 1.0, (4000, 5))]
    share = np.mean([abs(one.mean - 3.0) < one.half for one in found])
    assert share == pytest.approx(0.95, abs=0.012)


def test_too_few_values_have_no_interval():
    assert interval([2.0]).mean == 2.0
    assert math.isnan(interval([2.0, math.nan]).half)
    assert math.isnan(interval([]).mean)
    assert math.isnan(needed([2.0], 0.1))
    assert math.isnan(prediction([2.0])[0])


def test_ratio_of_pairs_does_not_suffer_from_what_pairs_share():
    base = np.array([1.0, 2.0, 4.0, 8.0])
    assert ratio(3 * base, base).half == pytest.approx(0.0, abs=1e-12)
    assert ratio(3 * base, base).mean == pytest.approx(3.0)
    assert ratio(3 * base + [0.1, -0.1, 0.1, -0.1], base).half > 0
    assert math.isnan(ratio([], []).mean)
    assert math.isnan(ratio([1.0, 2.0], [0.0, 0.0]).mean)


def test_needed_replicates_reach_the_goal_and_one_less_does_not():
    values = [8.0, 12.0, 9.0, 11.0, 10.0, 14.0]
    count = int(needed(values, 0.1))
    known = interval(values)
    halves = [quantile(n) * known.spread / math.sqrt(n) / known.mean for n in (count - 1, count)]
    assert halves[0] > 0.1 >= halves[1]


def test_prediction_is_wider_than_the_interval_of_the_mean():
    values = [8.0, 12.0, 9.0, 11.0]
    low, high = prediction(values)
    known = interval(values)
    assert high - low == pytest.approx(2 * known.half * math.sqrt(5))
