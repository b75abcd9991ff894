"""Yield stress that grows by a power of the plastic strain, stress_yield + modulus eps^exponent (Ludwik 1909).

Its slope is infinite at zero strain. With the plastic strain eps after the increment as the unknown, yielding asks for

    3 shear eps + modulus eps^exponent = total,    total = trial stress - stress_yield + 3 shear (eps before),

where the stresses are equivalent ones. In y = log(eps) the logarithm of the left side is smooth and nearly straight
whatever the exponent, so that Halley's steps from a bound above settle it: no slope is ever infinite, and an increment
that starts at zero strain is like any other.
"""

import math
from typing import NamedTuple

from orthocut.kernels.elementary import exp, log
from orthocut.kernels.jit import inline
from orthocut.kernels.laws.mises import ROOT_2_3


class Ludwik(NamedTuple):
    """Constants of the law."""

    stress_yield: float
    """Initial yield stress in tension [Pa]."""
    modulus: float
    """Factor of the power of the plastic strain [Pa]."""
    exponent: float
    """Power of the plastic strain, above 0 and up to 1."""


@inline
def _closer(y, bound_elastic, bound_plastic, exponent):
    """One step of Halley for exp(y - bound_elastic) + exp(exponent (y - bound_plastic)) = 1, in logarithms.

    The logarithm of the sum, which is 1 to 2 at the start, stands as 2 (sum - 1)/(sum + 1), which has the same root.
    """
    elastic = exp(y - bound_elastic)
    plastic = exp(exponent * (y - bound_plastic))
    total = elastic + plastic
    slope = elastic + exponent * plastic  # times the sum
    bend = (1.0 - exponent) * (1.0 - exponent) * elastic * plastic  # times the square of the sum
    return y - 2.0 * (total - 1.0) * total * slope / ((total + 1.0) * slope * slope - (total - 1.0) * bend)


@inline
def multiplier(law, norm, shear, strain_plastic):
    """Plastic multiplier of an increment, see `orthocut.kernels.laws.hardening`."""
    total = norm / ROOT_2_3 - law.stress_yield + 3.0 * shear * strain_plastic
    positive = max(total, 1e-20)  # Pa; where there is no plastic strain, any number will do
    bound_elastic = log(positive / (3.0 * shear))
    bound_plastic = log(positive / law.modulus) / law.exponent
    y = min(bound_elastic, bound_plastic)
    y = _closer(y, bound_elastic, bound_plastic, law.exponent)
    y = _closer(y, bound_elastic, bound_plastic, law.exponent)
    y = _closer(y, bound_elastic, bound_plastic, law.exponent)
    y = _closer(y, bound_elastic, bound_plastic, law.exponent)
    change = exp(y) - strain_plastic if total > 0.0 else 0.0
    return max(change, 0.0) / ROOT_2_3


@inline
def energy_plastic(law, strain_plastic):
    """Integral of the yield stress over the plastic strain [J/m^3]."""
    power = law.modulus * math.pow(strain_plastic, law.exponent)
    return strain_plastic * (law.stress_yield + power / (1.0 + law.exponent))
