"""Nairn (2015), Fig. 16: mode of failure of the cohesive zone."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import cases, nothing, page, styled, values
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import BLACK
from orthocut.figures.sweep import touches
from orthocut.io.collect import case_of
from orthocut.theory.forces import thrust_ratio

CAPTION = (
    "Fraction of mode I in the energy of failure over the ratio of thrust to cutting force of a sliding chip, after "
    "Nairn (2015), Fig. 16. Open symbols: the tool touches the crack tip; filled: a gap separates them. "
    "Crosses on the axis: failed runs."
)
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One symbol a run."""
    figure = page(2.6)
    ax = figure.subplots()
    ax.set_xlabel(r"$Z = \tan(\arctan\mu - \alpha)$ [-]")
    ax.set_ylabel("fraction of mode I $J_I/J_c$ [%]")
    runs = cases(dataset, "mode_one_fraction", kind="mpm_cutting")
    tools = [case_of(run).tool for run in failed(dataset, "mpm_cutting")]
    mark(ax, [thrust_ratio(tool.rake_angle, tool.friction) for tool in tools])
    if not runs:
        nothing(ax)
        return figure

    for run in runs:
        tool = case_of(run).tool
        ratio, fraction = thrust_ratio(tool.rake_angle, tool.friction), float(values(run, "mode_one_fraction"))
        ax.plot(ratio, fraction, "o", color=BLACK, mfc="white" if touches(run) else BLACK)
    ax.set_ylim(0, 105)
    handles = [
        Line2D([], [], color=BLACK, marker="o", mfc=face, ls="", label=text)
        for face, text in (("white", "touching"), (BLACK, "bending"))
    ]
    figure.legend(handles=handles, loc="outside upper center", ncols=2)
    return figure
