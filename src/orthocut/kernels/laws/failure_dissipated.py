"""Failure when the energies that the largest openings so far have dissipated add up to the toughness.

The rule of the 2026 version of the program behind Nairn (2015). Each mode unloads on its own. What is left of the
tractions vanishes at once.
"""

from typing import NamedTuple

from orthocut.kernels.jit import inline
from orthocut.kernels.laws.cohesive import energy_dissipated


class Dissipated(NamedTuple):
    """The criterion has no constants."""


@inline
def damage(criterion, law, normal, tangent, peak_normal, peak_tangent):
    """Damage of a pair after it has opened, see `orthocut.kernels.laws.failure`."""
    critical = law.opening_critical
    peak_normal = max(peak_normal, normal)
    peak_tangent = max(peak_tangent, tangent)
    one = energy_dissipated(law, peak_normal)
    two = energy_dissipated(law, peak_tangent)
    failed = one + two >= energy_dissipated(law, critical) or peak_normal > critical or peak_tangent > critical
    return peak_normal, peak_tangent, one, two, failed
