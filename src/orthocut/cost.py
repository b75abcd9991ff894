"""Predicted cost of a case: run time on one core and memory. For schedules and the time left; never for results."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from orthocut.params.case import Case

_SECONDS_PER_POINT_STEP = 36e-9
_SECONDS_PER_DISC_STEP = {"dem_tension": 40e-9, "dem_compression": 40e-9, "dem_cutting": 80e-9}
_STRAIN_AT_END = {"dem_tension": 1.2e-3, "dem_compression": 4.5e-3}
_SECONDS_START = 0.3
_SOLID_FRACTION = 0.9
_MB_PROCESS, _BYTES_PER_PARTICLE = 500, 8000


def particles(case: Case) -> float:
    """Number of material points or, about, of discs."""
    if case.kind == "mpm_cutting":
        work = case.workpiece
        return work.length_ratio * (1 + work.base_ratio) * case.numerics.points_per_depth**2
    packing = case.packing
    mean_square = packing.radius_min**2 * (1 + packing.radius_ratio + packing.radius_ratio**2) / 3
    return _SOLID_FRACTION * packing.width * packing.height / (math.pi * mean_square)


def steps(case: Case) -> float:
    """Number of time steps; for tests of glass, until it usually breaks."""
    if case.kind == "mpm_cutting":
        return case.steps
    joint = case.joint
    step = joint.time_step_factor * case.packing.radius_min * (math.pi * joint.density / joint.modulus) ** 0.5
    if case.kind == "dem_cutting":
        return case.travel / case.cut_speed / step
    strain = min(case.strain_max, _STRAIN_AT_END[case.kind])
    return strain * case.packing.height / (2 * case.grip_speed) / step


def estimate_seconds(case: Case) -> float:
    """Run time on one core of the machine that the costs of a step were measured on [s]."""
    each = _SECONDS_PER_POINT_STEP if case.kind == "mpm_cutting" else _SECONDS_PER_DISC_STEP[case.kind]
    return _SECONDS_START + particles(case) * steps(case) * each


def estimate_memory(case: Case) -> int:
    """Memory of a process that runs the case [MB]."""
    return math.ceil(_MB_PROCESS + _BYTES_PER_PARTICLE * particles(case) / 1e6)
