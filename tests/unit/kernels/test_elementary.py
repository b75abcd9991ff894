"""Exponential and logarithm against those of numpy."""

import math

import numpy as np
import pytest

from orthocut.kernels.elementary import exp, log
from orthocut.kernels.jit import jit


@jit
def exps(x, result):
    for i in range(x.size):
        result[i] = exp(x[i])


@jit
def logs(x, result):
    for i in range(x.size):
        result[i] = log(x[i])


def compiled(function, x):
    result = np.empty_like(x)
    function(x, result)
    return result


@pytest.mark.parametrize(("size", "error"), [(1.0, 5e-16), (20.0, 1e-15), (700.0, 3e-14)])
def test_exponential(size, error):
    x = np.linspace(-size, size, 100_001)
    np.testing.assert_allclose(compiled(exps, x), np.exp(x), rtol=error, atol=0)


def test_exponential_stays_finite():
    with np.errstate(all="raise"):
        low, high = compiled(exps, np.array([-math.inf, math.inf]))
    assert 0.0 < low < 1e-300
    assert 1e300 < high < math.inf


@pytest.mark.parametrize("x", [np.linspace(0.2, 3.0, 100_001), np.geomspace(1e-307, 1e307, 100_001)])
def test_logarithm(x):
    np.testing.assert_allclose(compiled(logs, x), np.log(x), rtol=1e-15, atol=0)


def test_plain_python_agrees():
    assert exp.py_func(1.0) == pytest.approx(math.e, rel=1e-15)
    assert log.py_func(10.0) == pytest.approx(math.log(10.0), rel=1e-15)
