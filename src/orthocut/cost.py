"""Predicted cost of a case: run time on one core and memory. For schedules and the time left; never for results.

The costs are those of a core of a shared server whose other core is busy too. `benchmarks/cost_model.py` compares them
with what short cases take.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from orthocut.params.size import least_share, moving, particles, steps

if TYPE_CHECKING:
    from orthocut.params.case import Case
    from orthocut.params.dem import FlatJoint

_SECONDS_START = 0.1
_SECONDS_PER_STEP = 12e-6
"""Of a ductile cut: tool, nodes and what else does not grow with the points."""
_SECONDS_PER_POINT_STEP = {"consistent": 40e-9, "usavg": 80e-9}
_OVER_LINEAR = {"linear": 1.0, "none": 0.94, "voce": 1.36, "ludwik": 1.59}
"""Hardening law to the cost of a point over that with linear hardening."""
_LONGER, _LESS_LONG = 1.05, 6.2
"""Share of the steps beyond the least ones that a cut takes on average: the first less the second times its points
through the chip and the error at which it ends; by 774 cuts of the study nairn2015."""
_SECONDS_PER_DISC_STEP = {
    "dem_tension": 20e-9,
    "dem_compression": 26e-9,
    "dem_brazilian": 16e-9,
    "dem_toughness": 22e-9,
    "dem_cutting": 22.5e-9,
}
_LESS_DAMPING, _DAMPING = 0.3, 0.7
"""What a cut of glass costs more for each unit of damping below the usual one: more discs fly about."""
_SLIT = 1.2
"""Cost with slit or gapped joints over that without: they take the general path, as all do once joints break."""
_STRAIN_FLATTENED = 0.0045
"""Approach of the platens over the diameter at which a disc splits: mostly flattening, whatever the joints."""
_MB_PROCESS, _BYTES_PER_PARTICLE = 500, 8000


def estimate_seconds(case: Case) -> float:
    """Run time on one core, before the case has run [s]."""
    return seconds_of(case, expected_steps(case))


def seconds_of(case: Case, done: float) -> float:
    """Run time on one core of a run that took so many steps [s].

    Parameters
    ----------
    case : Case
    done : float
        Number of steps.
    """
    if case.kind != "mpm_cutting":
        return _SECONDS_START + done * particles(case) * _disc_step(case)
    each = _SECONDS_PER_POINT_STEP[case.numerics.scheme] * _OVER_LINEAR[case.material.hardening]
    return _SECONDS_START + done * (_SECONDS_PER_STEP + each * moving(case, done / case.steps))


def expected_steps(case: Case) -> float:
    """Number of steps, before the case has run."""
    if case.kind == "mpm_cutting":
        least = least_share(case)
        longer = _LONGER - _LESS_LONG * case.numerics.points_per_depth * case.error_target
        return case.steps * (least + (1 - least) * min(max(longer, 0.0), 1.0))
    return steps(case, 1.3 * _strain_at_failure(case) if case.kind != "dem_cutting" else math.inf)


def _disc_step(case: Case) -> float:
    """Cost of a disc and step [s]."""
    each = _SECONDS_PER_DISC_STEP[case.kind]
    if case.kind == "dem_cutting":
        each *= 1 + _LESS_DAMPING * max(_DAMPING - case.joint.damping, 0.0)
    return each * (_SLIT if case.joint.fraction_bonded < 1 else 1.0)


def _strain_at_failure(case: Case) -> float:
    """Axial strain at the peak of a test of glass, from the strengths of its joints."""
    if case.kind == "dem_brazilian":
        return _STRAIN_FLATTENED
    joint: FlatJoint = case.joint
    tension = min(0.57 * joint.strength_tensile, 0.86 * joint.cohesion)
    strength = 0.47 * joint.strength_tensile + 1.72 * joint.cohesion if case.kind == "dem_compression" else tension
    return strength / (0.9 * joint.modulus)


def estimate_memory(case: Case) -> int:
    """Memory of a process that runs the case [MB]."""
    return math.ceil(_MB_PROCESS + _BYTES_PER_PARTICLE * particles(case) / 1e6)
