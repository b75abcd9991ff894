"""Yang et al. (2018), Figs 17 and 18: simulated forces beside measured ones, raw as in the paper and per width."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.confidence import interval
from orthocut.figures.palette import BLACK, BLUE, SKY
from orthocut.figures.yang2018_paper import EXPERIMENT, FORCES, NAMES, SIMULATION, WIDTHS, Cut, mean
from orthocut.figures.yang2018_runs import GlassRun, conditions, cuts_of, forces

CAPTION = (
    "Mean forces of the experiments, of the paper's simulations and of ours, after Yang et al. (2018), Figs 17 and 18. "
    "Left: raw newtons, as the paper compares them; but the cut is 25.4 mm wide in the experiments and 1 mm in the "
    "simulations. Right: for a millimetre of width, on a logarithmic axis; there the simulated forces of the paper are "
    "10 to 24 times those of its experiments. Bars: 95 % confidence intervals by Student's t."
)
DIMS = ()
SOURCES = (("experiment", BLACK, "D"), ("paper's simulation", SKY, "s"), ("this work", BLUE, "o"))


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Raw and per-width comparison of the surfaces that the dataset holds."""
    found = conditions(cuts_of(dataset))
    figure = page(2.9, PAGE)
    raw, width = figure.subplots(1, 2)
    groups = [(cut, name) for cut in found if cut in SIMULATION for name in FORCES]
    if not groups:
        nothing(raw)
        nothing(width)
        return figure

    raw_data = [_series(groups, found, 1.0, 1.0), _series(groups, found, WIDTHS["experiment"], 1.0)]
    for ax, series in zip((raw, width), raw_data, strict=True):
        _panel(ax, groups, series)
    raw.set_ylabel("mean force, raw [N]")
    raw.set_ylim(bottom=0)
    width.set_ylabel("mean force [N/mm]")
    width.set_yscale("log")
    for ax, text in ((raw, "experiment 25.4 mm wide, simulation 1 mm"), (width, "for a millimetre of width")):
        ax.set_title(text, loc="left")
    handles, labels = raw.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3)
    return figure


Series = list[list[tuple[float, float]]]


def _series(groups: Sequence[tuple[Cut, str]], found: dict[Cut, list[GlassRun]], real: float, ours: float) -> Series:
    """Mean and half-width of each group for experiment, paper's simulation and ours, over some widths [mm]."""
    rows: Series = [[], [], []]
    for cut, name in groups:
        values = (EXPERIMENT[cut][name], SIMULATION[cut][name], forces(found[cut], name))
        for row, data, width in zip(rows, values, (real, ours, ours), strict=True):
            known = interval(data)
            row.append((known.mean / width, known.half / width))
    return rows


def _panel(ax: Axes, groups: Sequence[tuple[Cut, str]], series: Series) -> None:
    for shift, (name, colour, marker), row in zip((-0.22, 0, 0.22), SOURCES, series, strict=True):
        places = np.arange(len(groups)) + shift
        means = [mean for mean, _ in row]
        bars = [half if math.isfinite(half) else 0.0 for _, half in row]
        ax.errorbar(places, means, yerr=bars, fmt=marker, color=colour, ms=4, capsize=2, elinewidth=0.8, label=name)
    ax.set_xticks(range(len(groups)), [_label(cut, name, groups) for cut, name in groups])
    ax.set_xlim(-0.5, len(groups) - 0.5)
    ax.set_xlabel("depth of cut, force")
    ax.grid(axis="x", visible=False)


def _label(cut: Cut, name: str, groups: Sequence[tuple[Cut, str]]) -> str:
    """Depth of cut and force; the surface too where both are there."""
    both = len({grooved for (_, grooved), _ in groups}) > 1
    surface = f"{'grooved' if cut[1] else 'regular'}\n" if both else ""
    return f"{surface}{cut[0]:g} mm\n{NAMES[name]}"


def factor(cut: Cut, name: str) -> float:
    """Simulated over measured force of the paper for the same width [-]."""
    return mean(SIMULATION[cut][name]) / (mean(EXPERIMENT[cut][name]) / WIDTHS["experiment"])
