"""What a case must keep to beyond the ranges of its fields: sizes that a machine can run and a packing can give.

These checks only refuse; they change no number of a case that passes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from orthocut.params.size import particles, steps

if TYPE_CHECKING:
    from orthocut.params.case import Case
    from orthocut.params.dem import DemCutting, DemTension, FlatJoint, Packing
    from orthocut.params.dem_toughness import DemToughness
    from orthocut.params.mpm import MpmCutting

MAX_PARTICLES = 5_000_000
"""Most material points or discs: some 40 GB of memory."""
MAX_WORK = 1e15
"""Most particles times steps: one to three years on a core."""
MIN_CUT_STEPS = 500
"""Fewest steps of a cut of glass: one for each row of its history."""
MIN_GRAINS = 4
"""Fewest of the largest discs that fit side by side into the width and the height of a packing."""
MIN_CRACK = 4
"""Fewest of the largest discs along the crack of a test of toughness."""
_ROUNDING = 1e-9


def faults(case: Case) -> list[str]:
    """What is wrong with a case whose fields are all in range: field, value, what is allowed; empty if nothing is."""
    return [*(_path(case) if case.kind == "mpm_cutting" else _grains(case)), *_size(case)]


def _grains(case: Case) -> Iterator[str]:
    yield from _vessel(case.packing)
    yield from _step(case.joint, case.packing)
    if case.kind == "dem_cutting":
        yield from _cut(case)
    if case.kind == "dem_toughness":
        yield from _crack(case)
    if case.kind in ("dem_tension", "dem_toughness"):
        yield from _grips(case)


def _vessel(packing: Packing) -> Iterator[str]:
    least = MIN_GRAINS * 2 * packing.radius_min * packing.radius_ratio
    for name in ("width", "height"):
        size = getattr(packing, name)
        if _less(size, least):
            yield (
                f"packing.{name} = {_mm(size)} holds too few discs side by side "
                f"(allowed: {_mm(least)} or more, {MIN_GRAINS} of the largest)"
            )


def _step(joint: FlatJoint, packing: Packing) -> Iterator[str]:
    limit = largest_step_factor(joint.stiffness_ratio, joint.damping, packing.radius_ratio)
    if _less(limit, joint.time_step_factor):
        yield (
            f"joint.time_step_factor = {joint.time_step_factor:g} is unstable with stiffness_ratio = "
            f"{joint.stiffness_ratio:g} and damping = {joint.damping:g} "
            f"(allowed: up to {math.floor(100 * limit) / 100:g})"
        )


def largest_step_factor(stiffness_ratio: float, damping: float, radius_ratio: float) -> float:
    """Largest stable time step over sqrt(smallest mass/(modulus x width)).

    Equal discs, each joined to six others: where all turn the same way, each joint shears by the full rotation, and
    omega^2 = 24/stiffness_ratio in units of modulus x width/mass. Where rows move against each other it is 6 and, with
    rotations, 7/stiffness_ratio by measurement. The smallest of unequal discs has larger neighbours and softer joints:
    1.11 times the limit at a ratio of 4/3, measured are 1.15 to 1.23, and 1.62 at 4, measured 1.64
    (benchmarks/stable_step.py).
    """
    squared = max(24.0 / stiffness_ratio, 6.0 + 7.0 / stiffness_ratio)
    return 2.0 * radius_ratio**0.35 / math.sqrt(squared * (1.0 + damping))


def _cut(case: DemCutting) -> Iterator[str]:
    grain, width = 2 * case.packing.radius_min, case.packing.width
    if _less(case.cut_depth, grain):
        yield f"cut_depth = {_mm(case.cut_depth)} is less than a grain (allowed: {_mm(grain)} or more)"
    count = steps(case)
    if _less(count, MIN_CUT_STEPS):
        yield (
            f"travel = {_mm(case.travel)} at cut_speed = {case.cut_speed:.4g} m/s takes {count:.0f} steps "
            f"(allowed: {MIN_CUT_STEPS} or more)"
        )
    if case.grooves is None:
        return

    for name in ("width", "distance"):
        size = getattr(case.grooves, name)
        if _less(size, 0.5 * grain):
            yield f"grooves.{name} = {_mm(size)} is less than half a grain (allowed: {_mm(0.5 * grain)} or more)"
    taken = case.grooves.width + case.grooves.distance
    if _less(width, taken):
        yield (
            f"grooves.width + grooves.distance = {_mm(taken)} leave no room for a groove "
            f"(allowed: up to the width of the block, {_mm(width)})"
        )


def _crack(case: DemToughness) -> Iterator[str]:
    least = MIN_CRACK * 2 * case.packing.radius_min * case.packing.radius_ratio / case.packing.width
    if _less(case.crack_ratio, least):
        yield (
            f"crack_ratio = {case.crack_ratio:g} is a crack of {_mm(case.crack_length)} "
            f"(allowed: {math.ceil(100 * least) / 100:g} or more, {MIN_CRACK} of the largest discs)"
        )


def _grips(case: DemTension | DemToughness) -> Iterator[str]:
    largest = case.packing.radius_min * case.packing.radius_ratio
    grip = case.grip_ratio * case.packing.height
    if _less(grip, largest):
        yield (
            f"grip_ratio = {case.grip_ratio:g} are grips of {_mm(grip)}, which may hold no disc "
            f"(allowed: {math.ceil(1e3 * largest / case.packing.height) / 1e3:g} or more, the largest radius)"
        )


def _path(case: MpmCutting) -> Iterator[str]:
    notch, path, length = case.workpiece.notch_ratio, case.workpiece.path_ratio, case.workpiece.length_ratio
    if not _less(notch, length):
        yield (
            f"workpiece.notch_ratio = {notch:g} leaves nothing to cut (allowed: less than length_ratio = {length:g})"
        )
    if not _less(path, length):
        yield (
            f"workpiece.path_ratio = {path:g} is no shorter than the workpiece "
            f"(allowed: 0 for all of it, or less than length_ratio = {length:g})"
        )


def _size(case: Case) -> Iterator[str]:
    count, work = particles(case), particles(case) * steps(case)
    what, fields = (
        ("material points", "numerics.points_per_depth, workpiece")
        if case.kind == "mpm_cutting"
        else ("discs", "packing.width, packing.height, packing.radius_min")
    )
    if count > MAX_PARTICLES:
        yield f"{fields} give {count:.3g} {what} (allowed: up to {MAX_PARTICLES:.3g})"
    elif work > MAX_WORK:
        yield f"{count:.3g} {what} for {steps(case):.3g} steps = {work:.3g} (allowed: up to {MAX_WORK:.0e} together)"


def _less(value: float, least: float) -> bool:
    return value < least * (1 - _ROUNDING)


def _mm(length: float) -> str:
    return f"{length * 1e3:.4g} mm"
