"""Yang et al. (2018), Figs 11-14: cuts of glass, with cracks by mode, beside the forces on the tool."""

from __future__ import annotations

import math
from collections import defaultdict

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, cases, nothing, page, styled, values
from orthocut.figures.palette import QUANTITY
from orthocut.figures.scene import draw_cracks, draw_discs, draw_tool, frame, last_snapshot
from orthocut.figures.specimen import crack_legend, draw_forces, extent
from orthocut.figures.yang2018_paper import FORCES, SIMULATION, mean
from orthocut.io.collect import case_of

CAPTION = (
    "Cut of the synthetic glass block: the last snapshot with all cracks where they formed (green: shear, blue: "
    "tension) and the forces over the travel of the tool, after Yang et al. (2018), Figs 11-14. Pale: the other "
    "replicates; dotted: averages over the travel and all replicates; dashed: those of the paper (Table 4)."
)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One row for each depth of cut, without and with grooves; the first replicate is shown in full."""
    rows = defaultdict(list)
    for run in cases(dataset, "force_cutting", "tool_travel", kind="dem_cutting"):
        case = case_of(run)
        rows[(case.cut_depth, case.grooves is not None)].append(run)
    figure = page(2.9 * max(len(rows), 1), PAGE)
    panels = figure.subplots(max(len(rows), 1), 2, squeeze=False)
    for (picture, curves), (key, runs) in zip(panels, sorted(rows.items()), strict=False):
        runs.sort(key=lambda run: case_of(run).packing.seed)
        _picture(picture, runs[0])
        _forces(curves, runs)
        depth, grooved = key
        curves.set_title(
            f"$h$ = {depth * 1e3:.3g} mm, {'grooved' if grooved else 'regular'}",
            loc="left",
            pad=16,
        )
    if not rows:
        nothing(panels[0, 0])
        nothing(panels[0, 1])
    return figure


def _picture(ax, run: xr.Dataset) -> None:
    case, last = case_of(run), last_snapshot(run, "disc_x")
    if last < 0:
        nothing(ax, "no snapshot")
        return
    time, tips = np.atleast_1d(run.get("time_snapshot", math.nan)), np.atleast_1d(values(run, "tool_tip_snapshot"))
    draw_discs(ax, run, last, width=0.12)
    counts = draw_cracks(ax, run, float(time[last]) if last < time.size else math.inf, width=0.8)
    width, height = case.packing.width * 1e3, case.packing.height * 1e3
    (left, right), (bottom, top) = extent(run, last)
    margin = 0.02 * width
    if last < tips.size:
        draw_tool(ax, case.tool, float(tips[last]), height - case.cut_depth * 1e3, 2 * (width + height), filled=False)
    frame(ax, (left - margin, max(right, width) + margin), (max(bottom, 0) - margin, top + 3 * margin))
    ax.legend(handles=crack_legend(*counts), loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def _forces(ax, runs: list[xr.Dataset]) -> None:
    case = case_of(runs[0])
    paper = SIMULATION.get((round(1e3 * case.cut_depth, 9), case.grooves is not None), {})
    for run in runs[1:]:
        for name in FORCES:
            ax.plot(values(run, "tool_travel"), values(run, name), color=QUANTITY[name], lw=0.5, alpha=0.3)
    if len(runs) > 1:
        ax.plot([], [], color="0.75", lw=0.8, label="others")
    draw_forces(ax, runs[0], lw=0.8)
    for name in FORCES:
        means = [float(values(run, f"{name}_mean")) for run in runs]
        if np.isfinite(means).any():
            ax.axhline(np.nanmean(means), color=QUANTITY[name], ls=":", lw=1.2)
        if name in paper:
            ax.axhline(mean(paper[name]), color=QUANTITY[name], ls="--", lw=0.8)
    ax.axhline(0, color="0.4", lw=0.6)
    ax.set_xlim(0, max(np.nanmax(values(run, "tool_travel")) for run in runs))
    for style, text in ((":", "mean"), ("--", "Yang et al.")):
        ax.plot([], [], color="0.4", ls=style, lw=1.0, label=text)
    ax.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=5, borderaxespad=0.2, columnspacing=0.9, handlelength=1.4)
