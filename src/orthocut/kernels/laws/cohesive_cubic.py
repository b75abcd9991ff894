"""Cubic traction-separation law with unloading to the origin.

Nairn (2015), eqs (3) and (4); Needleman (1987). The law is the same in both modes.
"""

from orthocut.kernels.jit import inline


@inline
def traction_over_opening(opening_peak, opening_critical, strength):
    """Secant stiffness: traction at the largest opening so far over that opening.

    Parameters
    ----------
    opening_peak : float
        Largest magnitude of the opening so far [m].
    opening_critical : float
        Opening at which the traction vanishes [m].
    strength : float
        Cohesive stress, the largest traction [Pa].

    Returns
    -------
    float
        Secant stiffness [Pa/m].
    """
    d = min(opening_peak / opening_critical, 1.0)
    return 6.75 * strength / opening_critical * (1.0 - d) * (1.0 - d)


@inline
def energy_released(opening, opening_critical, strength):
    """Area under the law up to an opening [J/m^2]."""
    d = min(opening / opening_critical, 1.0)
    return 0.5625 * strength * opening_critical * d * d * (6.0 + d * (3.0 * d - 8.0))
