"""One run at a glance: forces or stress, energies, last snapshot."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, cases, label, line, name_axes, nothing, page, styled, values
from orthocut.figures.energy_balance import draw_energies
from orthocut.figures.palette import QUANTITY
from orthocut.figures.scene import draw_cracks, draw_discs, draw_points, draw_tool, frame, last_snapshot, parallelograms
from orthocut.figures.specimen import crack_legend, draw_forces, extent
from orthocut.io.collect import case_of

CAPTION = "One run: forces on the tool or stress in the specimen, energies, and the last snapshot."


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """First run of a dataset, of any kind."""
    runs = cases(dataset)
    figure = page(5.6, PAGE)
    if not runs:
        nothing(figure.subplots())
        return figure

    run, case = runs[0], case_of(runs[0])
    (curves, energies), (left, right) = figure.subplots(2, 2, height_ratios=[1, 1.4])
    grid = left.get_gridspec()
    left.remove()
    right.remove()
    picture = figure.add_subplot(grid[1, :])
    _curves(curves, run)
    _energies(energies, run)
    if "point_x" in run and last_snapshot(run, "point_x") >= 0:
        _points(picture, run, case)
    elif last_snapshot(run, "disc_x") >= 0:
        _discs(picture, run, case)
    else:
        nothing(picture, "no snapshot")
        picture.set_axis_off()
    figure.suptitle(str(run["case_id"].item() if "case_id" in run.coords else run.attrs.get("case_id", "")), fontsize=8)
    return figure


def _curves(ax, run: xr.Dataset) -> None:
    if np.isfinite(values(run, "force_cutting")).any():
        draw_forces(ax, run)
        ax.axhline(0, color="0.4", lw=0.6)
    elif np.isfinite(values(run, "stress_axial")).any():
        for name, text in (("stress_axial", "measurement regions"), ("stress_grip", "grips")):
            line(ax, run, "strain_axial", name, color=QUANTITY[name], label=text)
        name_axes(ax, "strain_axial", "axial stress [MPa]")
    else:
        nothing(ax, "no forces")
        return
    ax.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=2, borderaxespad=0)


def _energies(ax, run: xr.Dataset) -> None:
    along = [name for name in ("tool_travel", "strain_axial", "time") if np.isfinite(values(run, name)).any()]
    if not along or not np.isfinite(values(run, "work_tool")).any():
        nothing(ax, "no energies")
        return
    handles = draw_energies(ax, run, along[0])
    ax.legend(handles.values(), handles.keys(), loc="upper left", bbox_to_anchor=(1.0, 1.0))


def _points(ax, run: xr.Dataset, case) -> None:
    last = last_snapshot(run, "point_x")
    points = draw_points(ax, run, last, 2e-6 * case.material.stress_yield)
    corners = parallelograms(run, last)[0].reshape(-1, 2)
    low, high = corners.min(axis=0), corners.max(axis=0)
    margin = 0.5e3 * case.cut_depth
    high = [high[0] + 2 * margin, max(high[1], 4 * margin) + margin]
    frame(ax, (low[0] - margin, high[0]), (low[1] - margin, high[1]))
    tips = np.atleast_1d(values(run, "tool_tip_snapshot"))
    if last < tips.size:
        draw_tool(ax, case.tool, float(tips[last]), 0.0, high[0] - low[0] + margin)
    bar = ax.figure.colorbar(points, cax=ax.inset_axes((1.02, 0.05, 0.02, 0.9)), extend="max")
    bar.set_label(label("point_stress"))


def _discs(ax, run: xr.Dataset, case) -> None:
    last = last_snapshot(run, "disc_x")
    draw_discs(ax, run, last, width=0.12)
    (left, right), (bottom, top) = extent(run, last)
    width, height = case.packing.width * 1e3, case.packing.height * 1e3
    margin = 0.03 * (top - bottom)
    if hasattr(case, "tool"):
        tips = np.atleast_1d(values(run, "tool_tip_snapshot"))
        tip = float(tips[last]) if last < tips.size else math.nan
        draw_tool(ax, case.tool, tip, height - case.cut_depth * 1e3, 2 * (width + height), filled=False)
    counts = draw_cracks(ax, run)
    frame(ax, (left - margin, right + margin), (bottom - margin, top + margin))
    ax.legend(handles=crack_legend(*counts), loc="center left", bbox_to_anchor=(1.02, 0.5))
