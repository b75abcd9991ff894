"""Symbols of runs: open where the tool touches the crack tip, filled where the chip bends, with their error bars."""

from __future__ import annotations

import math

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from orthocut.figures.discretisation import hangs_on_resolution, has_partners
from orthocut.figures.sweep import over_toughness, touches

GREY = "0.25"
LIMIT = {"lw": 0.6, "alpha": 0.7, "zorder": 2.5}
"""Line from a symbol to the value at zero particle size, and the tick at its end."""
RING = {"marker": "o", "ms": 6.5, "mfc": "none", "mew": 0.6, "ls": ""}
"""Ring around a symbol whose regime hangs on the resolution."""


def draw_run(ax: Axes, run: xr.Dataset, x: float, y: float, error: float, colour: str, marker: str = "o", **style):
    """One run with the standard error of its mean; without a bar where that is not known.

    Parameters
    ----------
    x, y, error : float
        Place of the symbol and half-length of its bar, in units of the axes.
    """
    bar = error if math.isfinite(error) else None
    face = "white" if touches(run) else colour
    style = {"capsize": 2, "elinewidth": 0.8, "zorder": 3} | style
    ax.errorbar(x, y, yerr=bar, fmt=marker, color=colour, mfc=face, **style)


def draw_force(ax: Axes, run: xr.Dataset, x: float, colour: str, marker: str = "o", **style) -> None:
    """Cutting force over toughness of a run; behind it, pale, half of its drift over the window to either side."""
    force = over_toughness(run)
    drift = 0.5 * abs(force * float(run["force_cutting_drift"])) if "force_cutting_drift" in run else math.nan
    if math.isfinite(drift):
        ax.vlines(x, force - drift, force + drift, color=colour, alpha=0.25, lw=3, zorder=2)
    draw_run(ax, run, x, force, over_toughness(run, "force_cutting_error"), colour, marker, **style)
    draw_discretisation(ax, run, x, force, over_toughness(run, "force_cutting_mean_limit"), colour)


def draw_discretisation(ax: Axes, run: xr.Dataset, x: float, y: float, limit: float, colour: str) -> None:
    """Thin line from a symbol to the value at zero particle size, or a ring where the regime hangs on the resolution.

    Parameters
    ----------
    run : xarray.Dataset
        A run out of what `orthocut.figures.discretisation.finest` gives.
    x, y, limit : float
        Place of the symbol and end of the line, in units of the axes; no line where the limit is NaN.
    """
    if math.isfinite(limit):
        ax.vlines(x, y, limit, color=colour, **LIMIT)
        ax.plot(x, limit, "_", color=colour, ms=7, mew=0.7, **LIMIT)
    if hangs_on_resolution(run):
        ax.plot(x, y, color=colour, zorder=4, **RING)


def draw_limit(ax: Axes, limit: float, error: float, colour: str) -> None:
    """Value at zero particle size and its standard error, and room for it left of the axis' zero."""
    style = {"fmt": "D", "ms": 3, "mfc": "white", "capsize": 3, "elinewidth": 0.8, "zorder": 4}
    ax.errorbar(0.0, limit, yerr=error, color=colour, **style)
    ax.set_xlim(left=-0.04 * ax.get_xlim()[1])


def state_handles(touching: str = "run, touching", bending: str = "run, bending") -> list[Line2D]:
    """Entries of a legend: open and filled symbols."""
    return [
        Line2D([], [], color=GREY, marker="o", mfc=face, ls="", label=text)
        for face, text in (("white", touching), (GREY, bending))
    ]


def resolution_handles(dataset: xr.Dataset) -> list[Line2D]:
    """Entries of a legend for what coarser runs tell of those that `finest` gives; none where there are none."""
    if not has_partners(dataset):
        return []
    line = Line2D([], [], color=GREY, marker="|", ms=5, mew=0.7, label="to zero particle size", **LIMIT)
    ring = Line2D([], [], color=GREY, label="other regime when coarser", **RING)
    return [line, ring]


def columns_of_handles(*columns: list[Line2D]) -> list[Line2D]:
    """Entries in the order in which a legend fills as many columns, one list a column."""
    rows = max(map(len, columns))
    blank = Line2D([], [], ls="", label=" ")
    return [entry for column in columns for entry in column + [blank] * (rows - len(column))]
