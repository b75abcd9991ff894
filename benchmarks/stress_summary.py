"""Tables and picture of what became of random scenes."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from rich.console import Console
from rich.table import Table
from stress_worker import DONE, FAILED, OUTCOMES, REFUSED

from orthocut.figures.canvas import PAGE, page, styled
from orthocut.figures.palette import BLUE, ORANGE, PURPLE
from orthocut.figures.save import save

Rows = Mapping[str, Sequence[Mapping[str, str]]]
GUARDS = (
    ("out of range", "range of a field"),
    ("leave a wedge", "wedge of the tool too thin"),
    ("modulus_tangent", "tangent modulus over 0.9 of Young's"),
    ("Poisson", "Poisson's ratio"),
    ("leave no room for a groove", "no room for a groove"),
    ("half of the block", "cut deeper than half of the block"),
    ("less than a grain", "cut thinner than a grain"),
    ("less than half a grain", "groove or wall thinner than half a grain"),
    ("takes .* steps", "too few steps"),
    ("is unstable with", "unstable time step"),
    ("fraction_slit", "fractions of joints"),
    ("did not settle|pressure over modulus", "packing does not get there"),
    ("packing of .* diverged|fewer than two discs", "packing does not get there"),
    ("edge of the grid", "a point leaves the grid"),
    ("sinks into the base", "chip sinks into the base"),
    ("transfers and contact make", "energy made by transfers and contact"),
    ("not accounted for", "energy balance"),
    ("no longer finite|is nan|is inf", "values not finite"),
    ("momentum", "momentum balance"),
    ("inside the tool", "points in the tool"),
    ("overlap", "overlap of discs"),
    ("faster than", "speed limit"),
    ("more neighbours", "list of contacts is full"),
)
"""What a message says to the guard that says it, in the order in which they are tried."""
COLOURS = {DONE: BLUE, REFUSED: "#C9C9C9", FAILED: ORANGE}
MARKS = {DONE: "o", REFUSED: ".", FAILED: "^"}
PLANES = {
    "mpm": (
        ("rake_angle_deg", "rake angle [°]", "friction", "friction [-]"),
        ("ran: speed over waves", "tool speed over wave speed [-]", "courant", "Courant number [-]"),
    ),
    "dem": (
        ("ran: speed over waves", "tool speed over speed of sound [-]", "time_step_factor", "time step factor [-]"),
        ("strength_times", "tensile strength over Table 1 [-]", "modulus_GPa", "modulus [GPa]"),
    ),
}
"""Planes of the picture of each solver: column and label, twice; what was run is not known of refused scenes."""
NAMES = {"mpm": "ductile cuts (MPM)", "dem": "bonded discs (DEM)"}


def guard_of(why: str) -> str:
    """Guard that spoke."""
    return next((name for pattern, name in GUARDS if re.search(pattern, why)), "other")


def write_summary(rows: Rows, folder: Path) -> None:
    """Write tables of outcomes and of guards, and the picture."""
    folder.mkdir(parents=True, exist_ok=True)
    solvers = [solver for solver in NAMES if rows.get(solver)]
    if not solvers:
        return
    header = ["outcome", "guard", *(f"{NAMES[solver]} [scenes]" for solver in solvers)]
    lines = []
    for outcome in OUTCOMES:
        found = {solver: [row for row in rows[solver] if row["outcome"] == outcome] for solver in solvers}
        lines.append([outcome, "", *(str(len(found[solver])) for solver in solvers)])
        if outcome in (REFUSED, FAILED):
            counts = {solver: Counter(guard_of(row["why"]) for row in found[solver]) for solver in solvers}
            total = sum(counts.values(), Counter())
            lines += [[outcome, guard, *(str(counts[s][guard]) for s in solvers)] for guard, _ in total.most_common()]
    lines.append(["all", "", *(str(len(rows[solver])) for solver in solvers)])
    _write(header, lines, folder / "stress")
    save(draw_outcomes(rows), folder / "stress.png")


def _write(header: list[str], lines: list[list[str]], target: Path) -> None:
    with open(target.with_suffix(".csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(lines)
    text = [header, ["---", "---", *["---:"] * (len(header) - 2)], *lines]
    target.with_suffix(".md").write_text("".join(f"| {' | '.join(line)} |\n" for line in text), encoding="utf-8")
    table = Table(*header)
    for line in lines:
        table.add_row(*line)
    Console().print(table)


@styled
def draw_outcomes(rows: Rows) -> Figure:
    """Outcomes of the scenes of each solver over two planes of what was drawn."""
    solvers = [solver for solver in NAMES if rows.get(solver)]
    figure = page(2.5 * len(solvers) + 0.35, PAGE)
    panels = figure.subplots(len(solvers), 2, squeeze=False)
    for line, solver in zip(panels, solvers, strict=True):
        for ax, plane in zip(line, PLANES[solver], strict=True):
            _draw_plane(ax, rows[solver], *plane)
        counts = Counter(row["outcome"] for row in rows[solver])
        told = ", ".join(f"{counts[outcome]} {outcome}" for outcome in OUTCOMES if counts[outcome])
        line[0].set_title(f"{NAMES[solver]}: {told}", loc="left")
    keys = [
        Line2D([], [], ls="", marker=MARKS.get(name, "X"), color=COLOURS.get(name, PURPLE), ms=4, label=name)
        for name in OUTCOMES
        if name in COLOURS or any(row["outcome"] == name for solver in solvers for row in rows[solver])
    ]
    figure.legend(handles=keys, loc="outside lower center", ncols=len(keys))
    return figure


def _draw_plane(ax: Axes, rows: Sequence[Mapping[str, str]], x: str, x_label: str, y: str, y_label: str) -> None:
    for outcome in (REFUSED, DONE, FAILED, *(name for name in OUTCOMES if name not in COLOURS)):
        here = [row for row in rows if row["outcome"] == outcome and row.get(x) and row.get(y)]
        places = np.array([[float(row[x]), float(row[y])] for row in here]).reshape(-1, 2)
        plain = outcome in COLOURS
        ax.plot(
            *places.T, ls="", marker=MARKS.get(outcome, "X"), color=COLOURS.get(outcome, PURPLE),
            ms=3.2 if plain else 6, mec="white" if plain else "black", mew=0.3, zorder=2 + OUTCOMES.index(outcome),
        )  # fmt: skip
    for name, scale in ((x, ax.set_xscale), (y, ax.set_yscale)):
        shares = [float(row[name]) for row in rows if row.get(name)]
        if (min(shares) > 0 and max(shares) > 50 * min(shares)) or name in ("courant", "time_step_factor"):
            scale("log")
    ax.set_xlabel(x_label)
    ax.set_ylabel(y_label)
