"""Nairn (2015), Fig. 4: forces on the tool over time."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import cases, line, name_axes, nothing, page, styled, values
from orthocut.figures.palette import QUANTITY
from orthocut.io.collect import case_of

CAPTION = (
    "Cutting force and negative thrust force of the tool over time, after Nairn (2015), Fig. 4. "
    "Shaded: the window of the averages; dotted: the averages; grey line: end of the tool's speeding up."
)
DIMS = ("sample",)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel a run."""
    runs = cases(dataset, "force_cutting", "time", kind="mpm_cutting")
    figure = page(2.3 * max(len(runs), 1))
    panels = figure.subplots(max(len(runs), 1), squeeze=False)[:, 0]
    for ax, run in zip(panels, runs, strict=False):
        _panel(ax, run)
    for ax in panels[len(runs) :]:
        nothing(ax)
    return figure


def _panel(ax, run: xr.Dataset) -> None:
    case = case_of(run)
    for name, sign, text in (("force_cutting", 1, "$F_c$"), ("force_thrust", -1, "$-F_t$")):
        line(ax, run, "time", name, sign, color=QUANTITY[name], label=text)
        mean = sign * float(values(run, f"{name}_mean"))
        if math.isfinite(mean):
            ax.axhline(mean, color=QUANTITY[name], ls=":", lw=0.9)
    time, travel = values(run, "time"), values(run, "tool_travel")
    end = np.nanmax(time)
    averaged = time[travel >= case.window_ratio * case.cut_depth * 1e3]
    if averaged.size:
        ax.axvspan(averaged[0], end, color="#F3F3F3", zorder=0)
    ax.axvline(1e3 * case.numerics.ramp_fraction * case.duration, color="0.6", lw=0.8)
    name_axes(ax, "time", "force on the tool [N/mm]")
    ax.set_xlim(0, end)
    ax.axhline(0, color="0.4", lw=0.6)
    ax.legend(ncols=2, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0)
    ax.set_title(
        rf"$h$ = {case.cut_depth * 1e3:.3g} mm, $\alpha$ = {math.degrees(case.tool.rake_angle):.3g}°",
        loc="right",
    )
