"""Error of the force of ductile cuts against their cost: what each setting of the method buys, alone and together."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import xarray as xr
from matplotlib.figure import Figure

from orthocut.cost import seconds_of
from orthocut.figures.canvas import PAGE, cases, nothing, page, styled
from orthocut.figures.extrapolation import Fit, extrapolate
from orthocut.figures.palette import AMBER, BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY
from orthocut.figures.precision import Reference, Setting, draw_settings, front, handles, setting
from orthocut.figures.sweep import over_toughness, touches
from orthocut.figures.tables import Table, plain
from orthocut.figures.varied import ELASTIC, words
from orthocut.io.collect import case_of, parameters
from orthocut.params.mpm import MpmCutting
from orthocut.variables import attributes

CAPTION = (
    "Error of the mean cutting force over the run time on one core, one panel a scene. Error: root of the squares of "
    "the deviation from the reference and of the standard error of the run. Reference: for the bending and the "
    "touching cut the force at zero particle size, by a weighted straight fit through the runs that differ in particle "
    "size alone, shaded up to its standard error; for the elastic cut the toughness, which is exact. Cost: by the cost "
    "model at the steps that the run took, so that it does not depend on what else the machine did; the table has the "
    "measured time beside it. Each symbol differs from the standard one of its particle size in what the legend names; "
    "numbers are points through the chip. Stars: straight lines to zero size through two runs, at the cost of both; "
    "they are not independent of the reference. Bars: standard errors of run and reference. Line: settings than which "
    "no cheaper one has a smaller error. Errors of opposite sign cancel: coarse points lower the force of the touching "
    "cut, PIC and a fast tool raise it; in the bending cut all three raise it."
)
DIMS = ()
SIZE, SEVERAL, PAIR = "particle size", "several together", "two sizes, to zero"
KNOBS = {
    SIZE: ("o", BLUE),
    "transfers": ("s", ORANGE),
    "points in a cell": ("p", AMBER),
    "place of the grid": ("H", SKY),
    "nodes of little mass": ("^", GREEN),
    "loop of the paper": ("D", PURPLE),
    "time step": ("v", AMBER),
    "tool speed": (">", BLACK),
    "reach of what moves": ("P", SKY),
    "ramp damping": ("X", GREY),
    "depth of the base": ("<", GREEN),
    "length of the average": ("d", ORANGE),
    SEVERAL: ("h", PURPLE),
    PAIR: ("*", BLUE),
}
"""Knob to marker and colour."""
FIELDS = {
    "affine": "transfers",
    "flip": "transfers",
    "points_per_cell": "points in a cell",
    "grid_offset": "place of the grid",
    "support": "nodes of little mass",
    "scheme": "loop of the paper",
    "contact": "loop of the paper",
    "position_order": "loop of the paper",
    "courant": "time step",
    "cut_speed": "tool speed",
    "reach_ratio": "reach of what moves",
    "ramp_feedback": "ramp damping",
    "ramp_fraction": "ramp damping",
    "base_ratio": "depth of the base",
    "window_ratio": "length of the average",
    "travel_ratio": "length of the average",
    "length_ratio": "length of the average",
    "error_target": "length of the average",
}
"""Field that says how a cut is computed to its knob; all other fields say what is cut."""
USUAL = {"affine": 1.0, "support": 0.05, "grid_offset": 0.25, "scheme": "consistent", "contact": "exact"}
"""Values of the standard setting; those of other fields are the commonest of the scene."""
WORDS = {
    "reach_ratio": lambda value: f"reach {value:g}" if value else "all of it moves",
    "window_ratio": lambda value: f"average from {value:g} depths of cut",
    "error_target": lambda value: f"until known to {100 * value:g} %",
}
"""Words for fields where those of other figures would say nothing."""
RATIO = 1.3
"""Least ratio of particle sizes of two runs that a line to zero size goes through."""


@dataclass(frozen=True)
class Run:
    """A finished cut."""

    case: MpmCutting
    force: float
    """Over toughness [-]."""
    error: float
    """Standard error of the force over toughness [-]."""
    touching: bool
    cost: float
    """Run time by the cost model at the steps that the run took [s]."""
    measured: float
    """Run time, whatever else the machine did [s]."""

    @property
    def points(self) -> int:
        """Material points through the depth of cut."""
        return self.case.numerics.points_per_depth


@dataclass(frozen=True)
class Scene:
    """What is cut, and all runs of it."""

    name: str
    runs: list[Run]
    usual: dict[str, Any]
    """Field to its value in the standard setting."""
    reference: Reference
    settings: list[tuple[Run | None, Setting]]
    """Each run with its setting; None for those of several runs."""


def condense(run: xr.Dataset) -> xr.Dataset:
    """Run with the number of steps that it took."""
    if "steps" not in run.attrs:
        return run
    return run.assign(steps_taken=((), float(run.attrs["steps"]), attributes("steps_taken")))


def scenes_of(dataset: xr.Dataset) -> list[Scene]:
    """All scenes with a reference, those with most runs first."""
    groups: dict[tuple, list[Run]] = {}
    for run in map(_run, cases(dataset, "force_cutting_mean", "steps_taken", kind="mpm_cutting")):
        rest = {name: value for name, value in parameters(run.case).items() if name not in FIELDS}
        del rest["points_per_depth"]
        groups.setdefault(tuple(sorted(rest.items())), []).append(run)
    found = [_scene(runs) for runs in groups.values()]
    return sorted((scene for scene in found if scene), key=lambda scene: -len(scene.runs))


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel a scene."""
    found = scenes_of(dataset)[:3]
    figure = page(3.6, PAGE)
    if not found:
        nothing(figure.subplots())
        return figure
    panels = figure.subplots(1, len(found), squeeze=False, sharey=True)[0]
    panels[0].set_ylabel("error of the cutting force [%]")
    used = set()
    for ax, scene in zip(panels, found, strict=True):
        settings = [one for _, one in scene.settings]
        draw_settings(ax, settings, scene.reference, KNOBS)
        for run, one in scene.settings:
            if run and one.knob == SIZE:
                ax.annotate(
                    str(run.points), (one.cost, 100 * one.error), (3, 3), textcoords="offset points", fontsize=6
                )
        used |= {one.knob for one in settings}
        ax.set_title(scene.name, loc="left")
        ax.set_xlabel("run time on one core [s]")
    errors = [one.error for scene in found for _, one in scene.settings]
    panels[0].set_ylim(70 * min(errors), 150 * max(errors))
    figure.legend(handles=handles(KNOBS, used), loc="outside upper center", ncols=5, fontsize="x-small")
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """All settings of all scenes by cost."""
    header = ["scene", "reference [-]", "its standard error [-]", "knob", "setting", "force [-]", "deviation [%]"]
    header += ["standard error [%]", "error [%]", "run time by the model [s]", "measured [s]", "on the front"]
    rows = []
    for scene in scenes_of(dataset):
        best = front([one for _, one in scene.settings])
        for run, one in sorted(scene.settings, key=lambda pair: pair[1].cost):
            force = scene.reference.value * (1 + one.deviation)
            numbers = [force, 100 * one.deviation, 100 * one.noise, 100 * one.error, one.cost]
            measured = run.measured if run else math.nan
            mark = "yes" if one in best else "no"
            first = [plain(scene.name), *scene.reference, one.knob, plain(one.words)]
            rows.append([*first, *numbers, measured, mark])
    return Table("Error of the cutting force against run time", header, rows)


def _run(run: xr.Dataset) -> Run:
    case = case_of(run)
    force, error = over_toughness(run), over_toughness(run, "force_cutting_error")
    cost = seconds_of(case, float(run["steps_taken"]))
    return Run(case, force, error, touches(run), cost, float(run["wall_time"]))


def _scene(runs: list[Run]) -> Scene | None:
    """Scene of runs that agree in what is cut; None where no reference is known."""
    fields = [parameters(run.case) for run in runs]
    names = [name for name in FIELDS if name in fields[0]]
    usual = {name: _commonest([one[name] for one in fields]) for name in names} | USUAL
    series = [run for run, one in zip(runs, fields, strict=True) if all(one[name] == usual[name] for name in names)]
    series.sort(key=lambda run: run.points)
    if len({run.points for run in series}) < 3:
        return None
    elastic = runs[0].case.material.stress_yield >= ELASTIC
    fit = _fit([run for run in series if run.touching == series[-1].touching])
    if fit is None:
        return None
    reference = Reference(1.0, 0.0) if elastic else Reference(fit.limit, fit.error)
    settings: list[tuple[Run | None, Setting]] = []
    for run, one in zip(runs, fields, strict=True):
        changed = [name for name in names if one[name] != usual[name]]
        said = ", ".join(
            filter(None, (WORDS[name](one[name]) if name in WORDS else words(name, one[name]) for name in changed))
        )
        said = f"{run.points} points" + (f", {said}" if said else "")
        settings.append((run, setting(_knob(changed), said, run.cost, run.force, run.error, reference)))
    settings += [(None, one) for one in _pairs(series, reference)]
    return Scene(_name(runs[0], elastic), runs, usual, reference, settings)


def _knob(changed: Sequence[str]) -> str:
    """Knob of the fields that differ from the standard setting; those that the paper's loop rules out go with it."""
    if "scheme" in changed:
        return FIELDS["scheme"]
    knobs = {FIELDS[name] for name in changed}
    return SIZE if not knobs else knobs.pop() if len(knobs) == 1 else SEVERAL


def _commonest(values: list) -> Any:
    return max(set(values), key=values.count)


def _fit(series: Sequence[Run]) -> Fit | None:
    if len({run.points for run in series}) < 2:
        return None
    return extrapolate([1 / run.points for run in series], [run.force for run in series], [run.error for run in series])


def _pairs(series: Sequence[Run], reference: Reference) -> list[Setting]:
    """Straight lines to zero size through two runs of the regime of the finest."""
    same = [run for run in series if run.touching == series[-1].touching]
    found = []
    for coarse, fine in itertools.combinations(same, 2):
        if fine.points >= RATIO * coarse.points:
            fit = _fit([coarse, fine])
            said = f"{coarse.points} and {fine.points} points"
            found.append(setting(PAIR, said, coarse.cost + fine.cost, fit.limit, fit.error, reference))
    return found


def _name(run: Run, elastic: bool) -> str:
    if elastic:
        return f"elastic, {run.case.interface.failure_criterion}"
    kind = "touching" if run.touching else "bending"
    return rf"{kind}, $E_T$ = {run.case.material.modulus_tangent * 1e-6:g} MPa"
