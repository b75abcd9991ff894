"""Nairn (2015), Fig. 2: deformed material points of a curling chip for each order of the position update."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, nothing, page, styled, values
from orthocut.figures.scene import draw_points, draw_tool, frame, last_snapshot, parallelograms
from orthocut.figures.snapshots import with_points
from orthocut.io.collect import case_of

CAPTION = (
    "Material points of a chip, drawn as the parallelograms into which their deformation gradients turn them, after "
    "Nairn (2015), Fig. 2: with PIC transfers, and position updates of zeroth, first and second order, eqs (9), (10). "
    "Points that move with the velocities which deform them fill the chip without gaps and overlaps; in the paper, "
    "those of second order alone do."
)
AROUND, BELOW = 2.0, 1.0
"""Least range of the picture around the tool tip, and below the cut, in depths of cut."""
FLOWN = 0.005
"""Share of the points of a chip that may lie beyond the picture on each side, where an update tears the chip apart."""


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel an order, the last snapshot of each."""
    runs = sorted(with_points(dataset), key=_order)
    if not runs:
        figure = page(2.0)
        nothing(figure.subplots())
        return figure
    boxes = np.array([_box(run) for run in runs])
    low, high = boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)
    width = PAGE if len(runs) > 1 else 0.5 * PAGE
    aspect = (high[1] - low[1]) / (high[0] - low[0])
    figure = page(aspect * width / len(runs) + 0.5, width)
    panels = figure.subplots(1, len(runs), sharex=True, sharey=True, squeeze=False)[0]
    for ax, run in zip(panels, runs, strict=True):
        _panel(ax, run)
        frame(ax, (low[0], high[0]), (low[1], high[1]))
        order = _order(run)
        ax.set_title(f"order {order}", loc="left")
        ax.label_outer()
    return figure


def _order(run: xr.Dataset) -> int:
    """Order of the position update."""
    return case_of(run).numerics.position_order


def _box(run: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Lower left and upper right corner of the chip and what is near the tool [mm]."""
    last = last_snapshot(run, "point_x")
    depth = 1e3 * case_of(run).cut_depth
    tip = float(np.atleast_1d(values(run, "tool_tip_snapshot"))[last])
    corners = parallelograms(run, last)[0].reshape(-1, 2)
    lifted = corners[corners[:, 1] > 1.05 * depth]
    low, high = np.array([tip - AROUND * depth, -BELOW * depth]), np.array([tip + AROUND * depth, 2 * depth])
    if len(lifted):
        low[0] = min(low[0], np.quantile(lifted[:, 0], FLOWN) - 0.3 * depth)
        high = np.maximum(high, np.quantile(lifted, 1 - FLOWN, axis=0) + 0.3 * depth)
    return low, high


def _panel(ax: Axes, run: xr.Dataset) -> None:
    last = last_snapshot(run, "point_x")
    case = case_of(run)
    points = draw_points(ax, run, last, 4e-6 * case.material.stress_yield)
    points.set(edgecolors="0.2", linewidths=0.2, antialiased=True)
    tip = float(np.atleast_1d(values(run, "tool_tip_snapshot"))[last])
    draw_tool(ax, case.tool, tip, 0.0, 40e3 * case.cut_depth)
