"""Yang et al. (2018), Fig. 10: blocks with grooves, rectangular and trapezoid."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from orthocut.figures.canvas import PAGE, cases, nothing, page, styled
from orthocut.figures.palette import ORANGE
from orthocut.figures.scene import draw_discs, frame
from orthocut.io.collect import case_of
from orthocut.params.dem import DemCutting, Grooves

CAPTION = (
    "Blocks with grooves before the cut, after Yang et al. (2018), Fig. 10, one for each shape: discs whose centres "
    "lie inside the outlines are taken away. The paper simulated rectangles and holds that the trapezoids that a laser "
    "leaves explain its deviation from experiments. It does not say whether 0.2 mm is the clear distance or the pitch."
)
COLUMNS = 3


def outlines(case: DemCutting) -> list[np.ndarray]:
    """Corners of the grooves [mm], shape (4, 2) each, from the free side on."""
    top, narrow = case.packing.height, 0.5 * case.grooves.width * (1 - case.grooves.bottom_ratio)
    foot = top - case.cut_depth
    return [
        1e3 * np.array([(left, top), (left + narrow, foot), (right - narrow, foot), (right, top)])
        for left, right in case.grooves.edges(case.packing.width)
    ]


def shape_words(grooves: Grooves) -> str:
    """Shape and distance of grooves in words."""
    shape = "rectangles" if grooves.bottom_ratio == 1 else f"foot {grooves.bottom_ratio:g} of the width"
    return f"{shape}, {1e3 * grooves.distance:g} mm apart"


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel for each shape and depth of cut."""
    shown: dict[tuple, xr.Dataset] = {}
    for run in cases(dataset, "disc_x", kind="dem_cutting"):
        case = case_of(run)
        if case.grooves is not None:
            grooves = case.grooves
            key = (case.cut_depth, -grooves.bottom_ratio, -grooves.distance, grooves.width)
            shown.setdefault(key, run)
    rows = max(math.ceil(len(shown) / COLUMNS), 1)
    figure = page(1.55 * rows + 0.1, PAGE)
    panels = list(figure.subplots(rows, COLUMNS, squeeze=False).flat)
    deepest = max((key[0] for key in shown), default=0.0)
    for ax, (_, run) in zip(panels, sorted(shown.items()), strict=False):
        _panel(ax, run, 1e3 * deepest)
    for ax in panels[len(shown) :] if shown else []:
        ax.set_axis_off()
    if not shown:
        for ax in figure.axes:
            nothing(ax)
    return figure


def _panel(ax, run: xr.Dataset, deepest: float) -> None:
    case = case_of(run)
    width, height, depth = (1e3 * size for size in (case.packing.width, case.packing.height, case.cut_depth))
    draw_discs(ax, run, 0, width=0.2)
    for corners in outlines(case):
        ax.add_patch(Polygon(corners, closed=True, fc="none", ec=ORANGE, lw=1.0, zorder=3))
    frame(ax, (-0.02 * width, 1.02 * width), (height - 2.0 * deepest, height + 0.2 * deepest))
    ax.set_title(f"$h$ = {depth:.3g} mm\n{shape_words(case.grooves)}", loc="left", fontsize=7)
