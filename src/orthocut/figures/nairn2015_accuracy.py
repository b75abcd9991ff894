"""What presets and tolerances promise of ductile cuts against what cuts at several particle sizes show."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import PAGE, cases, nothing, page, styled
from orthocut.figures.extrapolation import Fit, extrapolate
from orthocut.figures.palette import BLACK, BLUE, GREY, ORANGE
from orthocut.figures.precision import plain
from orthocut.figures.sweep import over_toughness, touches
from orthocut.figures.tables import Table
from orthocut.io.collect import case_of, parameters
from orthocut.params.accuracy import evidence
from orthocut.params.accuracy_ductile import Choice, depth_over_zone, promise
from orthocut.params.mpm import MpmCutting

CAPTION = (
    "Left: error of the cutting force against its limit at zero particle size, times points through the chip, over the "
    "depth of cut in lengths of the cohesive zone E'Gc/σc². One symbol a family of cuts that differ in particle size "
    "alone; filled: the chip bends at the finest size, open: the tool touches the crack tip. Blue: cuts with 5 and 8 "
    "points, which made the promises; orange: cuts with 12 points or more, which did not. Crosses at the top: families "
    "whose regime hangs on the particle size, which have no limit and no promise. Lines: what is promised of 9 of 10 "
    "other cuts (solid) and what every other one keeps to (dashed). Right: error of each run of the orange families "
    "over what is promised of it; those below the diagonal keep the promise. Bars: standard errors of run and limit."
)
DIMS = ()
HELD_OUT = 12
"""Points through the chip from which on a family is no evidence of the promises but tests them."""
LEAST = 0.02
"""Smallest number that the left panel shows."""


@dataclass(frozen=True)
class Family:
    """Cuts that differ in particle size alone, by points through the chip."""

    case: MpmCutting
    """The finest."""
    points: list[int]
    forces: list[float]
    """Over toughness [-]."""
    errors: list[float]
    """Standard errors of the forces [-]."""
    touching: list[bool]

    @property
    def one_regime(self) -> bool:
        """Whether all sizes have the same regime."""
        return len(set(self.touching)) == 1

    @property
    def held_out(self) -> bool:
        """Whether it tests promises."""
        return max(self.points) >= HELD_OUT

    @property
    def fit(self) -> Fit:
        """Straight line over particle size."""
        return extrapolate([1 / n for n in self.points], self.forces, self.errors)

    @property
    def bias(self) -> float:
        """Error against the limit times points through the chip, by the fit [-]."""
        return abs(self.fit.slope / self.fit.limit)

    @property
    def depth(self) -> float:
        """Depth of cut over the length of the cohesive zone [-]."""
        return depth_over_zone(self.case)


@dataclass(frozen=True)
class Trial:
    """A run of a family that is held out."""

    family: Family
    points: int
    bound: float
    """Error that is promised of 9 of 10 cuts [-]."""
    error: float
    """Deviation from the limit [-]."""
    noise: float
    """Standard error of run and limit, over the limit [-]."""


def families_of(dataset: xr.Dataset) -> list[Family]:
    """Families of two sizes or more that are computed as most runs are."""
    runs = cases(dataset, "force_cutting_mean", kind="mpm_cutting")
    if not runs:
        return []
    numerics = [case_of(run).numerics.model_copy(update={"points_per_depth": 2}) for run in runs]
    speeds = [case_of(run).cut_speed for run in runs]
    usual = [Counter(one).most_common(1)[0][0] for one in ([item.model_dump_json() for item in numerics], speeds)]
    groups: dict[tuple, list[xr.Dataset]] = {}
    for run, method, speed in zip(runs, numerics, speeds, strict=True):
        if [method.model_dump_json(), speed] == usual:
            rest = {name: value for name, value in parameters(case_of(run)).items() if name != "points_per_depth"}
            groups.setdefault(tuple(sorted(rest.items())), []).append(run)
    return [_family(group) for group in groups.values() if len(group) > 1]


def quantiles(families: Sequence[Family]) -> list[tuple[int, float, float]]:
    """Families, bound and typical value of their bias, for each row of the evidence."""
    rows, low = [], 0.0
    for row in evidence()["bias"]:
        found = [one.bias for one in families if low < one.depth <= row["depth_over_zone"] and one.one_regime]
        low = row["depth_over_zone"]
        rows.append((len(found), *(np.quantile(found, (0.9, 0.5)) if found else (math.nan, math.nan))))
    return rows


def trials_of(families: Sequence[Family]) -> list[Trial]:
    """Runs of families that are held out and have a limit and a promise."""
    found = []
    for family in families:
        if not (family.held_out and family.one_regime and len(family.points) > 2):
            continue
        limit, error = family.fit.limit, family.fit.error
        for n, force, own in zip(family.points, family.forces, family.errors, strict=True):
            known = promise(family.case, Choice(n, f"{family.case.cut_speed:g} m/s", family.case.error_target))
            if known:
                found.append(Trial(family, n, known.bound, abs(force / limit - 1), math.hypot(own, error) / limit))
    return found


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Bias over depth of cut, and errors over promises."""
    families = families_of(dataset)
    figure = page(3.4, PAGE)
    if not families:
        nothing(figure.subplots())
        return figure
    left, right = figure.subplots(1, 2)
    _biases(left, families)
    _trials(right, trials_of(families))
    handles = [
        Line2D([], [], ls="", marker="o", color=BLUE, label="5 and 8 points"),
        Line2D([], [], ls="", marker="o", color=ORANGE, label=f"{HELD_OUT} points or more"),
        Line2D([], [], ls="", marker="o", color=GREY, mfc="white", label="touching"),
        Line2D([], [], ls="", marker="x", color=GREY, label="regime hangs on size"),
        Line2D([], [], color=BLACK, label="promised of 9 of 10"),
        Line2D([], [], color=BLACK, ls="--", label="of every other one"),
    ]
    figure.legend(handles=handles, loc="outside upper center", ncols=6, fontsize="x-small")
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Evidence of each row of the promises, and how many of the runs that are held out keep them."""
    families = families_of(dataset)
    evident = [family for family in families if not family.held_out]
    header = ["depth of cut over cohesive zone, up to [-]", "families", "of them with two regimes"]
    header += ["error times points, 9 of 10 [-]", "promised [-]", "every other one [-]", "promised [-]"]
    header += ["runs held out", "keep the promise", "at 8 points: largest error [%]", "promised [%]"]
    rows, low = [], 0.0
    for row, (count, bound, typical) in zip(evidence()["bias"], quantiles(evident), strict=True):
        high = row["depth_over_zone"]
        mixed = sum(low < family.depth <= high and not family.one_regime for family in evident)
        trials = [trial for trial in trials_of(families) if low < trial.family.depth <= high]
        kept = sum(trial.error <= trial.bound for trial in trials)
        eight = [trial for trial in trials if trial.points == 8]
        worst = max((trial.error for trial in eight), default=math.nan)
        said = max((trial.bound for trial in eight), default=math.nan)
        first = [high, count + mixed, mixed, float(bound), row["bound"], float(typical), row["typical"]]
        rows.append([*first, len(trials), kept, 100 * worst, 100 * said])
        low = high
    return Table("What is promised of the error of the cutting force, and the evidence", header, rows)


def _family(runs: list[xr.Dataset]) -> Family:
    runs = sorted(runs, key=lambda run: case_of(run).numerics.points_per_depth)
    return Family(
        case_of(runs[-1]),
        [case_of(run).numerics.points_per_depth for run in runs],
        [over_toughness(run) for run in runs],
        [over_toughness(run, "force_cutting_error") for run in runs],
        [touches(run) for run in runs],
    )


def _biases(ax: Axes, families: Sequence[Family]) -> None:
    plain(ax)
    for family in families:
        colour = ORANGE if family.held_out else BLUE
        if family.one_regime:
            face = "white" if family.touching[-1] else colour
            ax.plot(family.depth, max(family.bias, LEAST), "o", color=colour, mfc=face, ms=3, mew=0.7)
        else:
            ax.plot(family.depth, 1.0, "x", color=colour, ms=4, transform=ax.get_xaxis_transform(), clip_on=False)
    low = min(family.depth for family in families)
    for row in evidence()["bias"]:
        for name, style in (("bound", "-"), ("typical", "--")):
            ax.plot([low, row["depth_over_zone"]], [row[name]] * 2, style, color=BLACK, lw=1.0)
        low = row["depth_over_zone"]
    ax.set_xlabel("depth of cut over length of the cohesive zone [-]")
    ax.set_ylabel("error times points through the chip [-]")


def _trials(ax: Axes, trials: Sequence[Trial]) -> None:
    if not trials:
        nothing(ax, "no cuts are held out")
        return
    for trial in trials:
        face = "white" if trial.family.touching[-1] else ORANGE
        style = {"color": ORANGE, "mfc": face, "ms": 3, "elinewidth": 0.5}
        ax.errorbar(100 * trial.bound, 100 * trial.error, yerr=100 * trial.noise, fmt="o", **style)
    most = 100 * max(max(trial.bound, trial.error) for trial in trials)
    ax.plot([0, most], [0, most], color=BLACK, lw=1.0)
    ax.set_xlim(0, 1.05 * most)
    ax.set_ylim(0, 1.05 * most)
    ax.set_xlabel("promised error [%]")
    ax.set_ylabel("error [%]")
