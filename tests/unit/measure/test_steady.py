"""Means of signals with memory, their errors and drifts."""

import numpy as np
import pytest

from orthocut.measure.steady import Mean, block_mean, is_known, steady_from


def test_error_of_the_mean_agrees_with_the_scatter_of_many_signals_with_memory():
    random = np.random.default_rng(3)
    noise = random.normal(size=(400, 520))
    signals = [np.convolve(row, np.ones(10) / 10, mode="valid")[:500] for row in noise]
    found = [block_mean(signal) for signal in signals]
    scatter = np.std([mean.value for mean in found])
    assert np.sqrt(np.mean([mean.error**2 for mean in found])) == pytest.approx(scatter, rel=0.15)


def test_constant_signal_has_neither_error_nor_drift():
    mean = block_mean(np.full(500, 7.0))
    assert mean.value == 7.0
    assert mean.error == 0.0
    assert mean.drift == pytest.approx(0.0, abs=1e-12)


def test_drift_is_the_rise_over_the_window_in_units_of_the_mean():
    assert block_mean(np.linspace(8.0, 12.0, 300)).drift == pytest.approx(0.4, rel=1e-9)


def test_too_few_samples_have_no_mean():
    assert np.isnan(block_mean(np.ones(5))).all()


def test_steady_part_leaves_out_a_start_that_differs():
    noise = np.random.default_rng(3).normal(size=300)
    values = 10.0 + 0.1 * noise
    values[:100] += np.linspace(5.0, 0.0, 100)
    assert 70 <= steady_from(values) <= 150
    assert steady_from(10.0 + 0.1 * noise) <= 150
    assert steady_from(values[:10]) == 0


@pytest.mark.parametrize(
    ("error", "drift", "known"), [(0.05, 0.01, True), (0.15, 0.01, False), (0.05, 0.03, False), (0.05, -0.03, False)]
)
def test_mean_is_known_when_error_and_drift_are_small(error, drift, known):
    assert is_known(Mean(10.0, error, drift), 0.01) is known
