"""Yang et al. (2018), Fig. 9: the model of the cut before it starts."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import cases, nothing, page, styled, values
from orthocut.figures.palette import DISC_FACE, ORANGE
from orthocut.figures.scene import draw_discs, draw_tool, frame
from orthocut.io.collect import case_of

CAPTION = (
    "Model of the cut before it starts, to scale: fixed discs, the tool with its rake and clearance angles, and the "
    "depth of cut, after Yang et al. (2018), Fig. 9. The paper's block has 2085 discs."
)
FIXED = ORANGE


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """First cut of the dataset, at its first snapshot."""
    runs = cases(dataset, "disc_x", "disc_fixed", kind="dem_cutting")
    figure = page(3.6, 4.4)
    ax = figure.subplots()
    if not runs:
        nothing(ax)
        return figure

    run, case = runs[0], case_of(runs[0])
    width, height, depth = (1e3 * size for size in (case.packing.width, case.packing.height, case.cut_depth))
    fixed = run["disc_fixed"].values == 1
    draw_discs(ax, run, 0, face=np.where(fixed, FIXED, DISC_FACE), width=0.2)
    tip = float(np.atleast_1d(values(run, "tool_tip_snapshot"))[0])
    draw_tool(ax, case.tool, tip, height - depth, 2 * (width + height))
    frame(ax, (-0.03 * width, 1.45 * width), (-0.03 * height, 1.3 * height))
    ax.hlines([height, height - depth], 0, width, color="black", lw=0.8, ls="--", zorder=4)
    arrow = {"arrowstyle": "<->", "lw": 0.9, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", (0.7 * width, height), (0.7 * width, height - depth), arrowprops=arrow, zorder=4)
    box = {"fc": "white", "ec": "none", "alpha": 0.8, "pad": 1.0}
    place = (0.66 * width, height - 0.5 * depth)
    ax.text(*place, f"$h$ = {depth:.3g} mm", ha="right", va="center", fontsize=7, bbox=box, zorder=4)
    angles = (math.degrees(case.tool.rake_angle), math.degrees(case.tool.clearance_angle))
    words = f"rake angle {angles[0]:.3g}°\nclearance angle {angles[1]:.3g}°"
    ax.text(1.43 * width, height + 0.2 * height, words, ha="right", va="center", fontsize=7, color="white", zorder=4)
    count = int(np.isfinite(run["disc_radius"].values).sum())
    spots = [Line2D([], [], color=colour, marker="o", ls="", mec="0.4", mew=0.4) for colour in (DISC_FACE, FIXED)]
    ax.legend(
        spots,
        [f"free discs ({count - int(fixed.sum())})", f"fixed discs ({int(fixed.sum())})"],
        loc="lower left",
        bbox_to_anchor=(0, 1),
        ncols=2,
    )
    return figure
