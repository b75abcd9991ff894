"""Yield stress that tends to a limit, stress_saturation - (stress_saturation - stress_yield) exp(-eps/strain).

Voce (1948). With the equivalent trial stress q, yielding asks for w + log(w) = level, where

    w = gap + (increment of eps)/strain,    gap = (stress_saturation - q)/(3 shear strain),
    level = gap - (eps before)/strain + log((stress_saturation - stress_yield)/(3 shear strain)):

Wright's omega function, w = omega(level). Fixed numbers of steps of the fourth order settle it for every level
(Fritsch, Shafer & Crowley 1973, Comm. ACM 16, 123).
"""

import math
from typing import NamedTuple

from orthocut.kernels.elementary import exp, log
from orthocut.kernels.jit import inline
from orthocut.kernels.laws.mises import ROOT_2_3

_LEVEL_LOW = -600.0  # w is next to nothing from here on: the yield stress has reached its limit
_OMEGA_ZERO = 0.5671432904097838  # omega(0)


class Voce(NamedTuple):
    """Constants of the law."""

    stress_yield: float
    """Initial yield stress in tension [Pa]."""
    stress_saturation: float
    """Limit of the yield stress at large strains [Pa], above the initial one."""
    strain: float
    """Plastic strain in which the distance to the limit falls by a factor e."""


@inline
def _closer(w, level):
    """One step towards omega(level)."""
    rest = level - w - log(w)
    one = 1.0 + w
    two = 2.0 * one * (one + 2.0 / 3.0 * rest)
    return w + w * rest * (two - rest) / (one * (two - 2.0 * rest))


@inline
def multiplier(law, norm, shear, strain_plastic):
    """Plastic multiplier of an increment, see `orthocut.kernels.laws.hardening`."""
    stiffness = 3.0 * shear * law.strain
    gap = (law.stress_saturation - norm / ROOT_2_3) / stiffness
    hardening = log((law.stress_saturation - law.stress_yield) / stiffness)
    level = max(gap - strain_plastic / law.strain + hardening, _LEVEL_LOW)
    small = exp(min(level, 0.0))
    w = small / (1.0 + (1.0 / _OMEGA_ZERO - 1.0) * small) + 0.6 * max(level, 0.0)
    w = _closer(_closer(w, level), level)
    return max(w - gap, 0.0) * law.strain / ROOT_2_3


@inline
def energy_plastic(law, strain_plastic):
    """Integral of the yield stress over the plastic strain [J/m^3]."""
    missing = (law.stress_saturation - law.stress_yield) * law.strain
    return law.stress_saturation * strain_plastic + missing * math.expm1(-strain_plastic / law.strain)
