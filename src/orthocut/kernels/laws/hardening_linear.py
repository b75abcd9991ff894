"""Yield stress that grows linearly with the plastic strain, stress_yield + modulus_plastic eps (Nairn 2015, eq. 2)."""

from typing import NamedTuple

from orthocut.kernels.jit import inline
from orthocut.kernels.laws.mises import ROOT_2_3


class Linear(NamedTuple):
    """Constants of the law."""

    stress_yield: float
    """Initial yield stress in tension [Pa]."""
    modulus_plastic: float
    """Slope of yield stress over plastic strain [Pa]."""


@inline
def multiplier(law, norm, shear, strain_plastic):
    """Plastic multiplier of an increment, see `orthocut.kernels.laws.hardening`."""
    excess = norm - ROOT_2_3 * (law.stress_yield + law.modulus_plastic * strain_plastic)
    return max(excess, 0.0) / (2.0 * shear + 2.0 / 3.0 * law.modulus_plastic)


@inline
def energy_plastic(law, strain_plastic):
    """Integral of the yield stress over the plastic strain [J/m^3]."""
    return strain_plastic * (law.stress_yield + 0.5 * law.modulus_plastic * strain_plastic)
