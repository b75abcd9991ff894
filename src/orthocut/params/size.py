"""Size of a case before it is run: particles and time steps. For limits and for predicted costs; never for results."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from orthocut.params.mpm import LEAST_WINDOW

if TYPE_CHECKING:
    from orthocut.params.case import Case

_SOLID_FRACTION = 0.9
_PARTS = 16  # of the time of a cut


def particles(case: Case) -> float:
    """Number of material points or, about, of discs."""
    if case.kind == "mpm_cutting":
        work = case.workpiece
        return work.length_ratio * (1 + work.base_ratio) * case.numerics.points_per_depth**2
    packing = case.packing
    mean_square = packing.radius_min**2 * (1 + packing.radius_ratio + packing.radius_ratio**2) / 3
    return _SOLID_FRACTION * packing.width * packing.height / (math.pi * mean_square)


def moving(case: Case, share: float = 1.0) -> float:
    """Number of particles that a step moves, about, as a mean over the run: material far from a tool rests.

    Parameters
    ----------
    case : Case
    share : float
        Share of the steps of a ductile cut after which it ends.
    """
    if case.kind != "mpm_cutting" or not case.numerics.reach_ratio:
        return particles(case)
    work, reach = case.workpiece, case.numerics.reach_ratio
    total = 0.0
    for part in range(_PARTS):
        travel = _travel((part + 0.5) / _PARTS * share, case.numerics.ramp_fraction) * case.travel_ratio
        ahead = min(reach, work.length_ratio - travel) * (1 + work.base_ratio)
        total += ahead + travel + min(0.5 * reach, travel) * work.base_ratio
    return total / _PARTS * case.numerics.points_per_depth**2


def _travel(time: float, ramp: float) -> float:
    """Share of the travel at a share of the time: the tool speeds up linearly during the ramp."""
    return (time**2 / (2 * ramp) if time < ramp else time - 0.5 * ramp) / (1 - 0.5 * ramp)


def least_share(case: Case) -> float:
    """Share of the steps of a ductile cut that it takes at least; 1 where it does not end early."""
    if case.kind != "mpm_cutting" or not case.error_target:
        return 1.0
    ramp = case.numerics.ramp_fraction
    travel = min((case.window_ratio + LEAST_WINDOW) / case.travel_ratio, 1.0)
    return travel * (1 - 0.5 * ramp) + 0.5 * ramp


def steps(case: Case, strain: float = math.inf) -> float:
    """Number of time steps.

    Parameters
    ----------
    case : Case
    strain : float
        Axial strain at which a test of glass ends, if not before.
    """
    if case.kind == "mpm_cutting":
        return case.steps
    joint = case.joint
    step = joint.time_step_factor * case.packing.radius_min * (math.pi * joint.density / joint.modulus) ** 0.5
    if case.kind == "dem_cutting":
        return case.travel / case.cut_speed / step
    return min(case.strain_max, strain) * case.packing.height / (2 * case.grip_speed) / step
