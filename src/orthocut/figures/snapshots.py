"""Snapshots of one cut as panels: material points as deformed parallelograms, shaded by equivalent stress."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, cases, label, nothing, page, values
from orthocut.figures.scene import draw_points, draw_tool, frame, last_snapshot, parallelograms
from orthocut.io.collect import case_of


def with_points(dataset: xr.Dataset) -> list[xr.Dataset]:
    """Runs that hold snapshots of material points."""
    return [run for run in cases(dataset, "point_x", kind="mpm_cutting") if last_snapshot(run, "point_x") >= 0]


def draw_snapshots(dataset: xr.Dataset, count: int, columns: int) -> Figure:
    """Up to some snapshots of the first run, evenly spaced, the last one included.

    Parameters
    ----------
    dataset : xarray.Dataset
        Collected runs.
    count, columns : int
        Most panels, and how many of them stand beside each other.
    """
    runs = with_points(dataset)
    if not runs:
        figure = page(2.0)
        nothing(figure.subplots())
        return figure

    run, case = runs[0], case_of(runs[0])
    last = last_snapshot(run, "point_x")
    chosen = np.unique(np.linspace(0, last, min(count, last + 1)).round().astype(int))
    corners = np.concatenate([parallelograms(run, index)[0].reshape(-1, 2) for index in chosen])
    depth = case.cut_depth * 1e3
    low, high = corners.min(axis=0), corners.max(axis=0)
    low, high = low - 0.3 * depth, [high[0] + 1.5 * depth, max(high[1], 2 * depth) + 0.5 * depth]
    columns = min(columns, len(chosen))
    rows = math.ceil(len(chosen) / columns)
    aspect = (high[1] - low[1]) / (high[0] - low[0])
    figure = page(rows * (PAGE / columns * aspect + 0.25) + 0.8, PAGE)
    panels = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    tips, times = np.atleast_1d(values(run, "tool_tip_snapshot")), np.atleast_1d(values(run, "time_snapshot"))
    for index, ax in zip(chosen, panels.flat, strict=False):
        points = draw_points(ax, run, index, 2e-6 * case.material.stress_yield)
        frame(ax, (low[0], high[0]), (low[1], high[1]))
        if index < tips.size:
            draw_tool(ax, case.tool, float(tips[index]), 0.0, high[0] - low[0])
        ax.set_title(f"$t$ = {times[index]:.2f} ms" if index < times.size else "", loc="left")
        ax.label_outer()
    for ax in panels.flat[len(chosen) :]:
        ax.set_axis_off()
    bar = figure.colorbar(points, ax=panels, location="bottom", shrink=0.4, aspect=30, pad=0.02, extend="max")
    bar.set_label(label("point_stress"))
    bar.outline.set_linewidth(0.4)
    return figure
