"""What the mean forces of cuts of glass depend on beside the physics: speed, damping, grains, step, replicates."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator

from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.confidence import Interval, interval
from orthocut.figures.palette import AMBER, BLACK, GREEN, PURPLE, QUANTITY, SKY
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_finding import over
from orthocut.figures.yang2018_paper import FORCES, NAMES, words
from orthocut.figures.yang2018_runs import (
    PARTS,
    GlassRun,
    along,
    condense,
    condition,
    conditions,
    cuts_of,
    forces,
)
from orthocut.io.collect import parameters
from orthocut.variables import VARIABLES

__all__ = ["CAPTION", "DIMS", "condense", "draw", "tabulate"]

CAPTION = (
    "Mean main force (filled) and thrust force (open) of cuts of glass over the speed of the tool, the local "
    "damping, the smallest radius of the discs and the time step; runs of a series differ in nothing else but the "
    "packing. Bars: 95 % confidence intervals by Student's t. Then the half-width of such an interval over the mean, "
    "for the first packings, with the 10 % that are wanted; and means over the travel up to a place. The table "
    "compares each value with the reference of its series packing by packing."
)
DIMS = ("sample",)
PANELS = (
    ("cut_speed", "speed of the tool $v$ [m/s]", 0.0),
    ("joint_damping", "local damping [-]", 0.1),
    ("packing_radius_min", "smallest radius $R_{min}$ [µm]", 0.0),
    ("joint_time_step_factor", "time step factor [-]", 0.0),
)
"""Fields, labels, and the value to compare with: the nearest one of `KNOWN` packings is the reference of a series."""
KNOWN = 4
"""Fewest packings of a reference, where a series has such a value."""
LOGARITHMIC = frozenset({"cut_speed"})
WANTED = 0.1
"""Half-width of the interval of a mean over the mean that is wanted."""
MARKERS = "osD^v"
CUTS = (GREEN, SKY, PURPLE, AMBER)
"""Colours of the cuts of the paper, by depth of cut and surface."""
ROOM = 2.2
"""Top of an axis over the largest mean: intervals of few packings may be longer."""
CONDITION = ("cut_depth", "grooved")
"""Fields that the words for a cut name."""
LEAST, DRAWN = 2, 3
"""Fewest values of a series in the table, and of one that is drawn where there is another."""


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel for each field, then replicates and travel."""
    cuts = cuts_of(dataset)
    figure = page(4.8, PAGE)
    panels = list(figure.subplots(2, 3).flat)
    if not cuts:
        for ax in panels:
            nothing(ax)
            ax.set_axis_off()
        return figure

    for ax, (name, text, _) in zip(panels[:4], PANELS, strict=True):
        _field(ax, cuts, name)
        ax.set_xlabel(text)
        ax.set_ylabel("mean force [N/mm]")
    found = conditions(cuts)
    _replicates(panels[4], found)
    _travel(panels[5], found)
    handles = [
        Line2D([], [], color=colour, label=words(cut)) for (cut, _), colour in zip(found.items(), CUTS, strict=False)
    ]
    handles += [
        Line2D([], [], color=QUANTITY[name], marker="o", mfc=face, ls="", label=f"{NAMES[name]} force")
        for name, face in zip(FORCES, (QUANTITY[FORCES[0]], "white"), strict=True)
    ]
    figure.legend(handles=handles, loc="outside upper center", ncols=3)
    return figure


def _field(ax: Axes, cuts: Sequence[GlassRun], field: str) -> None:
    """Means with their intervals over one field; one symbol a series, named where there are several."""
    groups = along(cuts, field, LEAST)
    groups = [group for group in groups if len(group) >= DRAWN] or groups[:1]
    if not groups:
        ax.text(0.5, 0.5, "no series", transform=ax.transAxes, ha="center", color="0.5")
    names = _names(groups, field)
    for group, marker, name in zip(groups, MARKERS, names, strict=False):
        if name:
            ax.plot([], [], f"{marker}-", color=BLACK, lw=0.6, label=name)
        places = np.array(list(group)) * VARIABLES[field].scale
        for force, face in zip(FORCES, (QUANTITY[FORCES[0]], "white"), strict=True):
            known = [interval(forces(runs, force)) for runs in group.values()]
            bars = [one.half if math.isfinite(one.half) else 0.0 for one in known]
            style = {"color": QUANTITY[force], "mfc": face, "capsize": 2, "elinewidth": 0.8, "lw": 0.6}
            ax.errorbar(places, [one.mean for one in known], yerr=bars, fmt=f"{marker}-", **style)
    if any(names):
        ax.legend(loc="upper left", fontsize=6)
    if field in LOGARITHMIC and groups:
        ax.set_xscale("log")
        ticks = sorted({value * VARIABLES[field].scale for group in groups for value in group})
        ax.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        ax.minorticks_off()
    else:
        ax.set_xlim(0, 1.06 * ax.get_xlim()[1] if groups else 1.0)
    means = [interval(forces(runs, name)).mean for group in groups for runs in group.values() for name in FORCES]
    ax.set_ylim(0, ROOM * max(means, default=1.0))


def _names(groups: Sequence[dict[float, list[GlassRun]]], field: str) -> list[str]:
    """What tells series apart, beside the depth of cut and the surface; nothing for a single one."""
    fields = [dict(parameters(next(iter(group.values()))[0].case)) for group in groups]
    names = [name for name in (fields[0] if fields else ()) if name not in (field, "seed", *CONDITION)]
    differ = [name for name in names if len({one.get(name) for one in fields}) > 1]
    return [", ".join(_valued(name, one[name]) for name in differ if name in one) for one in fields]


def _valued(name: str, value: float) -> str:
    """A field with its value and unit."""
    variable = VARIABLES[name]
    unit = variable.display or variable.unit
    return f"{variable.long_name} {value * variable.scale:g}{'' if unit == '1' else f' {unit}'}"


def _replicates(ax: Axes, found: dict) -> None:
    """Half-width of the interval of the first replicates over their mean, against their number."""
    ax.axhline(100 * WANTED, color=BLACK, lw=0.6, ls="--")
    most = LEAST + 2
    for (_, runs), colour in zip(found.items(), CUTS, strict=False):
        values = forces(runs, FORCES[0])
        most = max(most, len(values))
        counts = range(LEAST + 1, len(values) + 1)
        ax.plot(counts, [100 * interval(values[:count]).relative for count in counts], color=colour)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlim(LEAST + 1, most)
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_locator(LogLocator(10, (1, 2, 5)))
        axis.set_major_formatter("{x:g}")
    ax.minorticks_off()
    ax.set_xlabel("number of packings [-]")
    ax.set_ylabel("half-width of main force [%]")


def _travel(ax: Axes, found: dict) -> None:
    """Mean over the travel up to a place, of all replicates."""
    for (_, runs), colour in zip(found.items(), CUTS, strict=False):
        parts = [run.parts[FORCES[0]] for run in runs if FORCES[0] in run.parts]
        if not parts:
            continue
        travel = 1e3 * runs[0].case.travel * np.arange(1, PARTS + 1) / PARTS
        running = np.cumsum(np.mean(parts, axis=0)) / np.arange(1, PARTS + 1)
        ax.plot(travel, running, "-", color=colour)
    ax.set_xlim(left=0)
    ax.set_ylim(bottom=0)
    ax.set_xlabel("travel averaged over [mm]")
    ax.set_ylabel("mean main force [N/mm]")


def tabulate(dataset: xr.Dataset) -> Table:
    """Means of each value of a field, and the change against the reference, packing by packing."""
    header = ["field", "unit", "cut", "series", "value", "packings", "force", "mean [N/mm]", "95 % half-width [N/mm]"]
    header += ["against", "change, same packings [%]", "95 % half-width [%]"]
    cuts, rows = cuts_of(dataset), []
    for field, _, wanted in PANELS:
        variable = VARIABLES[field]
        groups = along(cuts, field, LEAST)
        for group, series in zip(groups, _names(groups, field), strict=True):
            many = [value for value, runs in group.items() if len(runs) >= KNOWN] or list(group)
            reference = min(many, key=lambda value: abs(value - wanted))
            for value, runs in group.items():
                for name in FORCES:
                    known, change = interval(forces(runs, name)), changes(runs, group[reference], name)
                    first = [variable.long_name, variable.display or variable.unit, words(condition(runs[0])), series]
                    rows.append(
                        [
                            *(*first, value * variable.scale, known.count, NAMES[name], known.mean, known.half),
                            *(reference * variable.scale, 100 * change.mean, 100 * change.half),
                        ]
                    )
    return Table("Mean forces over speed, damping, size of the discs and time step", header, rows)


def changes(runs: Sequence[GlassRun], reference: Sequence[GlassRun], name: str) -> Interval:
    """Change of a mean force against the reference over that of the reference, by packings that both have [-].

    Where discs differ in size, the same seed does not give the same packing; the pairs are then as good as random.
    """
    found = over(runs, reference, f"{name}_mean")
    return found._replace(mean=found.mean - 1)
