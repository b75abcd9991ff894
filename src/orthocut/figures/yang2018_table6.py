"""Yang et al. (2018), Table 6: measured forces beside simulated ones, raw and for a millimetre of width."""

from __future__ import annotations

import math
from itertools import product

import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import page, styled
from orthocut.figures.confidence import interval
from orthocut.figures.palette import BLACK, QUANTITY
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_comparison import factor
from orthocut.figures.yang2018_paper import EXPERIMENT, FORCES, NAMES, SIMULATION, WIDTHS, mean
from orthocut.figures.yang2018_runs import conditions, cuts_of, forces

CAPTION = (
    "Simulated over measured force for the same width of cut: the paper's simulations (Table 4 over Table 6 of "
    "Yang et al. 2018, open) and ours (filled, with 95 % confidence intervals of our means). At 1 they would agree. "
    "The paper compares a simulated cut of 1 mm with a real one of 25.4 mm and so sees a ratio near 1 of the raw "
    "forces, the dotted line: the agreement that it reports hides a factor of 10 to 24."
)
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One column for each cut and force."""
    found = conditions(cuts_of(dataset))
    groups = list(product(sorted(EXPERIMENT), FORCES))
    figure = page(2.9, 5.0)
    ax = figure.subplots()
    for column, (cut, name) in enumerate(groups):
        colour = QUANTITY[name]
        ax.plot(column - 0.12, factor(cut, name), "o", color=colour, mfc="white")
        known = interval(forces(found.get(cut, []), name))
        measured = mean(EXPERIMENT[cut][name]) / WIDTHS["experiment"]
        bar = known.half / measured if math.isfinite(known.half) else None
        ax.errorbar(column + 0.12, known.mean / measured, yerr=bar, fmt="o", color=colour, capsize=2, elinewidth=0.8)
    ax.axhline(1.0, color=BLACK, lw=0.8)
    ax.axhline(WIDTHS["experiment"], color=BLACK, lw=0.8, ls=":")
    ax.set_yscale("log")
    ax.set_ylim(bottom=0.7)
    ax.set_ylabel("simulated over measured force [-]")
    labels = [f"{cut[0]:g} mm\n{'grooved' if cut[1] else 'regular'}\n{NAMES[name]}" for cut, name in groups]
    ax.set_xticks(range(len(groups)), labels, fontsize=6)
    ax.set_xlabel("depth of cut, surface, force")
    ax.grid(axis="x", visible=False)
    for place, text in ((1.0, "agreement"), (WIDTHS["experiment"], "agreement of\nraw newtons")):
        ax.text(1.01, place, text, transform=ax.get_yaxis_transform(), va="center", fontsize=6)
    handles = [
        Line2D([], [], color="0.4", marker="o", mfc=face, ls="", label=text)
        for face, text in (("white", "Yang et al."), ("0.4", "this work"))
    ]
    ax.legend(handles=handles, loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Measured forces and both simulations: raw newtons, for a millimetre of width, and their ratios."""
    header = ["depth of cut [mm]", "surface", "force", "experiment: replicates [N]", "experiment: mean [N]"]
    header += ["paper's simulation [N]", "paper's deviation, raw [%]", "ours, 1 mm wide [N]", "our deviation, raw [%]"]
    header += ["experiment [N/mm]", "paper's simulation [N/mm]", "ours [N/mm]", "95 % half-width [N/mm]"]
    header += ["paper's over experiment [-]", "ours over experiment [-]"]
    found, rows = conditions(cuts_of(dataset)), []
    for cut, name in product(sorted(EXPERIMENT), FORCES):
        real, paper = mean(EXPERIMENT[cut][name]), mean(SIMULATION[cut][name])
        known = interval(forces(found.get(cut, []), name))
        each = real / WIDTHS["experiment"]
        listed = " ".join(f"{value:g}" for value in EXPERIMENT[cut][name])
        rows.append(
            [
                *(f"{cut[0]:g}", "grooved" if cut[1] else "regular", NAMES[name], listed, real, paper),
                *(100 * (paper / real - 1), known.mean, 100 * (known.mean / real - 1)),
                *(each, paper, known.mean, known.half, paper / each, known.mean / each),
            ]
        )
    return Table("Measured and simulated forces, raw and for a millimetre of width", header, rows)
