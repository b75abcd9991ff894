"""Yang et al. (2018), Table 2: properties of the synthetic glass beside those of glass and of the paper's model."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import PAGE, page, styled
from orthocut.figures.confidence import interval
from orthocut.figures.palette import BLACK, BLUE, ORANGE
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_paper import TABLE_2, Property
from orthocut.figures.yang2018_runs import GlassRun, material_words, runs_of

CAPTION = (
    "Properties of the synthetic glass from tests on random packings (dots, one a packing; bars: mean and its 95 % "
    "confidence interval by Student's t), of the paper's model (crosses) and of soda-lime glass (lines), after "
    "Yang et al. (2018), Table 2. Specimens differ in the size of their discs and in the friction of the platens."
)
DIMS = ()
COLOURS = {"Table 1 as printed": ORANGE, "calibrated": BLUE}
Series = dict[tuple[str, str], list[GlassRun]]


def variant(run: GlassRun) -> str:
    """Size of the discs and friction of the platens in words."""
    friction = getattr(run.case, "friction_platen", 0.0)
    words = f"R from {1e6 * run.case.packing.radius_min:.3g} um"
    return f"{words}, platen friction {friction:g}" if friction else words


def measured(dataset: xr.Dataset, row: Property) -> Series:
    """Tests of one property, by material and variant."""
    found: Series = {}
    for run in runs_of(dataset, row.kind, row.variable):
        found.setdefault((material_words(run), variant(run)), []).append(run)
    return dict(sorted(found.items(), key=lambda pair: (list(COLOURS).index(pair[0][0]), pair[0][1])))


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel a property."""
    figure = page(2.9, PAGE)
    for ax, row in zip(figure.subplots(1, len(TABLE_2)), TABLE_2, strict=True):
        found = measured(dataset, row)
        ax.axhline(row.glass, color=BLACK, lw=0.8)
        ax.plot(-1, row.model, "x", color=BLACK)
        for column, ((material, _), runs) in enumerate(found.items()):
            values = [run[row.variable] for run in runs]
            mean = interval(values)
            ax.plot([column] * len(values), values, "o", color=COLOURS[material], ms=3, alpha=0.6, mew=0)
            bar = mean.half if np.isfinite(mean.half) else None
            ax.errorbar(column + 0.25, mean.mean, yerr=bar, fmt="_", color=COLOURS[material], capsize=2)
        labels = [variant(runs[0]).replace(", ", "\n").replace("um", "µm") for runs in found.values()]
        ax.set_xticks(range(-1, len(found)), ["paper", *labels], rotation=90, fontsize=6)
        ax.set_xlim(-1.6, len(found) - 0.2)
        ax.set_ylim(bottom=0)
        ax.set_ylabel(f"{row.words} ${row.symbol}$ [{row.unit}]")
        ax.grid(axis="x", visible=False)
    handles = [Line2D([], [], color=colour, marker="o", ms=3, ls="", label=name) for name, colour in COLOURS.items()]
    handles += [Line2D([], [], color=BLACK, marker="x", ls="", label="Yang et al.")]
    handles += [Line2D([], [], color=BLACK, lw=0.8, label="soda-lime glass")]
    figure.legend(handles=handles, loc="outside upper center", ncols=4)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """One row a property and series of tests."""
    header = ["property", "unit", "material", "specimen", "packings", "mean", "95 % half-width", "standard deviation"]
    header += ["paper: glass", "paper: model", "over the glass [-]", "over the paper's model [-]"]
    rows = []
    for row in TABLE_2:
        found = measured(dataset, row) or {("none", "no finished run"): []}
        for (material, words), runs in found.items():
            mean = interval([run[row.variable] for run in runs])
            known = [mean.count, mean.mean, mean.half, mean.spread]
            ratios = [mean.mean / row.glass, mean.mean / row.model]
            rows.append([row.words, row.unit, material, words, *known, row.glass, row.model, *ratios])
    return Table("Properties of the synthetic glass", header, rows)
