"""When a pair of the interface fails in mixed mode; criteria are chosen by type, as laws are.

A criterion has no constants: its type says it all.
"""

from numba.extending import overload

from orthocut.kernels.laws import failure_area, failure_coupled, failure_dissipated
from orthocut.kernels.laws.failure_area import Area
from orthocut.kernels.laws.failure_coupled import Coupled
from orthocut.kernels.laws.failure_dissipated import Dissipated

Criterion = Area | Dissipated | Coupled

_CRITERIA = {Area: failure_area, Dissipated: failure_dissipated, Coupled: failure_coupled}


def damage(criterion, law, normal, tangent, peak_normal, peak_tangent):
    """Damage of a pair after it has opened.

    Parameters
    ----------
    criterion : Criterion
        Criterion of failure.
    law : CohesiveLaw
        Constants of the cohesive law.
    normal, tangent : float
        Magnitude of the opening in each mode [m]; a closed pair has no normal one.
    peak_normal, peak_tangent : float
        Openings that set the secant stiffness of each mode, before [m].

    Returns
    -------
    peak_normal, peak_tangent : float
        These openings now [m].
    one, two : float
        Energies of each mode that count for failure [J/m^2].
    failed : bool
        Whether the pair fails.
    """
    return _CRITERIA[type(criterion)].damage.py_func(criterion, law, normal, tangent, peak_normal, peak_tangent)


@overload(damage, inline="always")
def _damage(criterion, law, normal, tangent, peak_normal, peak_tangent):
    return _CRITERIA[criterion.instance_class].damage.py_func
