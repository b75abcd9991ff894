"""Yang et al. (2018), Table 4: mean forces of four cuts, the paper's beside ours."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import PAGE, page, styled
from orthocut.figures.confidence import interval, needed
from orthocut.figures.palette import BLACK, QUANTITY
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_paper import EXPERIMENT, FORCES, NAMES, SIMULATION, WIDTHS, mean
from orthocut.figures.yang2018_runs import condense, conditions, cuts_of, early, forces

__all__ = ["CAPTION", "DIMS", "condense", "draw", "tabulate"]

CAPTION = (
    "Mean cutting and thrust force of four cuts for a millimetre of width: replicates (dots), their means and the 95 % "
    "confidence intervals of these by Student's t (bars), and the replicates of Yang et al. (2018), Table 4 (crosses), "
    "with their means (lines)."
)
DIMS = ("sample",)
ROOM = 1.3
"""Top of an axis over the largest replicate: intervals of few packings may be longer."""
GOAL = 0.1
"""Half-width of the confidence interval over the mean that is aimed at."""


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel a force, one column a cut."""
    found = conditions(cuts_of(dataset))
    cuts = sorted({*SIMULATION, *found})
    figure = page(2.7, PAGE)
    panels = figure.subplots(1, 2, sharex=True)
    for ax, name, text in zip(panels, FORCES, ("mean cutting force", "mean thrust force"), strict=True):
        for column, cut in enumerate(cuts):
            paper, ours = SIMULATION.get(cut, {}).get(name, ()), forces(found.get(cut, []), name)
            ax.plot([column + 0.15] * len(paper), paper, "x", color=BLACK)
            ax.plot([column - 0.25] * len(ours), ours, "o", color=QUANTITY[name], ms=3, alpha=0.6, mew=0)
            if ours:
                known = interval(ours)
                bar = known.half if math.isfinite(known.half) else None
                ax.errorbar(column - 0.1, known.mean, yerr=bar, fmt="_", color=QUANTITY[name], capsize=2)
            if paper:
                ax.hlines(mean(paper), column, column + 0.3, color=BLACK)
        ax.set_xticks(
            range(len(cuts)), [f"{depth:g} mm\n{'grooved' if grooved else 'regular'}" for depth, grooved in cuts]
        )
        ax.set_xlabel("depth of cut, surface")
        ax.set_ylabel(f"{text} [N/mm]")
        drawn = [
            value
            for cut in cuts
            for value in (*SIMULATION.get(cut, {}).get(name, ()), *forces(found.get(cut, []), name))
        ]
        ax.set_ylim(min(0.0, *drawn), ROOM * max(drawn))
        ax.grid(axis="x", visible=False)
        handles = [
            Line2D([], [], color=QUANTITY[name], marker="o", ms=3, ls="", label="replicate"),
            Line2D([], [], color=QUANTITY[name], marker="_", label="mean"),
            Line2D([], [], color=BLACK, marker="x", ls="", label="Yang et al."),
        ]
        ax.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Replicates, their mean and its confidence interval, other averages, and what the paper has."""
    header = ["depth of cut [mm]", "surface", "force", "replicates [N/mm]", "number", "mean [N/mm]"]
    header += ["95 % half-width [N/mm]", "half-width over mean [%]", "replicates for 10 %"]
    header += ["standard deviation [N/mm]", "mean of first three quarters of travel [N/mm]", "95 % half-width [N/mm]"]
    header += ["mean in contact [N/mm]", "rms [N/mm]", "peak, mean of replicates [N/mm]"]
    header += ["in the air [% of travel]", "paper: replicates [N/mm]", "paper: mean [N/mm]"]
    header += ["mean over paper's mean [-]", "experiment, for 1 mm [N/mm]"]
    found, rows = conditions(cuts_of(dataset)), []
    for cut, name in product(sorted({*SIMULATION, *found}), FORCES):
        runs, paper = found.get(cut, []), SIMULATION.get(cut, {}).get(name, ())
        ours = forces(runs, name)
        known = interval(ours)
        reference = mean(paper) if paper else math.nan
        real = mean(EXPERIMENT[cut][name]) / WIDTHS["experiment"] if cut in EXPERIMENT else math.nan
        others = [_mean(forces(runs, name, what)) for what in ("contact", "rms", "peak")]
        listed = [" ".join(f"{value:.2f}" for value in data) for data in (ours, paper)]
        rows.append(
            [
                *(f"{cut[0]:g}", "grooved" if cut[1] else "regular", NAMES[name], listed[0]),
                *(known.count, known.mean, known.half, 100 * known.relative, needed(ours, GOAL), known.spread),
                *interval(early(runs, name))[:2],
                *(*others, _mean([run["air_share"] for run in runs]), listed[1], reference),
                *(known.mean / reference, real),
            ]
        )
    return Table("Mean forces of four cuts, for a millimetre of width", header, rows)


def _mean(values: list[float]) -> float:
    """Mean of what is a number; NaN if nothing is."""
    found = [value for value in values if math.isfinite(value)]
    return float(np.mean(found)) if found else math.nan
