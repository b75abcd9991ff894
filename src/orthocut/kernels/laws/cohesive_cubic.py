"""Cubic traction-separation law with unloading to the origin.

Nairn (2015), eqs (3) and (4); Needleman (1987). The law is the same in both modes.
"""

from typing import NamedTuple

from orthocut.kernels.jit import inline


class Cubic(NamedTuple):
    """Constants of the law."""

    opening_critical: float
    """Opening at which the traction vanishes [m]."""
    strength: float
    """Cohesive stress, the largest traction, at a third of that opening [Pa]."""


@inline
def traction_over_opening(law, opening_peak):
    """Secant stiffness [Pa/m], see `orthocut.kernels.laws.cohesive`."""
    d = min(opening_peak / law.opening_critical, 1.0)
    return 6.75 * law.strength / law.opening_critical * (1.0 - d) * (1.0 - d)


@inline
def energy_released(law, opening):
    """Area under the law up to an opening [J/m^2]."""
    d = min(opening / law.opening_critical, 1.0)
    return 0.5625 * law.strength * law.opening_critical * d * d * (6.0 + d * (3.0 * d - 8.0))


@inline
def energy_dissipated(law, opening_peak):
    """Area under the law less the triangle below the line of unloading [J/m^2]."""
    d = min(opening_peak / law.opening_critical, 1.0)
    return 0.5625 * law.strength * law.opening_critical * d * d * d * (4.0 - 3.0 * d)
