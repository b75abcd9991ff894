"""Nairn (2015), Fig. 3A: cutting force over the depth of the base below the cut."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import nothing, page, styled
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.symbols import draw_force, state_handles
from orthocut.figures.varied import series_along
from orthocut.io.collect import case_of

CAPTION = (
    "Cutting force over the depth of material between the cut and the clamp, in depths of cut, after Nairn (2015), "
    "Fig. 3A. The paper finds the force constant from 3 on (vertical line) and takes 3. Bars: standard error of the "
    "mean; pale bars: half of the drift over the window to either side. Open symbols: the tool touches the crack tip; "
    "filled: the chip bends. Crosses on the axis: failed runs."
)
DIMS = ()
PAPER = 3.0
ROOM = 1.2
"""Top of the axis over the largest force: forces that hardly differ would else lie on its edge."""


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour for each set of runs that differ in nothing else."""
    figure = page(2.6)
    ax = figure.subplots()
    ax.set_xlabel("depth of the base over depth of cut $d$ [-]")
    ax.set_ylabel("force $F_c/(bG_c)$ [-]")
    mark(ax, [case_of(run).workpiece.base_ratio for run in failed(dataset, "mpm_cutting")])
    series = series_along(dataset, "base_ratio", "force_cutting_mean", least=1)
    if not series:
        nothing(ax)
        return figure
    for colour, (name, runs) in zip(SERIES * 9, series, strict=False):
        for run in runs:
            draw_force(ax, run, case_of(run).workpiece.base_ratio, colour)
        if len(series) > 1:
            ax.plot([], [], "o", color=colour, label=name)
    ax.axvline(PAPER, color="0.7", lw=0.6, zorder=1)
    ax.set_xlim(left=0)
    ax.set_ylim(0, ROOM * ax.get_ylim()[1])
    handles = ax.get_legend_handles_labels()[0]
    figure.legend(handles=handles + state_handles(), loc="outside upper center", ncols=2)
    return figure
