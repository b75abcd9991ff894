"""What the claims of Nairn (2015) need to know of each ductile cut: its case and some numbers."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import xarray as xr

from orthocut.figures.canvas import cases
from orthocut.figures.extrapolation import extrapolate
from orthocut.figures.regimes import Transition, transition
from orthocut.figures.scene import last_snapshot
from orthocut.io.collect import case_of, parameters
from orthocut.params.mpm import MpmCutting

STEADY_BAND = 0.1
"""Deviation from the mean of the window within which a force counts as steady, over that mean [-]."""
STRAIN_SHARE = 0.999
"""Share of the points whose shear strain is below what counts as the largest; it leaves out single points."""


@dataclass(frozen=True)
class Cut:
    """A finished cut; NaN stands for what it does not tell."""

    case: MpmCutting
    force: float
    """Cutting force over toughness [-]."""
    error: float = math.nan
    """Standard error of the force [-]."""
    drift: float = math.nan
    """Change of the force over the window, over its mean [-]."""
    rubbing: float = 0.0
    """Rubbing force over toughness [-]."""
    rubbing_error: float = math.nan
    """Standard error of the rubbing force [-]."""
    touching: bool = False
    """Whether the tool touches the crack tip."""
    mode_one: float = math.nan
    """Fraction of mode I in the energy of failure [-]."""
    steady: float = math.nan
    """Travel over depth of cut from which the force is steady [-]."""
    strain: float = math.nan
    """Largest shear strain in the last snapshot [-]."""

    @property
    def depth(self) -> float:
        """Depth of cut [m]."""
        return self.case.cut_depth

    @property
    def points(self) -> int:
        """Material points through the depth of cut."""
        return self.case.numerics.points_per_depth


def cuts_of(dataset: xr.Dataset) -> list[Cut]:
    """All finished ductile cuts of a collected dataset."""
    return [_cut(run) for run in cases(dataset, "force_cutting_mean", "touching", kind="mpm_cutting")]


def _cut(run: xr.Dataset) -> Cut:
    case = case_of(run)

    def number(name: str, scale: float = 1.0) -> float:
        return float(run[name]) * scale if name in run else math.nan

    each = 1.0 / case.interface.toughness
    rubbing = number("force_rubbing_mean", each)
    return Cut(
        case,
        number("force_cutting_mean", each),
        number("force_cutting_error", each),
        number("force_cutting_drift"),
        rubbing if math.isfinite(rubbing) else 0.0,
        number("force_rubbing_error", each),
        number("touching") >= 0.5,
        number("mode_one_fraction"),
        number("steady_travel"),
        number("strain_shear"),
    )


def condense(run: xr.Dataset) -> xr.Dataset:
    """Run with two more numbers, from its history and its last snapshot, and without either."""
    found = run
    if {"force_cutting", "tool_travel"} <= set(run.variables):
        words = {"units": "1", "long_name": "travel over depth of cut from which the cutting force is steady"}
        found = found.assign(steady_travel=((), steady_travel(run), words))
    if last_snapshot(run, "point_x") >= 0:
        words = {"units": "1", "long_name": "largest shear strain of material points in the last snapshot"}
        found = found.assign(strain_shear=((), strain_shear(run), words))
    return found


def steady_travel(run: xr.Dataset) -> float:
    """Travel over depth of cut from which means over one depth of cut stay near the mean of the window [-]; or NaN."""
    case = case_of(run)
    travel, force = run["tool_travel"].values / case.cut_depth, run["force_cutting"].values
    good = np.isfinite(travel) & np.isfinite(force)
    travel, force = travel[good], force[good]
    if not travel.size or travel[-1] <= max(case.window_ratio, 1.0):
        return math.nan
    grid = np.arange(0.0, travel[-1] - 1.0, 0.1)
    done = np.concatenate([[0.0], np.cumsum(0.5 * (force[1:] + force[:-1]) * np.diff(travel))])
    means = np.interp(grid + 1.0, travel, done) - np.interp(grid, travel, done)
    mean = force[travel >= case.window_ratio].mean()
    outside = np.flatnonzero(np.abs(means - mean) > STEADY_BAND * abs(mean))
    if outside.size and outside[-1] + 1 >= grid.size:
        return math.nan
    return float(grid[outside[-1] + 1]) if outside.size else 0.0


def strain_shear(run: xr.Dataset) -> float:
    """Largest difference of the principal stretches, which is the shear of a simple shear, in the last snapshot [-]."""
    deformation = run.isel(snapshot=last_snapshot(run, "point_x"))["point_deformation"].values.reshape(-1, 2, 2)
    stretches = np.linalg.svd(deformation[np.isfinite(deformation).all(axis=(1, 2))], compute_uv=False)
    return float(np.quantile(stretches[:, 0] - stretches[:, 1], STRAIN_SHARE))


def alike(cuts: Sequence[Cut]) -> list[Cut]:
    """Cuts that are computed as most of them are, at any resolution: scheme, speed, travel and workpiece."""

    def scheme(cut: Cut) -> tuple:
        case = cut.case
        return (
            case.numerics.model_copy(update={"points_per_depth": 2}),
            case.workpiece,
            case.cut_speed,
            case.travel_ratio,
            case.window_ratio,
        )

    schemes = [scheme(cut) for cut in cuts]
    commonest = Counter(schemes).most_common(1)
    return [cut for cut, one in zip(cuts, schemes, strict=True) if one == commonest[0][0]]


def usual(cuts: Sequence[Cut]) -> list[Cut]:
    """Cuts that are computed as most of them are, at the finest resolution that is common.

    Common is a resolution of at least half as many cuts as the commonest has: a study may run all of its cuts at two
    resolutions, and some at many more.
    """
    same = alike(cuts)
    counts = Counter(cut.points for cut in same)
    points = max((n for n, count in counts.items() if 2 * count >= max(counts.values())), default=0)
    return [cut for cut in same if cut.points == points]


def at_zero_size(cuts: Sequence[Cut]) -> list[Cut]:
    """Usual cuts as they would be at zero particle size, from straight lines over particle size.

    Cuts are left out that were made at one resolution only, and those whose regime hangs on the resolution.

    Returns
    -------
    list of Cut
        With force and rubbing force at zero particle size, and the standard error of that force.
    """
    found = []
    for cut, group in _families(cuts):
        if len(group) < 2 or any(other.touching != cut.touching for other in group):
            continue
        sizes = [1.0 / other.points for other in group]
        force = extrapolate(sizes, [other.force for other in group], [other.error for other in group])
        rubbing = extrapolate(sizes, [other.rubbing for other in group], [other.rubbing_error for other in group])
        found.append(replace(cut, force=force.limit, error=force.error, rubbing=max(rubbing.limit, 0.0)))
    return found


def hanging(cuts: Sequence[Cut]) -> list[Cut]:
    """Usual cuts whose regime is another one at another resolution."""
    return [cut for cut, group in _families(cuts) if any(other.touching != cut.touching for other in group)]


def _families(cuts: Sequence[Cut]) -> list[tuple[Cut, list[Cut]]]:
    """Usual cuts, each with the cuts that differ from it in resolution alone, itself among them."""
    groups: dict[tuple, list[Cut]] = {}
    for cut in alike(cuts):
        groups.setdefault(_but_resolution(cut), []).append(cut)
    return [(cut, groups[_but_resolution(cut)]) for cut in usual(cuts)]


def _but_resolution(cut: Cut) -> tuple:
    fields = parameters(cut.case)
    del fields["points_per_depth"]
    return tuple(sorted(fields.items()))


def select(
    cuts: Sequence[Cut],
    rake: float | None = 30.0,
    friction: float | None = 0.0,
    tangent: float | None = 0.0,
    strength: float | None = 40.0,
    law: str = "cubic",
) -> list[Cut]:
    """Cuts of a rake angle [degree], friction, tangent modulus and cohesive stress [MPa], by depth; None: any."""

    def fits(cut: Cut) -> bool:
        case = cut.case
        wanted = (
            (rake, math.degrees(case.tool.rake_angle)),
            (friction, case.tool.friction),
            (tangent, 1e-6 * case.material.modulus_tangent),
            (strength, 1e-6 * case.interface.strength),
        )
        near = all(one is None or math.isclose(one, other, rel_tol=1e-6, abs_tol=1e-9) for one, other in wanted)
        return near and case.interface.law == law

    return sorted((cut for cut in cuts if fits(cut)), key=lambda cut: cut.depth)


def along(cuts: Sequence[Cut], field: str, least: int = 2) -> list[list[Cut]]:
    """Groups of cuts that differ in one field alone, by its value; those with too few values are left out."""
    groups: dict[tuple, dict[float, Cut]] = {}
    for cut in cuts:
        fields = parameters(cut.case)
        value = fields.pop(field)
        groups.setdefault(tuple(sorted(fields.items())), {})[value] = cut
    return [[group[value] for value in sorted(group)] for group in groups.values() if len(group) >= least]


def change_of(cuts: Sequence[Cut]) -> Transition:
    """Depths of cut between which cuts of one series turn from touching to bending."""
    return transition([(cut.depth, cut.touching) for cut in cuts])
