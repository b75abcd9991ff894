"""Damage below the cut and chips: what grooves, their shape and the depth of cut change (Yang et al. 2018, Figs 11-14).

The paper shows pictures and speaks of fewer, shorter and shallower cracks; here they are counted and measured.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.confidence import interval
from orthocut.figures.palette import BLUE, GREEN, GREY, ORANGE, SHEAR, TENSION
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_runs import GlassRun, cuts_of, usual
from orthocut.params.dem import Grooves
from orthocut.variables import VARIABLES

CAPTION = (
    "Forces, damage below the cut, cracks there by kind, and chips of cuts of glass: without grooves, with the paper's "
    "rectangular grooves and with other grooves. Bars: means over the packings with their 95 % confidence intervals by "
    "Student's t. Damage: depth below the cut of the deepest crack (pale) and the depth that 95 % of the cracks below "
    "the cut keep to (full). The table has more: peaks, share of the travel in the air, single grains."
)
DIMS = ()
ROOM = 1.8
"""Top of an axis over the largest mean: intervals of few packings may be longer."""
Group = tuple[float, str]
"""Depth of cut [mm] and surface in words."""
PANELS: tuple[tuple[str, tuple[tuple[str, str], ...]], ...] = (
    ("mean force [N/mm]", (("force_cutting_mean", BLUE), ("force_thrust_mean", ORANGE))),
    ("depth of damage [mm]", (("damage_depth", "0.75"), ("damage_depth_most", "0.35"))),
    ("cracks below the cut [-]", (("cracks_tension_below", TENSION), ("cracks_shear_below", SHEAR))),
    ("area of chips [mm$^2$]", (("chip_area_total", GREEN), ("chip_area_largest", GREY))),
)
SAID = {
    "force_cutting_mean": "main",
    "force_thrust_mean": "thrust",
    "damage_depth": "deepest",
    "damage_depth_most": "95 %",
    "cracks_tension_below": "tension",
    "cracks_shear_below": "shear",
    "chip_area_total": "all",
    "chip_area_largest": "largest",
}
COLUMNS = (
    *("force_cutting_mean", "force_thrust_mean", "force_cutting_contact", "force_thrust_contact"),
    *("force_cutting_peak", "force_thrust_peak", "air_share", "damage_depth", "damage_depth_most"),
    *("cracks_tension_total", "cracks_shear_total", "cracks_tension_below", "cracks_shear_below"),
    *("chip_count", "chip_area_largest", "chip_area_total", "grain_count"),
)
"""Numbers of the table."""


def surface(grooves: Grooves | None) -> str:
    """Surface in words; lengths in mm."""
    if grooves is None:
        return "regular"
    if grooves == Grooves():
        return "grooved"
    usual_ones = Grooves()
    parts = []
    if grooves.bottom_ratio != usual_ones.bottom_ratio:
        parts.append(f"foot {grooves.bottom_ratio:g}")
    if grooves.distance != usual_ones.distance:
        parts.append(f"{1e3 * grooves.distance:g} mm apart")
    if grooves.width != usual_ones.width:
        parts.append(f"{1e3 * grooves.width:g} mm wide")
    return f"grooved, {', '.join(parts)}"


def grouped(cuts: Sequence[GlassRun]) -> dict[Group, list[GlassRun]]:
    """Usual cuts by depth of cut and surface; the regular one first, then the paper's grooves."""
    found: dict[Group, list[GlassRun]] = defaultdict(list)
    for cut in usual(cuts):
        found[(round(1e3 * cut.case.cut_depth, 9), surface(cut.case.grooves))].append(cut)
    order = {"regular": 0, "grooved": 1}
    return dict(sorted(found.items(), key=lambda pair: (pair[0][0], order.get(pair[0][1], 2), pair[0][1])))


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel a measure, one column a depth of cut and surface."""
    found = grouped(cuts_of(dataset))
    figure = page(5.4, PAGE)
    panels = figure.subplots(2, 2, sharex=True)
    if not found:
        for ax in panels.flat:
            nothing(ax)
            ax.set_axis_off()
        return figure

    for ax, (text, names) in zip(panels.flat, PANELS, strict=True):
        for shift, (name, colour) in zip((-0.2, 0.2), names, strict=True):
            known = [interval([run[name] for run in runs]) for runs in found.values()]
            places = np.arange(len(found)) + shift
            ax.bar(places, [one.mean for one in known], 0.36, color=colour, label=SAID[name])
            bars = [one.half if math.isfinite(one.half) else 0.0 for one in known]
            ax.errorbar(places, [one.mean for one in known], yerr=bars, fmt="none", ecolor="black", capsize=2, lw=0.8)
        ax.set_ylabel(text)
        heights = [bar.get_height() for bar in ax.patches if bar.get_height() > 0]
        ax.set_ylim(0, ROOM * max(heights, default=1.0))
        ax.grid(axis="x", visible=False)
        ax.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2, borderaxespad=0)
    for ax in panels[1]:
        labels = [f"{depth:g} mm\n" + words.replace(", ", "\n").replace(" apart", "\napart") for depth, words in found]
        ax.set_xticks(range(len(found)), labels, fontsize=5)
        ax.set_xlabel("depth of cut, surface")
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Mean and 95 % half-width of every measure, by depth of cut and surface."""
    header = ["depth of cut [mm]", "surface", "packings"]
    for name in COLUMNS:
        variable = VARIABLES[name]
        unit = (variable.display or variable.unit).replace("$^2$", "2")
        header += [f"{variable.long_name} [{'-' if unit == '1' else unit}]", "± 95 %"]
    rows = []
    for (depth, words), runs in grouped(cuts_of(dataset)).items():
        known = [interval([run[name] for run in runs]) for name in COLUMNS]
        rows.append([f"{depth:g}", words, len(runs), *(number for one in known for number in (one.mean, one.half))])
    return Table("Damage, chips and forces by depth of cut and surface", header, rows)
