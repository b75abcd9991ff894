"""No yielding: the material stays elastic."""

from typing import NamedTuple

from orthocut.kernels.jit import inline


class Elastic(NamedTuple):
    """The law has no constants."""


@inline
def multiplier(law, norm, shear, strain_plastic):
    """Plastic multiplier of an increment, always zero: the compiler drops most of what follows a yielding state."""
    return 0.0


@inline
def energy_plastic(law, strain_plastic):
    """Plastic work [J/m^3], always zero."""
    return 0.0
