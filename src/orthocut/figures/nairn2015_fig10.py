"""Nairn (2015), Fig. 10: rubbing force over depth of cut."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import label, nothing, page, styled
from orthocut.figures.discretisation import finest
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.rubbing import FIT_ABOVE, rubbing_line
from orthocut.figures.sweep import cut_depth, dimensionless_depth, group_name, grouped, over_toughness
from orthocut.figures.symbols import (
    GREY,
    columns_of_handles,
    draw_discretisation,
    draw_run,
    resolution_handles,
    state_handles,
)
from orthocut.io.collect import case_of

CAPTION = (
    "Normal force of the finished surface on the tool (rubbing) over depth of cut, both dimensionless, after Nairn "
    "(2015), Fig. 10. Solid: straight lines through the runs that bend beyond a dimensionless depth of 0.28 (vertical "
    "line), as in the paper, where rubbing is low while the tool touches, rises just before the transition, and then "
    "grows with depth of cut and rake angle. Open symbols: the tool touches the crack tip; filled: the chip bends. "
    "Bars: standard error of the mean, where runs tell it. Thin lines that end in a tick: to zero particle size, on a "
    "straight line through the finest run and the coarser one of the same cut. Ringed: the coarser run is of the other "
    "regime. Crosses on the axis: failed runs."
)
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    figure = page(3.2, 4.6)
    ax = figure.subplots()
    ax.set_xlabel(label("depth_dimensionless") + " [-]")
    ax.set_ylabel("rubbing force $F_n^b/(bG_c)$ [-]")
    dataset = finest(dataset, "force_rubbing_mean")
    groups = grouped(dataset, "force_rubbing_mean")
    mark(ax, [dimensionless_depth(run) for run in failed(dataset, "mpm_cutting")])
    if not groups:
        nothing(ax)
        return figure

    marks = []
    for colour, (group, runs) in zip(SERIES * 9, groups.items(), strict=False):
        for run in runs:
            place, force = dimensionless_depth(run), over_toughness(run, "force_rubbing_mean")
            draw_run(ax, run, place, force, over_toughness(run, "force_rubbing_error"), colour)
            draw_discretisation(ax, run, place, force, over_toughness(run, "force_rubbing_mean_limit"), colour)
        line = rubbing_line(runs, FIT_ABOVE)
        if line is not None:
            scale = dimensionless_depth(runs[-1]) / cut_depth(runs[-1])
            ends = np.array([FIT_ABOVE / scale, cut_depth(runs[-1])])
            toughness = case_of(runs[0]).interface.toughness
            ax.plot(ends * scale, np.polyval(line, ends) / toughness, color=colour, lw=0.9)
        marks.append(Line2D([], [], color=colour, marker="o", ls="", label=group_name(group, groups)))
    ax.axhline(0, color="0.4", lw=0.6)
    ax.axvline(FIT_ABOVE, color="0.7", lw=0.6, zorder=1)
    ax.set_xlim(left=0)
    rest = [*state_handles(), Line2D([], [], color=GREY, label="straight line"), *resolution_handles(dataset)]
    columns = [*[marks[start : start + len(rest)] for start in range(0, len(marks), len(rest))], rest]
    handles = columns_of_handles(*columns)
    figure.legend(handles=handles, loc="outside upper center", ncols=len(columns), columnspacing=1.2)
    return figure
