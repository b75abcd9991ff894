"""Runs with bonded discs as the figures of Yang et al. (2018) need them: the case and its numbers."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import xarray as xr

from orthocut.figures.canvas import cases
from orthocut.figures.yang2018_paper import FORCES
from orthocut.figures.yang2018_paper import Cut as Condition
from orthocut.io.collect import case_of, parameters
from orthocut.params.dem import DemCompression, DemCutting, DemTension, FlatJoint, Grooves
from orthocut.variables import VARIABLES

PARTS, EARLY = 8, 6
"""Equal parts of the travel of which `condense` keeps the mean forces, and those before the tool nears the fixed side:
from there on chips are crushed between the two."""
SUMS = {f"cracks_{place}": (f"cracks_tension_{place}", f"cracks_shear_{place}") for place in ("total", "below")}
"""Sums of numbers of a run, by name."""
CALIBRATED_STRENGTH = 72.77e6
"""Tensile strength of the calibrated joints [Pa]: results/published/calibration/paper_size/joint.yaml."""
NUMERICAL = ("damping", "time_step_factor")
"""Fields of the joints that belong to the method, not to the material."""


@dataclass(frozen=True)
class GlassRun:
    """A finished run; a number that it does not tell is NaN."""

    case: DemCutting | DemTension | DemCompression
    numbers: dict[str, float] = field(default_factory=dict)
    """Single results by name, in the units that figures show: forces in N/mm, lengths in mm."""
    parts: dict[str, np.ndarray] = field(default_factory=dict)
    """Mean forces in equal parts of the travel [N/mm]."""

    def __getitem__(self, name: str) -> float:
        """Number of that name, or sum of both kinds of cracks."""
        if name in SUMS:
            return sum(self[part] for part in SUMS[name])
        return self.numbers.get(name, math.nan)

    @property
    def seed(self) -> int:
        """Seed of the packing."""
        return self.case.packing.seed


def runs_of(dataset: xr.Dataset, kind: str, *needed: str) -> list[GlassRun]:
    """All finished runs of a kind that hold some variables, by seed."""
    found = [_run(run) for run in cases(dataset, *needed, kind=kind)]
    return sorted(found, key=lambda run: run.seed)


def _run(run: xr.Dataset) -> GlassRun:
    single = [name for name, data in run.data_vars.items() if not data.dims and data.dtype.kind in "fiu"]
    numbers = {name: float(run[name]) * (VARIABLES[name].scale if name in VARIABLES else 1.0) for name in single}
    parts = {name: 1e-3 * run[f"{name}_parts"].values[:PARTS] for name in FORCES if f"{name}_parts" in run}
    return GlassRun(case_of(run), numbers, parts)


def cuts_of(dataset: xr.Dataset) -> list[GlassRun]:
    """All finished cuts."""
    return runs_of(dataset, "dem_cutting", *(f"{name}_mean" for name in FORCES))


def condense(run: xr.Dataset) -> xr.Dataset:
    """Run with its mean forces in equal parts of the travel, in place of its history, and what tells of peaks.

    Added are, for both forces, the means in parts, as a history of few samples; for the cutting force, the number of
    its excursions above its mean and the standard deviation of the history over its mean. Tests lose their history.
    """
    if not set(FORCES) <= set(run.variables):
        return run.drop_dims("sample", errors="ignore")
    found = {}
    for name in FORCES:
        force = run[name].values[np.isfinite(run[name].values)]
        means = np.array([part.mean() for part in np.array_split(force, PARTS)]) if force.size >= PARTS else np.nan
        words = {"units": "N/m", "long_name": f"mean {name.replace('force_', '')} force in equal parts of the travel"}
        found[f"{name}_parts"] = ("sample", np.broadcast_to(means, PARTS), words)
    cutting = run["force_cutting"].values
    above = cutting[np.isfinite(cutting)] > np.nanmean(cutting)
    words = {"units": "1", "long_name": "excursions of the cutting force above its mean"}
    found["force_cutting_excursions"] = ((), float(np.sum(above[1:] & ~above[:-1]) + above[0]), words)
    words = {"units": "1", "long_name": "standard deviation of the cutting force over its mean"}
    found["force_cutting_variation"] = ((), float(np.nanstd(cutting) / np.nanmean(cutting)), words)
    return run.drop_dims("sample").assign(found)


def condition(run: GlassRun) -> Condition:
    """Depth of cut [mm] and whether the surface is grooved."""
    return round(1e3 * run.case.cut_depth, 9), run.case.grooves is not None


def as_printed(joint: FlatJoint) -> bool:
    """Whether joints are those of Table 1 as printed, whatever their damping and time step."""
    usual = {name: getattr(FlatJoint(), name) for name in NUMERICAL}
    return joint.model_copy(update=usual) == FlatJoint()


def material_words(run: GlassRun) -> str:
    """Name of the material."""
    return "Table 1 as printed" if as_printed(run.case.joint) else "calibrated"


def usual(cuts: Sequence[GlassRun]) -> list[GlassRun]:
    """Cuts that are made and computed as most of them are: all but depth of cut, grooves and seed."""

    def scheme(cut: GlassRun) -> str:
        same = {"cut_depth": 0.0, "grooves": None, "packing": cut.case.packing.model_copy(update={"seed": 0})}
        return cut.case.model_copy(update=same).model_dump_json()

    schemes = [scheme(cut) for cut in cuts]
    commonest = Counter(schemes).most_common(1)
    return [cut for cut, one in zip(cuts, schemes, strict=True) if one == commonest[0][0]]


def conditions(cuts: Sequence[GlassRun]) -> dict[Condition, list[GlassRun]]:
    """Usual cuts by depth of cut and surface, grooves as in the paper."""
    found = defaultdict(list)
    for cut in usual(cuts):
        if cut.case.grooves in (None, Grooves()):
            found[condition(cut)].append(cut)
    return dict(sorted(found.items()))


def along(cuts: Sequence[GlassRun], name: str, least: int = 2) -> list[dict[float, list[GlassRun]]]:
    """Groups of cuts that differ in one field and the seed alone, by the value of that field.

    Parameters
    ----------
    cuts : sequence of GlassRun
    name : str
        Name of the field, as in the table of variables.
    least : int
        Smallest number of values of a group; smaller ones are left out.
    """
    groups: dict[tuple, dict[float, list[GlassRun]]] = defaultdict(lambda: defaultdict(list))
    for cut in cuts:
        fields: dict[str, Any] = parameters(cut.case)
        if name not in fields:
            continue
        value = fields.pop(name)
        del fields["seed"]
        groups[tuple(sorted(fields.items()))][value].append(cut)
    chosen = (dict(sorted(group.items())) for group in groups.values() if len(group) >= least)
    return sorted(chosen, key=lambda group: (-len(group), condition(next(iter(group.values()))[0])))


def forces(cuts: Sequence[GlassRun], name: str, what: str = "mean") -> list[float]:
    """One number of the force of each cut [N/mm].

    Parameters
    ----------
    name : str
        ``force_cutting`` or ``force_thrust``.
    what : str
        ``mean``, ``contact``, ``peak`` or ``rms``.
    """
    return [cut[f"{name}_{what}"] for cut in cuts]


def early(cuts: Sequence[GlassRun], name: str) -> list[float]:
    """Mean of a force over the first three quarters of the travel of each cut [N/mm]; NaN where it is not known."""
    return [float(np.mean(cut.parts.get(name, np.full(PARTS, np.nan))[:EARLY])) for cut in cuts]


def paired(runs: Sequence[GlassRun], others: Sequence[GlassRun]) -> tuple[list[GlassRun], list[GlassRun]]:
    """Those of two sets of runs whose seeds both have, in the same order."""
    first, second = ({run.seed: run for run in some} for some in (runs, others))
    seeds = sorted(first.keys() & second.keys())
    return [first[seed] for seed in seeds], [second[seed] for seed in seeds]
