"""Empty figures in the one style, axes named from the table of variables, and values in display units."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path

import matplotlib.style
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orthocut import variables

STYLE = Path(__file__).with_name("orthocut.mplstyle")
COLUMN, PAGE = 3.4, 7.0
"""Widths of a column and of a page [inch]."""

_SPELLING = {"[um]": "[µm]", "[deg]": "[°]"}


def styled(draw: Callable[..., Figure]) -> Callable[..., Figure]:
    """Draw in the one style, whatever the caller's settings are."""

    @functools.wraps(draw)
    def wrapped(*arguments, **options):
        with matplotlib.style.context(["default", STYLE]):
            return draw(*arguments, **options)

    return wrapped


def page(height: float, width: float = COLUMN) -> Figure:
    """Empty figure; sizes in inches."""
    return Figure(figsize=(width, height))


def label(name: str) -> str:
    """Axis label of a variable, with its unit."""
    text = variables.label(name)
    for plain, proper in _SPELLING.items():
        text = text.replace(plain, proper)
    return text


def name_axes(ax: Axes, x: str, y: str) -> None:
    """Label both axes; each name is a variable of the table, or the text itself."""
    for name, put in ((x, ax.set_xlabel), (y, ax.set_ylabel)):
        put(label(name) if name in variables.VARIABLES else name)


def shown(name: str, values) -> np.ndarray:
    """Values in the unit in which figures show them."""
    return np.asarray(values, float) * variables.VARIABLES[name].scale


def values(run: xr.Dataset, name: str) -> np.ndarray:
    """Variable of a dataset in display units; NaN where the dataset lacks it."""
    if name not in run.variables:
        return np.array(np.nan)
    return shown(name, run[name].values)


def cases(dataset: xr.Dataset, *needed: str, kind: str = "") -> list[xr.Dataset]:
    """Runs of a collected dataset that hold finite values of all variables named; a single run is a list of itself.

    Failed and missing runs drop out here, so that figures need not know of them, and runs of other kinds than `kind`.
    """
    runs = [dataset.isel(case=index) for index in range(dataset.sizes["case"])] if "case" in dataset.dims else [dataset]
    if kind:
        runs = [run for run in runs if (run["kind"].item() if "kind" in run.coords else run.attrs["kind"]) == kind]
    return [run for run in runs if all(np.isfinite(values(run, name)).any() for name in needed)]


def line(ax: Axes, run: xr.Dataset, x: str, y: str, sign: float = 1.0, **style):
    """One history over another, in display units."""
    return ax.plot(values(run, x), sign * values(run, y), **style)[0]


def nothing(ax: Axes, text: str = "no finished run") -> None:
    """Say in an empty panel that there is nothing to draw."""
    ax.set_xticks([])
    ax.set_yticks([])
    ax.text(0.5, 0.5, text, transform=ax.transAxes, ha="center", va="center", color="0.5")
