"""Hardening of the yield stress; the type of a law decides, when a kernel is compiled, whose formulas it holds.

Each law is a named tuple of constants in a file of its own, beside its functions. The functions here stand for those of
any law: in compiled code they are replaced by the ones of the law's type, in line, so that the loops over points
vectorise and no law pays for the others. To add a law, write its file and its row in `_LAWS`.
"""

from numba.extending import overload

from orthocut.kernels.laws import hardening_linear, hardening_ludwik, hardening_none, hardening_voce
from orthocut.kernels.laws.hardening_linear import Linear
from orthocut.kernels.laws.hardening_ludwik import Ludwik
from orthocut.kernels.laws.hardening_none import Elastic
from orthocut.kernels.laws.hardening_voce import Voce

Hardening = Linear | Ludwik | Voce | Elastic

_LAWS = {Linear: hardening_linear, Ludwik: hardening_ludwik, Voce: hardening_voce, Elastic: hardening_none}


def multiplier(law, norm, shear, strain_plastic):
    """Plastic multiplier that brings a trial state back to the yield surface.

    It solves norm - 2 shear m = sqrt(2/3) yield stress(strain_plastic + sqrt(2/3) m) for m.

    Parameters
    ----------
    law : Hardening
        Constants of a law.
    norm : float
        Norm of the deviatoric trial stress [Pa].
    shear : float
        Shear modulus times a third of the trace of the isochoric trial strain [Pa].
    strain_plastic : float
        Cumulative plastic strain before the increment.

    Returns
    -------
    float
        Plastic multiplier; zero where the trial state is elastic.
    """
    return _LAWS[type(law)].multiplier.py_func(law, norm, shear, strain_plastic)


def energy_plastic(law, strain_plastic):
    """Plastic work per initial volume [J/m^3], up to a part of second order in yield stress over shear modulus.

    It is the integral of the yield stress over the plastic strain.

    Parameters
    ----------
    law : Hardening
        Constants of a law.
    strain_plastic : float
        Cumulative plastic strain.
    """
    return _LAWS[type(law)].energy_plastic.py_func(law, strain_plastic)


@overload(multiplier, inline="always")
def _multiplier(law, norm, shear, strain_plastic):
    return _LAWS[law.instance_class].multiplier.py_func


@overload(energy_plastic, inline="always")
def _energy_plastic(law, strain_plastic):
    return _LAWS[law.instance_class].energy_plastic.py_func
