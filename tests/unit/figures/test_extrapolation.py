"""Extrapolation to zero particle size: exact on exact data, honest errors."""

import numpy as np
import pytest

from orthocut.figures.extrapolation import extrapolate

SIZES = [1 / 5, 1 / 8, 1 / 12]


@pytest.mark.parametrize("power", [1.0, 2.0])
def test_exact_data_give_their_limit(power):
    fit = extrapolate(SIZES, [3.0 + 4.0 * size**power for size in SIZES], [0.01] * 3, power)
    assert fit.limit == pytest.approx(3.0)
    assert fit.slope == pytest.approx(4.0)
    assert fit.misfit == pytest.approx(0.0, abs=1e-20)
    np.testing.assert_allclose(fit.at([0.0, 0.2]), [3.0, 3.0 + 4.0 * 0.2**power])


def test_standard_error_is_that_of_many_repeats():
    random = np.random.default_rng(5)
    truth, errors = 3.0 + 4.0 * np.array(SIZES), np.array([0.1, 0.05, 0.08])
    limits = [extrapolate(SIZES, truth + errors * random.standard_normal(3), errors).limit for _ in range(4000)]
    assert extrapolate(SIZES, truth, errors).error == pytest.approx(np.std(limits), rel=0.05)


def test_scatter_beyond_the_errors_widens_the_error():
    straight = extrapolate(SIZES, [3.8, 3.5, 3.33], [0.02] * 3)
    bent = extrapolate(SIZES, [3.8, 3.3, 3.33], [0.02] * 3)
    assert bent.misfit > 1
    assert bent.error > 2 * straight.error


def test_unknown_and_tiny_errors_count_as_half_a_percent():
    values = [3.8, 3.5, 3.33]
    wanted = extrapolate(SIZES, values, [0.005 * value for value in values])
    assert extrapolate(SIZES, values, [np.nan, 0.0, 1e-9]) == wanted


def test_values_of_nothing_are_fitted_too():
    assert extrapolate(SIZES, [0.0, 0.0, 0.0], [np.nan] * 3).limit == 0.0
    assert extrapolate(SIZES[:2], [0.0, 3.0], [np.nan, np.nan]).limit == pytest.approx(8.0)


def test_two_sizes_leave_no_misfit_and_one_is_refused():
    assert np.isnan(extrapolate(SIZES[:2], [3.8, 3.5], [0.1, 0.1]).misfit)
    with pytest.raises(ValueError, match="two or more"):
        extrapolate([0.1, 0.1], [3.8, 3.5], [0.1, 0.1])
