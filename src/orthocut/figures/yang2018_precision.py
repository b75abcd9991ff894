"""Error of the mean forces of cuts of glass against cost: speed, damping, discs, time step, block, replicates."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orthocut.cost import estimate_seconds
from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.confidence import Interval, interval, quantile
from orthocut.figures.extrapolation import extrapolate
from orthocut.figures.palette import AMBER, BLUE, GREEN, GREY, ORANGE, PURPLE
from orthocut.figures.precision import Reference, Setting, draw_settings, handles
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_paper import FORCES, NAMES, words
from orthocut.figures.yang2018_runs import GlassRun, condition, cuts_of, forces
from orthocut.io.collect import parameters
from orthocut.variables import VARIABLES

CAPTION = (
    "Error of a mean over packings against the run time of all of them on one core. Error: root of the squares of the "
    "deviation of the mean of all packings from the reference and of the half-width of the 95 % confidence interval "
    "that so many packings have, by the spread of those that were run. Reference: the mean force at zero speed of the "
    "tool, by a straight fit over all speeds, weighted by packings, or that at the only speed there is; shaded up to "
    "the half-width of its own interval: what lies below cannot be told apart from no deviation. Each symbol differs "
    "from the cuts of that fit in what the legend names, a line is one setting with 1, 2, 4, 8, 16 and 32 packings; "
    "beside its end stand the speed of the tool and what else is set. Settings of fewer than three packings, and "
    "several at once, stand in the table alone. Bars: half-widths of setting and reference. Line: settings than which "
    "no cheaper one has a smaller error. Size of the discs is no setting of the method alone: the strength of the "
    "block changes with it; nor is damping: the force at zero speed may change with it."
)
DIMS = ()
FIELDS = {
    "cut_speed": "tool speed",
    "joint_damping": "damping",
    "packing_radius_min": "size of the discs",
    "joint_time_step_factor": "time step",
    "packing_height": "height of the block",
}
SEVERAL = "several together"
KNOBS = {
    "tool speed": ("o", BLUE),
    "damping": ("X", GREY),
    "size of the discs": ("s", ORANGE),
    "time step": ("v", AMBER),
    "height of the block": ("D", GREEN),
    SEVERAL: ("h", PURPLE),
}
"""Knob to marker and colour."""
COUNTS = (1, 2, 4, 8, 16, 32)
"""Numbers of packings."""
KNOWN = 3
"""Fewest packings of a setting that is drawn, where there are such settings."""
GAP = 0.05
"""Least distance of two names of lines over the height of a panel."""


@dataclass(frozen=True)
class Ensemble:
    """Cuts that differ in their packing alone."""

    runs: list[GlassRun]
    knob: str
    usual_speed: bool
    """Whether the tool has the speed of most cuts."""
    words: str
    brief: str
    """The same in few signs."""

    @property
    def is_drawn(self) -> bool:
        """Whether enough packings tell their spread, and one thing alone differs from most cuts."""
        return len(self.runs) >= KNOWN and (self.usual_speed or self.knob == FIELDS["cut_speed"])

    @property
    def cost(self) -> float:
        """Run time of one of them on one core, by the cost model [s]."""
        return estimate_seconds(self.runs[0].case)

    def settings(self, name: str, reference: Reference) -> list[Setting]:
        """Means over different numbers of packings, of which the spread of those that were run tells the interval."""
        known = interval(forces(self.runs, name))
        deviation = known.mean / reference.value - 1
        half = quantile(known.count) * known.spread / reference.value
        return [
            Setting(self.knob, f"{self.words}, {count} packings", count * self.cost, deviation, half / math.sqrt(count))
            for count in COUNTS
        ]


@dataclass(frozen=True)
class Scene:
    """A cut and its ensembles."""

    ensembles: list[Ensemble]
    usual: list[Ensemble]
    """Those that differ from the commonest in the speed of the tool alone, by speed."""

    @property
    def drawn(self) -> list[Ensemble]:
        """Ensembles that the picture shows: all, where few packings are all there is."""
        known = [ensemble for ensemble in self.ensembles if ensemble.is_drawn]
        return known if len(known) > 1 else self.ensembles

    @property
    def name(self) -> str:
        """Depth of cut and surface."""
        return words(condition(self.usual[0].runs[0]))

    def reference(self, name: str) -> Reference:
        """Mean of a force at zero speed and the half-width of its interval [N/mm]."""
        known = [interval(forces(ensemble.runs, name)) for ensemble in self.usual]
        if len(known) == 1:
            return Reference(known[0].mean, known[0].half)
        speeds = [ensemble.runs[0].case.cut_speed for ensemble in self.usual]
        spread = _pooled(known)
        errors = [spread / math.sqrt(one.count) for one in known]
        fit = extrapolate(speeds, [one.mean for one in known], errors)
        return Reference(fit.limit, quantile(sum(one.count - 1 for one in known)) * fit.error)


def _pooled(known: Sequence[Interval]) -> float:
    """Standard deviation of single cuts, the same at all speeds: a few cuts do not tell their own."""
    freedom = [one.count - 1 for one in known]
    return math.sqrt(sum(f * one.spread**2 for f, one in zip(freedom, known, strict=True)) / sum(freedom))


def scenes_of(dataset: xr.Dataset) -> list[Scene]:
    """Cuts with a reference, those with most ensembles first."""
    scenes: dict[tuple, dict[tuple, list[GlassRun]]] = defaultdict(lambda: defaultdict(list))
    for run in cuts_of(dataset):
        fields = parameters(run.case)
        del fields["seed"]
        key = tuple(fields.pop(name) for name in FIELDS)
        scenes[tuple(sorted(fields.items()))][key].append(run)
    found = [_scene({key: runs for key, runs in groups.items() if len(runs) > 1}) for groups in scenes.values()]
    return sorted((scene for scene in found if scene), key=lambda scene: -len(scene.ensembles))


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Both forces of the cut of which most is known."""
    found = [scene for scene in scenes_of(dataset) if len(scene.drawn) > 1]
    figure = page(3.4, PAGE)
    if not found:
        nothing(figure.subplots(), "no cut with several settings and packings")
        return figure
    scene = found[0]
    panels = figure.subplots(1, len(FORCES), sharey=True)
    panels[0].set_ylabel("error of the mean force [%]")
    for ax, name in zip(panels, FORCES, strict=True):
        reference = scene.reference(name)
        draw_settings(ax, [one for some in scene.drawn for one in some.settings(name, reference)], reference, KNOBS)
        for ensemble in scene.drawn:
            colour = KNOBS[ensemble.knob][1]
            settings = ensemble.settings(name, reference)
            ax.plot(
                [one.cost for one in settings], [100 * one.error for one in settings], color=colour, lw=0.5, alpha=0.6
            )
        ax.set_title(f"{NAMES[name]} force, {scene.name}", loc="left")
        ax.set_xlabel("run time of all packings on one core [s]")
    errors = [
        one.error for name in FORCES for some in scene.drawn for one in some.settings(name, scene.reference(name))
    ]
    panels[0].set_ylim(50 * min(errors), 200 * max(errors))
    for ax, name in zip(panels, FORCES, strict=True):
        _label_lines(ax, scene, name)
    used = {ensemble.knob for ensemble in scene.drawn}
    figure.legend(handles=handles(KNOBS, used), loc="outside upper center", ncols=4)
    return figure


def _label_lines(ax: Axes, scene: Scene, name: str) -> None:
    """Short names of the ensembles beside the ends of their lines, in their order, none on another."""
    low, high = np.log10(ax.get_ylim())
    reference = scene.reference(name)
    ends = [np.log10(100 * one.settings(name, reference)[-1].error) for one in scene.drawn]
    place = -math.inf
    for end, ensemble in sorted(zip(ends, scene.drawn, strict=True), key=lambda pair: pair[0]):
        place = max((end - low) / (high - low), place + GAP)
        style = {"transform": ax.transAxes, "color": KNOBS[ensemble.knob][1], "fontsize": 5, "va": "center"}
        ax.text(1.01, place, ensemble.brief, **style)


def tabulate(dataset: xr.Dataset) -> Table:
    """All ensembles at the packings that were run, and what 32 of them would give."""
    header = ["cut", "force", "knob", "setting", "packings", "mean [N/mm]", "reference [N/mm]", "deviation [%]"]
    header += ["95 % half-width [%]", "run time of a packing [s]", "run time of all [s]", "error of 32 packings [%]"]
    rows = []
    for scene in scenes_of(dataset):
        for name in FORCES:
            reference = scene.reference(name)
            for ensemble in scene.ensembles:
                known = interval(forces(ensemble.runs, name))
                settings = ensemble.settings(name, reference)
                first = [scene.name, NAMES[name], ensemble.knob, ensemble.words, known.count, known.mean]
                numbers = [reference.value, 100 * settings[0].deviation, 100 * known.half / reference.value]
                costs = [ensemble.cost, known.count * ensemble.cost]
                rows.append([*first, *numbers, *costs, 100 * settings[-1].error])
    return Table("Error of mean forces against run time", header, rows)


def _scene(groups: dict[tuple, list[GlassRun]]) -> Scene | None:
    """Scene of the ensembles of a cut; None without any."""
    if not groups:
        return None
    speed, *commonest = (Counter(column).most_common(1)[0][0] for column in zip(*groups, strict=True))
    ensembles = {
        key: Ensemble(runs, _knob(key[1:], commonest), key[0] == speed, *_words(key, commonest))
        for key, runs in sorted(groups.items())
    }
    usual = [ensemble for key, ensemble in ensembles.items() if key[1:] == tuple(commonest)]
    return Scene(list(ensembles.values()), usual) if usual else None


def _knob(key: Sequence[float], commonest: Sequence[float]) -> str:
    """What a setting differs in from the commonest, beside the speed; the speed where that is all."""
    speed, *others = FIELDS.values()
    changed = [knob for knob, one, usual in zip(others, key, commonest, strict=True) if one != usual]
    return speed if not changed else changed[0] if len(changed) == 1 else SEVERAL


def _words(key: Sequence[float], commonest: Sequence[float]) -> tuple[str, str]:
    """Speed, and all else that differs from the commonest setting, at length and in short."""
    said, brief = [], []
    for name, one, usual in zip(FIELDS, key, (None, *commonest), strict=True):
        row = VARIABLES[name]
        if one != usual:
            value = f"{one * row.scale:.4g} {row.display or row.unit}".removesuffix(" 1")
            said.append(f"{row.long_name} {value}")
            brief.append(value.replace("um", "µm"))
    return ", ".join(said), ", ".join(brief)
