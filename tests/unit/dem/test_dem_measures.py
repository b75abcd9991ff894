"""Measures of specimens and of fluctuating forces."""

import numpy as np
import pytest

from orthocut.measure.dem_energy import Forces
from orthocut.measure.specimen import elastic_constants, strains, stress_axial


@pytest.mark.parametrize(("low", "high"), [(1.0, 2.0), (0.3, 2.9), (1.2, 1.3)])
def test_stress_of_a_loaded_chain_does_not_depend_on_the_band(low, high):
    chain = np.arange(3)
    found = Forces(chain, chain + 1, np.tile([0.0, 6.0], (3, 1)), np.ones(3), 0.0)
    assert stress_axial(found, np.arange(4.0), low, high, width=2.0) == pytest.approx(3.0)


def test_strains_are_slopes_of_the_displacements_of_the_members_only():
    random = np.random.default_rng(1)
    initial = random.uniform(size=(50, 2))
    places = initial * [1 - 0.003, 1 + 0.01] + [5.0, -2.0]
    members = np.arange(50) < 40
    places[~members] += 100.0
    assert strains(initial, places, members) == pytest.approx((0.01, -0.003))


def test_elastic_constants_come_from_the_straight_part_before_the_peak():
    axial = np.linspace(0, 2e-3, 101)
    stress = 70e9 * axial
    stress[55:] += 1e10 * (axial[55:] - axial[55])
    stress[81:] = 0.0
    modulus, poisson = elastic_constants(stress, axial, -0.23 * axial)
    assert modulus == pytest.approx(70e9)
    assert poisson == pytest.approx(0.23)


def test_elastic_constants_of_too_few_samples_are_not_a_number():
    assert np.isnan(elastic_constants(np.array([0.0, 1.0]), np.array([0.0, 1.0]), np.zeros(2))).all()
