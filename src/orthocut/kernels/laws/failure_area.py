"""Failure when the areas under the law up to the present openings add up to the toughness (Nairn 2015, eq. 4).

Each mode unloads on its own. What is left of the tractions vanishes at once.
"""

from typing import NamedTuple

from orthocut.kernels.jit import inline
from orthocut.kernels.laws.cohesive import energy_released


class Area(NamedTuple):
    """The criterion has no constants."""


@inline
def damage(criterion, law, normal, tangent, peak_normal, peak_tangent):
    """Damage of a pair after it has opened, see `orthocut.kernels.laws.failure`."""
    critical = law.opening_critical
    one = energy_released(law, normal)
    two = energy_released(law, tangent)
    failed = one + two >= energy_released(law, critical) or normal > critical or tangent > critical
    return max(peak_normal, normal), max(peak_tangent, tangent), one, two, failed
