"""Nairn (2015), Figs 8, 11-15: dimensionless cutting force over depth of cut, simulated and by both models."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import label, nothing, page, styled
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.sweep import dimensionless_depth, group_name, grouped, legend_columns, touches
from orthocut.io.collect import case_of
from orthocut.theory import bending, touching

CAPTION = (
    "Cutting force over depth of cut, both dimensionless, after Nairn (2015), Figs 8 and 11-15. Open symbols: the "
    "tool touches the crack tip; filled: a gap separates them; bars: standard error of the mean. Dotted: touching "
    "model, eq. (14). Dashed: bending model as printed, eqs (18), (19), with a straight line through the rubbing "
    "forces of the runs that bend. Solid: bending model with the chip in balance, without rubbing. "
    "Runs carry a discretisation error beside the bars: see the figure of force over particle size. "
    "Crosses on the axis: failed runs."
)
DIMS = ()
CURVE_POINTS = 60
MODELS = ((":", "touching model"), ("--", "bending, printed"), ("-", "bending, consistent"))


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour for each rake angle, friction, tangent modulus and cohesive stress."""
    figure = page(3.4)
    ax = figure.subplots()
    ax.set_xlabel(label("depth_dimensionless") + " [-]")
    ax.set_ylabel(label("force_over_toughness") + " [-]")
    groups = grouped(dataset, "force_cutting_mean")
    mark(ax, [dimensionless_depth(run) for run in failed(dataset, "mpm_cutting")])
    if not groups:
        nothing(ax)
        return figure

    marks = []
    deepest = max(case_of(run).cut_depth for runs in groups.values() for run in runs)
    for colour, (group, runs) in zip(SERIES * 9, sorted(groups.items()), strict=False):
        _curves(ax, runs, 1.08 * deepest, colour)
        _symbols(ax, runs, colour)
        marks.append(Line2D([], [], color=colour, marker="o", ls="", label=group_name(group, groups)))
    highest = max(_force(run) for runs in groups.values() for run in runs)
    ax.set_xlim(left=0)
    ax.set_ylim(0, 1.25 * highest)
    lines = [Line2D([], [], color="0.25", ls=style, label=text) for style, text in MODELS]
    states = [
        Line2D([], [], color="0.25", marker="o", mfc=face, ls="", label=text)
        for face, text in (("white", "run, touching"), ("0.25", "run, bending"))
    ]
    columns = (marks, states, lines) if legend_columns(groups) == 3 else (marks, states + lines)
    rows = max(map(len, columns))
    blank = Line2D([], [], ls="", label=" ")
    handles = [entry for column in columns for entry in column + [blank] * (rows - len(column))]
    figure.legend(handles=handles, loc="outside upper center", ncols=len(columns), columnspacing=1.2)
    return figure


def _force(run: xr.Dataset) -> float:
    return float(run["force_cutting_mean"]) / case_of(run).interface.toughness


def _symbols(ax, runs: list[xr.Dataset], colour: str) -> None:
    for run in runs:
        error = float(run["force_cutting_error"]) / case_of(run).interface.toughness
        ax.errorbar(
            dimensionless_depth(run),
            _force(run),
            yerr=error if math.isfinite(error) else None,
            fmt="o",
            color=colour,
            mfc="white" if touches(run) else colour,
            capsize=2,
            elinewidth=0.8,
            zorder=3,
        )


def _rubbing(runs: list[xr.Dataset], depths: np.ndarray) -> np.ndarray:
    """Rubbing force at some depths of cut [N/m]: a straight line through that of the runs, as in the paper."""
    known = [(case_of(run).cut_depth, float(run["force_rubbing_mean"])) for run in runs if "force_rubbing_mean" in run]
    x, y = np.array([pair for pair in known if math.isfinite(pair[1])]).reshape(-1, 2).T
    if x.size < 2:
        return np.full_like(depths, y[0] if y.size else 0.0)
    return np.maximum(np.polyval(np.polyfit(x, y, 1), depths), 0.0)


def _curves(ax, runs: list[xr.Dataset], deepest: float, colour: str) -> None:
    """Curves of both models; the paper's form of the bending model is drawn where runs bend."""
    case = case_of(runs[0])
    blocks = (case.material, case.interface, case.tool)
    depths = np.linspace(deepest / CURVE_POINTS, deepest, CURVE_POINTS)
    touched, bent = [run for run in runs if touches(run)], [run for run in runs if not touches(run)]
    solutions = {
        ":": [touching.solve(*blocks, *pair) for pair in zip(depths, _rubbing(touched, depths), strict=True)],
        "-": [bending.solve(*blocks, depth) for depth in depths],
    }
    if bent:
        depths = depths[depths >= 0.98 * case_of(bent[0]).cut_depth]
        pairs = zip(depths, _rubbing(bent, depths), strict=True)
        solutions["--"] = [bending.solve(*blocks, *pair, form="paper") for pair in pairs]
    for style, found in solutions.items():
        x, y = [item.depth_dimensionless for item in found], [item.force_over_toughness for item in found]
        ax.plot(x, y, ls=style, color=colour, lw=0.9)
