"""Triangular traction-separation law: a straight rise, a straight fall to zero, and unloading to the origin.

Nairn (2015) used it beside the cubic law. It is the same in both modes.
"""

from typing import NamedTuple

from orthocut.kernels.jit import inline


class Triangular(NamedTuple):
    """Constants of the law."""

    opening_critical: float
    """Opening at which the traction vanishes [m]."""
    strength: float
    """Cohesive stress, the largest traction [Pa]."""
    peak_ratio: float
    """Opening at the largest traction over the critical one, above 0 and below 1."""


@inline
def traction_over_opening(law, opening_peak):
    """Secant stiffness [Pa/m], see `orthocut.kernels.laws.cohesive`."""
    d = min(max(opening_peak / law.opening_critical, law.peak_ratio), 1.0)
    return law.strength / law.opening_critical * (1.0 - d) / ((1.0 - law.peak_ratio) * d)


@inline
def energy_released(law, opening):
    """Area under the law up to an opening [J/m^2]."""
    d = opening / law.opening_critical
    rise = min(d, law.peak_ratio)
    left = 1.0 - min(max(d, law.peak_ratio), 1.0)
    falling = 1.0 - law.peak_ratio - left * left / (1.0 - law.peak_ratio)
    return 0.5 * law.strength * law.opening_critical * (rise * rise / law.peak_ratio + falling)


@inline
def energy_dissipated(law, opening_peak):
    """Area under the law less the triangle below the line of unloading [J/m^2]."""
    d = min(max(opening_peak / law.opening_critical, law.peak_ratio), 1.0)
    return 0.5 * law.strength * law.opening_critical * (d - law.peak_ratio) / (1.0 - law.peak_ratio)
