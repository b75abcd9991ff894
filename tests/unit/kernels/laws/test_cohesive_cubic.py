"""Cubic traction-separation law: peak, area, unloading."""

import numpy as np
import pytest
from scipy.integrate import quad

from orthocut.kernels.laws.cohesive_cubic import energy_released, traction_over_opening
from orthocut.params.cohesive import CohesiveZone

ZONE = CohesiveZone()
CRITICAL, STRENGTH = ZONE.opening_critical, ZONE.strength


def traction(opening):
    return traction_over_opening.py_func(opening, CRITICAL, STRENGTH) * opening


def test_critical_opening_of_the_paper():
    assert pytest.approx(0.0889e-3, abs=5e-8) == CRITICAL


def test_peak_is_the_strength_at_a_third_of_the_critical_opening():
    openings = np.linspace(0, CRITICAL, 3001)
    tractions = np.array([traction(opening) for opening in openings])
    assert tractions.max() == pytest.approx(STRENGTH, rel=1e-6)
    assert openings[tractions.argmax()] == pytest.approx(CRITICAL / 3, rel=1e-3)
    assert tractions[-1] == 0.0


@pytest.mark.parametrize("fraction", [0.1, 0.5, 1.0])
def test_released_energy_is_the_area_under_the_law(fraction):
    area, _ = quad(traction, 0, fraction * CRITICAL)
    assert energy_released.py_func(fraction * CRITICAL, CRITICAL, STRENGTH) == pytest.approx(area, rel=1e-10)


def test_area_of_the_whole_law_is_the_toughness():
    assert energy_released.py_func(CRITICAL, CRITICAL, STRENGTH) == pytest.approx(ZONE.toughness, rel=1e-12)
    assert energy_released.py_func(2 * CRITICAL, CRITICAL, STRENGTH) == pytest.approx(ZONE.toughness, rel=1e-12)
