"""Moment and areas against direct integration of the fibre stresses."""

import numpy as np
import pytest
from scipy.integrate import quad

from orthocut.theory import beam


def moment_by_fibres(k, r):
    """Moment over b h^2 sy/4 from stresses over the height; s is the strain over that at yield."""

    def stress(s):
        return s if s < 1 else 1 + r * (s - 1)

    edge = min(1.0, 1 / k)
    inner = quad(lambda y: stress(k * y) * y, 0, edge, epsabs=1e-14, epsrel=1e-13)[0]
    outer = quad(lambda y: stress(k * y) * y, edge, 1, epsabs=1e-14, epsrel=1e-13)[0]
    return 2 * (inner + outer)


@pytest.mark.parametrize("r", [0.0, 0.089, 0.5, 0.9])
@pytest.mark.parametrize("k", [0.3, 1.0, 1.2, 3.0, 11.0, 30.0])
def test_moment_and_areas_equal_direct_integration(k, r):
    # Areas carry M kappa per length: (b h^2 sy/4)(2 sy/(h E')) = b h sy^2/(2 E'), the unit of both areas.
    loading = quad(lambda x: moment_by_fibres(x, r), 0, k, points=[min(1.0, k)], epsabs=1e-12, epsrel=1e-12)[0]
    top = moment_by_fibres(k, r)
    unloading = top**2 / (2 * (2 / 3))

    assert beam.moment(k, r) == pytest.approx(top, rel=1e-10)
    assert beam.area_complementary(k, r) == pytest.approx(top * k - loading, rel=1e-9)
    assert beam.area_dissipated(k, r) == pytest.approx(loading - unloading, rel=1e-8, abs=1e-11)


def test_elastic_bending_dissipates_nothing():
    assert np.all(beam.area_dissipated(np.array([0.0, 0.5, 1.0]), 0.1) == 0)


def test_limit_moment_without_hardening_is_one():
    assert beam.moment(1e6, 0.0) == pytest.approx(1.0, abs=1e-11)
