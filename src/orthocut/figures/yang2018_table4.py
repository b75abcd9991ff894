"""Yang et al. (2018), Table 4: mean forces of four cuts, the paper's beside ours."""

from __future__ import annotations

import math
from collections import defaultdict
from itertools import product

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import PAGE, cases, page, styled, values
from orthocut.figures.palette import BLACK, QUANTITY
from orthocut.figures.tables import Table
from orthocut.io.collect import case_of

CAPTION = (
    "Mean cutting and thrust force of four cuts for a millimetre of width: replicates (dots) and those of "
    "Yang et al. (2018), Table 4 (crosses), with their means (lines)."
)
DIMS = ()
PAPER = {
    (0.1, False): {"force_cutting": (14.15, 15.40, 15.38), "force_thrust": (10.29, 9.27, 10.38)},
    (0.1, True): {"force_cutting": (1.72, 2.82, 1.60), "force_thrust": (2.84, 3.13, 2.87)},
    (0.2, False): {"force_cutting": (17.45, 17.24, 18.41), "force_thrust": (13.54, 12.16, 12.19)},
    (0.2, True): {"force_cutting": (3.68, 3.14, 3.73), "force_thrust": (2.98, 2.95, 1.06)},
}
"""Depth of cut [mm] and grooves to the forces of three replicates [N/mm], width of cut 1 mm."""
FORCES = ("force_cutting", "force_thrust")


def measured(dataset: xr.Dataset) -> dict[tuple[float, bool], dict[str, list[float]]]:
    """Mean forces [N/mm] of all finished cuts, by depth of cut [mm] and grooves."""
    found: dict = defaultdict(lambda: {name: [] for name in FORCES})
    for run in cases(dataset, *(f"{name}_mean" for name in FORCES), kind="dem_cutting"):
        case = case_of(run)
        for name in FORCES:
            found[(round(case.cut_depth * 1e3, 9), case.grooves is not None)][name].append(
                float(values(run, f"{name}_mean"))
            )
    return dict(found)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel a force, one column a cut."""
    found = measured(dataset)
    cuts = sorted({*PAPER, *found})
    figure = page(2.7, PAGE)
    panels = figure.subplots(1, 2, sharex=True)
    for ax, name, text in zip(panels, FORCES, ("mean cutting force", "mean thrust force"), strict=True):
        for column, cut in enumerate(cuts):
            paper, ours = PAPER.get(cut, {}).get(name, ()), found.get(cut, {}).get(name, [])
            ax.plot([column + 0.15] * len(paper), paper, "x", color=BLACK)
            ax.plot([column - 0.15] * len(ours), ours, "o", color=QUANTITY[name], ms=3, alpha=0.6, mew=0)
            if ours:
                ax.hlines(np.mean(ours), column - 0.3, column, color=QUANTITY[name])
            if paper:
                ax.hlines(np.mean(paper), column, column + 0.3, color=BLACK)
        ax.set_xticks(
            range(len(cuts)), [f"{depth:g} mm\n{'grooved' if grooved else 'regular'}" for depth, grooved in cuts]
        )
        ax.set_xlabel("depth of cut, surface")
        ax.set_ylabel(f"{text} [N/mm]")
        ax.set_ylim(bottom=min(0, ax.get_ylim()[0]))
        ax.grid(axis="x", visible=False)
        handles = [
            Line2D([], [], color=QUANTITY[name], marker="o", ms=3, ls="", label="replicate"),
            Line2D([], [], color=QUANTITY[name], label="mean"),
            Line2D([], [], color=BLACK, marker="x", label="Yang et al."),
        ]
        ax.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Mean and standard deviation over the replicates, and their ratio to the paper's means."""
    header = ["depth of cut [mm]", "surface", "force", "replicates [N/mm]", "mean [N/mm]", "standard deviation [N/mm]"]
    header += ["paper: replicates [N/mm]", "paper: mean [N/mm]", "mean over paper's mean [-]"]
    found, rows = measured(dataset), []
    for cut, name in product(sorted({*PAPER, *found}), FORCES):
        ours, paper = found.get(cut, {}).get(name, []), PAPER.get(cut, {}).get(name, ())
        mean, reference = (float(np.mean(list(data))) if len(data) else math.nan for data in (ours, paper))
        spread = float(np.std(ours, ddof=1)) if len(ours) > 1 else math.nan
        names = [f"{cut[0]:g}", "grooved" if cut[1] else "regular", name.removeprefix("force_")]
        listed = [" ".join(f"{value:.2f}" for value in data) for data in (ours, paper)]
        rows.append([*names, listed[0], mean, spread, listed[1], reference, mean / reference])
    return Table("Mean forces of four cuts, for a millimetre of width", header, rows)
