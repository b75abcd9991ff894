"""Traction-separation law of an interface; its type decides, when a kernel is compiled, whose formulas that holds.

Laws and functions are arranged as those of `orthocut.kernels.laws.hardening`.
"""

from numba.extending import overload

from orthocut.kernels.laws import cohesive_cubic, cohesive_triangular
from orthocut.kernels.laws.cohesive_cubic import Cubic
from orthocut.kernels.laws.cohesive_triangular import Triangular

CohesiveLaw = Cubic | Triangular

_LAWS = {Cubic: cohesive_cubic, Triangular: cohesive_triangular}


def traction_over_opening(law, opening_peak):
    """Secant stiffness: traction at the largest opening so far over that opening.

    Parameters
    ----------
    law : CohesiveLaw
        Constants of a law.
    opening_peak : float
        Largest magnitude of the opening so far [m].

    Returns
    -------
    float
        Secant stiffness [Pa/m].
    """
    return _LAWS[type(law)].traction_over_opening.py_func(law, opening_peak)


def energy_released(law, opening):
    """Area under a law up to an opening [m] that only grew [J/m^2]."""
    return _LAWS[type(law)].energy_released.py_func(law, opening)


def energy_dissipated(law, opening_peak):
    """Part of the area up to the largest opening so far [m] that unloading does not give back [J/m^2]."""
    return _LAWS[type(law)].energy_dissipated.py_func(law, opening_peak)


@overload(traction_over_opening, inline="always")
def _traction_over_opening(law, opening_peak):
    return _LAWS[law.instance_class].traction_over_opening.py_func


@overload(energy_released, inline="always")
def _energy_released(law, opening):
    return _LAWS[law.instance_class].energy_released.py_func


@overload(energy_dissipated, inline="always")
def _energy_dissipated(law, opening_peak):
    return _LAWS[law.instance_class].energy_dissipated.py_func
