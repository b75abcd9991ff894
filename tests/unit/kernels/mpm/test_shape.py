"""uGIMP weights against their textbook form and the sums that they must keep."""

import numpy as np
import pytest

from orthocut.kernels.mpm.shape import gimp_weights, nearest_node

weights = gimp_weights.py_func
HALF_WIDTHS = [0.5, 0.25, 1 / 6, 0.125]
"""Of points that stand one to four in a row along a cell."""


def textbook(r, half_width):
    """Weight and slope of one node at distance r (cells), Bardenhagen & Kober (2004)."""
    a = abs(r)
    if a < half_width:
        return 1 - (r**2 + half_width**2) / (2 * half_width), -r / half_width
    if a < 1 - half_width:
        return 1 - a, -np.sign(r)
    if a < 1 + half_width:
        return (1 + half_width - a) ** 2 / (4 * half_width), -np.sign(r) * (1 + half_width - a) / (2 * half_width)
    return 0.0, 0.0


@pytest.mark.parametrize("half_width", HALF_WIDTHS)
@pytest.mark.parametrize("r", np.linspace(-0.5, 0.5, 41))
def test_weights_are_the_textbook_ones(r, half_width):
    result = np.array(weights(r, half_width))
    expected = np.array([textbook(r + k, half_width) for k in (1, 0, -1)]).T.ravel()
    np.testing.assert_allclose(result, expected, atol=1e-15)


@pytest.mark.parametrize("half_width", HALF_WIDTHS)
@pytest.mark.parametrize("r", np.random.default_rng(1).uniform(-0.5, 0.5, 20))
def test_weights_reproduce_constants_and_places(r, half_width):
    *w, g0, g1, g2 = weights(r, half_width)
    places = np.array([-1.0, 0.0, 1.0])
    assert sum(w) == pytest.approx(1.0, abs=1e-15)
    assert g0 + g1 + g2 == pytest.approx(0.0, abs=1e-15)
    assert w @ places == pytest.approx(r, abs=1e-15)
    assert np.array([g0, g1, g2]) @ places == pytest.approx(1.0, abs=1e-15)


def test_nearest_node_stays_inside_the_grid():
    assert nearest_node.py_func(3.4, 10) == 3
    assert nearest_node.py_func(3.6, 10) == 4
    assert nearest_node.py_func(-7.0, 10) == 1
    assert nearest_node.py_func(99.0, 10) == 8
