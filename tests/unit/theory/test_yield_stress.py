"""Yield stress over plastic strain, against the compiled laws and values by hand."""

import numpy as np
import pytest

from orthocut.params.material import ElasticPlastic
from orthocut.theory.hardening import yield_stress

STRAIN = np.array([0.0, 0.1, 0.5])


@pytest.mark.parametrize(
    ("fields", "wanted"),
    [
        ({"hardening": "none"}, [np.inf, np.inf, np.inf]),
        ({"modulus_tangent": "0 MPa"}, [25e6, 25e6, 25e6]),
        (
            {"hardening": "ludwik", "hardening_modulus": "40 MPa", "hardening_exponent": 0.5},
            [25e6, 25e6 + 40e6 * 0.1**0.5, 25e6 + 40e6 * 0.5**0.5],
        ),
        (
            {"hardening": "voce", "stress_saturation": "60 MPa", "strain_saturation": 0.1},
            [25e6, 60e6 - 35e6 * np.exp(-1), 60e6 - 35e6 * np.exp(-5)],
        ),
    ],
)
def test_yield_stress(fields, wanted):
    assert yield_stress(ElasticPlastic(**fields), STRAIN) == pytest.approx(wanted)


def test_linear_hardening_has_the_tangent_modulus_in_uniaxial_tension():
    material = ElasticPlastic(modulus_tangent="100 MPa")
    stress = yield_stress(material, STRAIN)
    strain = stress / material.modulus_young + STRAIN
    assert np.diff(stress) / np.diff(strain) == pytest.approx(100e6)
