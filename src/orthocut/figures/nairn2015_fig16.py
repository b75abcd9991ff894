"""Nairn (2015), Fig. 16: mode of failure of the cohesive zone."""

from __future__ import annotations

import math

import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import cases, nothing, page, shown, styled, values
from orthocut.figures.discretisation import DIFFERS, finest
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.sweep import touches
from orthocut.figures.symbols import columns_of_handles, draw_discretisation, resolution_handles, state_handles
from orthocut.io.collect import case_of
from orthocut.theory.forces import thrust_ratio

CAPTION = (
    "Fraction of mode I in the energy of failure over the ratio of thrust to cutting force of a sliding chip, after "
    "Nairn (2015), Fig. 16: all perfectly plastic runs of Figs 8 and 11. Open symbols: the tool touches the crack tip; "
    "filled: the chip bends. Circles: rake angle varied, without friction; diamonds: with friction. The paper has more "
    "than 90 % (line) wherever the chip bends, and touching runs that fall with the ratio. Crosses on the axis: failed "
    "runs. Each symbol is a mean over the interface that failed in the window. Thin lines that end in a tick: from the "
    "finest resolution to zero particle size, on a straight line over particle size; ringed: the coarser run is of the "
    "other regime."
)
DIMS = ()
PAPER = 90.0
"""Least fraction of mode I of bending runs in the paper [%]."""


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One symbol a run, one colour a cohesive stress."""
    figure = page(2.8)
    ax = figure.subplots()
    ax.set_xlabel(r"$Z = \tan(\arctan\mu - \alpha)$ [-]")
    ax.set_ylabel("fraction of mode I $J_I/J_c$ [%]")
    dataset = finest(dataset, "mode_one_fraction")
    runs = cases(dataset, "mode_one_fraction", kind="mpm_cutting")
    tools = [case_of(run).tool for run in failed(dataset, "mpm_cutting")]
    mark(ax, [thrust_ratio(tool.rake_angle, tool.friction) for tool in tools])
    if not runs:
        nothing(ax)
        return figure

    strengths = sorted({case_of(run).interface.strength for run in runs}, reverse=True)
    for run in runs:
        tool = case_of(run).tool
        colour = (SERIES * 9)[strengths.index(case_of(run).interface.strength)]
        ratio, fraction = thrust_ratio(tool.rake_angle, tool.friction), float(values(run, "mode_one_fraction"))
        ax.plot(ratio, fraction, "D" if tool.friction else "o", color=colour, mfc="white" if touches(run) else colour)
        limit = float(shown("mode_one_fraction", run["mode_one_fraction_limit"])) if DIFFERS in run else math.nan
        draw_discretisation(ax, run, ratio, fraction, limit, colour)
    ax.axhline(PAPER, color="0.6", lw=0.7, zorder=1)
    lowest = min(float(values(run, "mode_one_fraction")) for run in runs)
    ax.set_ylim(50 if lowest > 55 else 0, 105)
    kinds = [
        Line2D([], [], color="0.25", marker=marker, ls="", label=text)
        for marker, text in (("o", "without friction"), ("D", "with friction"))
    ]
    coarser = resolution_handles(dataset)
    columns = [state_handles("touching", "bending") + coarser[:1], kinds + coarser[1:]]
    if len(strengths) > 1:
        columns.append(
            [
                Line2D([], [], color=colour, marker="s", ls="", label=rf"$\sigma_c$ = {strength * 1e-6:g} MPa")
                for colour, strength in zip(SERIES * 9, strengths, strict=False)
            ]
        )
    figure.legend(handles=columns_of_handles(*columns), loc="outside upper center", ncols=len(columns))
    return figure
