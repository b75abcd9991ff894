"""Predicted cost of a case: run time on one core and memory. For schedules and the time left; never for results."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from orthocut.params.size import moving, particles, steps

if TYPE_CHECKING:
    from orthocut.params.case import Case

_SECONDS_PER_POINT_STEP = {"consistent": 35e-9, "usavg": 67e-9}
_SECONDS_PER_DISC_STEP = {"dem_tension": 20e-9, "dem_compression": 26e-9, "dem_brazilian": 20e-9, "dem_cutting": 30e-9}
_STRAIN_AT_END = {"dem_tension": 1.2e-3, "dem_compression": 4.5e-3, "dem_brazilian": 4e-3}
_SECONDS_START = 0.3
_MB_PROCESS, _BYTES_PER_PARTICLE = 500, 8000


def estimate_seconds(case: Case) -> float:
    """Run time on one core of the machine that the costs of a step were measured on [s]."""
    cut = case.kind == "mpm_cutting"
    each = _SECONDS_PER_POINT_STEP[case.numerics.scheme] if cut else _SECONDS_PER_DISC_STEP[case.kind]
    return _SECONDS_START + moving(case) * steps(case, _STRAIN_AT_END.get(case.kind, math.inf)) * each


def estimate_memory(case: Case) -> int:
    """Memory of a process that runs the case [MB]."""
    return math.ceil(_MB_PROCESS + _BYTES_PER_PARTICLE * particles(case) / 1e6)
