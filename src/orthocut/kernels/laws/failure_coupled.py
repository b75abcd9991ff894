"""One damage for both modes, by the effective opening sqrt(normal^2 + tangent^2).

Camacho & Ortiz (1996), Int. J. Solids Structures 33, 2899, with equal weights of the modes. Both tractions are the
opening times the secant stiffness at the largest effective opening so far. The pair fails when that opening is the
critical one, where the tractions have vanished.
"""

import math
from typing import NamedTuple

from orthocut.kernels.jit import inline
from orthocut.kernels.laws.cohesive import energy_dissipated


class Coupled(NamedTuple):
    """The criterion has no constants."""


@inline
def damage(criterion, law, normal, tangent, peak_normal, peak_tangent):
    """Damage of a pair after it has opened, see `orthocut.kernels.laws.failure`.

    Both peaks are the largest effective opening. The energies are shared out by the present direction of the opening,
    which is exact on a straight path.
    """
    square = normal * normal + tangent * tangent
    peak = max(peak_normal, math.sqrt(square))
    energy = energy_dissipated(law, peak)
    one = energy * (normal * normal / max(square, 1e-300))
    return peak, peak, one, energy - one, peak >= law.opening_critical
