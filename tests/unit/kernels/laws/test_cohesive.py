"""Traction-separation laws: peak, stiffness, area, what unloading gives back."""

import numpy as np
import pytest
from scipy.integrate import quad

from orthocut.kernels.laws.cohesive import energy_dissipated, energy_released, traction_over_opening
from orthocut.mpm.laws import cohesion_of
from orthocut.params.cohesive import CohesiveZone

ZONES = [
    CohesiveZone(),
    *(CohesiveZone(law="triangular", peak_ratio=ratio) for ratio in (0.02, 0.1, 1 / 3, 0.9)),
]
every_zone = pytest.mark.parametrize("zone", ZONES, ids=lambda zone: f"{zone.law}-{zone.peak_ratio:.2g}")


def traction(zone, opening):
    return traction_over_opening(cohesion_of(zone).law, opening) * opening


def peak(zone):
    """Opening at the largest traction over the critical one."""
    return zone.peak_ratio if zone.law == "triangular" else 1 / 3


def test_critical_openings_of_the_paper():
    assert CohesiveZone().opening_critical == pytest.approx(0.0889e-3, abs=5e-8)
    assert CohesiveZone(law="triangular").opening_critical == pytest.approx(0.1e-3, rel=1e-12)


@every_zone
def test_largest_traction_is_the_strength(zone):
    openings = np.linspace(0, zone.opening_critical, 3001)
    tractions = np.array([traction(zone, opening) for opening in openings])
    assert tractions.max() == pytest.approx(zone.strength, rel=2e-3)
    assert traction(zone, peak(zone) * zone.opening_critical) == pytest.approx(zone.strength, rel=1e-12)
    assert openings[tractions.argmax()] / zone.opening_critical == pytest.approx(peak(zone), abs=1e-3)
    assert tractions[-1] == 0.0
    assert traction(zone, 2 * zone.opening_critical) == 0.0


@every_zone
def test_initial_slope_is_the_stiffness(zone):
    assert traction_over_opening(cohesion_of(zone).law, 0.0) == pytest.approx(zone.stiffness, rel=1e-12)


@every_zone
@pytest.mark.parametrize("fraction", [0.01, 0.1, 0.5, 1.0])
def test_released_energy_is_the_area_under_the_law(zone, fraction):
    end, top = fraction * zone.opening_critical, peak(zone) * zone.opening_critical
    pieces = ((0.0, min(end, top)), (min(end, top), end))
    area = sum(quad(lambda opening: traction(zone, opening), *piece)[0] for piece in pieces)
    assert energy_released(cohesion_of(zone).law, end) == pytest.approx(area, rel=1e-10)


@every_zone
@pytest.mark.parametrize("fraction", [0.0, 0.01, 0.1, 0.5, 0.95, 1.0, 2.0])
def test_dissipated_energy_is_the_area_less_what_unloading_gives_back(zone, fraction):
    opening, law = fraction * zone.opening_critical, cohesion_of(zone).law
    expected = energy_released(law, opening) - 0.5 * traction(zone, opening) * opening
    assert energy_dissipated(law, opening) == pytest.approx(expected, abs=1e-12 * zone.toughness)


@every_zone
def test_area_of_the_whole_law_is_the_toughness(zone):
    law = cohesion_of(zone).law
    for energy in (energy_released, energy_dissipated):
        assert energy(law, zone.opening_critical) == pytest.approx(zone.toughness, rel=1e-12)
        assert energy(law, 2 * zone.opening_critical) == pytest.approx(zone.toughness, rel=1e-12)
