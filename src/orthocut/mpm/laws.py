"""From the words of a case to the constants of its laws."""

from __future__ import annotations

from orthocut.kernels.laws.cohesive import Cubic, Triangular
from orthocut.kernels.laws.failure import Area, Coupled, Dissipated
from orthocut.kernels.laws.hardening import Elastic, Hardening, Linear, Ludwik, Voce
from orthocut.kernels.mpm.frame import Cohesion
from orthocut.params.cohesive import CohesiveZone
from orthocut.params.material import ElasticPlastic

_CRITERIA = {"area": Area(), "dissipated": Dissipated(), "coupled": Coupled()}


def hardening_of(material: ElasticPlastic) -> Hardening:
    """Hardening law of a material."""
    if material.hardening == "linear":
        return Linear(material.stress_yield, material.modulus_plastic)
    if material.hardening == "ludwik":
        return Ludwik(material.stress_yield, material.hardening_modulus, material.hardening_exponent)
    if material.hardening == "voce":
        return Voce(material.stress_yield, material.stress_saturation, material.strain_saturation)
    return Elastic()


def cohesion_of(zone: CohesiveZone) -> Cohesion:
    """Cohesive law and criterion of failure of an interface."""
    if zone.law == "triangular":
        law = Triangular(zone.opening_critical, zone.strength, zone.peak_ratio)
    else:
        law = Cubic(zone.opening_critical, zone.strength)
    return Cohesion(law, _CRITERIA[zone.failure_criterion])
