"""Nairn (2015), Fig. 10: rubbing force over depth of cut."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import label, nothing, page, styled
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.sweep import dimensionless_depth, group_name, grouped, legend_columns, touches
from orthocut.io.collect import case_of

CAPTION = (
    "Normal force of the finished surface on the tool (rubbing) over depth of cut, both dimensionless, after Nairn "
    "(2015), Fig. 10. Open symbols: the tool touches the crack tip; filled: a gap separates them. "
    "Crosses on the axis: failed runs."
)
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    figure = page(2.7)
    ax = figure.subplots()
    ax.set_xlabel(label("depth_dimensionless") + " [-]")
    ax.set_ylabel("rubbing force $F_n^b/(bG_c)$ [-]")
    groups = grouped(dataset, "force_rubbing_mean")
    mark(ax, [dimensionless_depth(run) for run in failed(dataset, "mpm_cutting")])
    if not groups:
        nothing(ax)
        return figure

    for colour, (group, runs) in zip(SERIES * 9, groups.items(), strict=False):
        depths = [dimensionless_depth(run) for run in runs]
        forces = [float(run["force_rubbing_mean"]) / case_of(run).interface.toughness for run in runs]
        ax.plot(depths, forces, color=colour, lw=0.6)
        for run, depth, force in zip(runs, depths, forces, strict=True):
            ax.plot(depth, force, "o", color=colour, mfc="white" if touches(run) else colour)
        ax.plot([], [], "o", color=colour, label=group_name(group, groups))
    ax.axhline(0, color="0.4", lw=0.6)
    ax.set_xlim(left=0)
    figure.legend(loc="outside upper center", ncols=legend_columns(groups), columnspacing=1.2)
    return figure
