"""Regime map: where the tool touches the crack tip and where the chip bends, from either start."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import PAGE, cases, nothing, page, styled
from orthocut.figures.discretisation import finest
from orthocut.figures.holes import GREY, failed
from orthocut.figures.palette import BLUE, ORANGE
from orthocut.figures.regimes import NOTCH_LONG, transition
from orthocut.figures.sweep import touches
from orthocut.figures.symbols import columns_of_handles
from orthocut.figures.tables import Table
from orthocut.io.collect import case_of
from orthocut.params.mpm import MpmCutting

CAPTION = (
    "Regimes of ductile cuts without friction over depth of cut and rake angle (left, perfectly plastic), and over "
    "depth of cut and tangent modulus (right, rake angle 30°). Left half of a symbol: the cut started from a short "
    "notch, with the tool at the crack tip; right half: from a long one, with a bent chip; where the halves differ in "
    "colour, the regime depends on the start (hysteresis). Crosses: failed runs, where their half would stand. Lines "
    "join the depths of transition of either start, in the middle between the neighbouring runs. Star: transition of "
    "the paper at 30°, 2.0-2.1 mm, drawn beside its place."
)
DIMS = ()
TOUCHING, BENDING = BLUE, ORANGE
SIDES = {"short": "left", "long": "right"}
LINES = {"short": "-", "long": "--"}
PAPER_RAKE, PAPER_DEPTH = 30.0, 2.05  # degree, mm
DEPTHS = (0.1, 0.2, 0.5, 1, 2, 5)
RAKE = math.radians(PAPER_RAKE)

Place = tuple[float, float]
"""Value along the panel and depth of cut [mm]."""


def start_of(case: MpmCutting) -> str:
    """``short`` or ``long``: the notch that the case starts from."""
    return "long" if case.workpiece.notch_ratio >= NOTCH_LONG else "short"


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Two panels: depth of cut over rake angle and over tangent modulus."""
    dataset = finest(dataset)
    figure = page(3.9, PAGE)
    panels = figure.subplots(1, 2, sharey=True)
    done = [(case_of(run), touches(run)) for run in cases(dataset, "touching", kind="mpm_cutting")]
    lost = [case_of(run) for run in failed(dataset, "mpm_cutting")]
    plastic, thirty = _sorted_out(done)
    plastic_lost, thirty_lost = _sorted_out([(case, False) for case in lost])
    _panel(panels[0], plastic, plastic_lost, _rake, even=False)
    _panel(panels[1], thirty, thirty_lost, _tangent, even=True)
    panels[0].set_xlabel(r"rake angle $\alpha$ [°]")
    panels[1].set_xlabel("tangent modulus $E_T$ [MPa]")
    panels[0].set_ylabel("depth of cut $h$ [mm]")
    panels[0].plot(PAPER_RAKE + 2.0, PAPER_DEPTH, "*", color="0.1", ms=7, mfc="white", zorder=5)
    figure.legend(handles=_handles(), loc="outside upper center", ncols=3)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Interval of the transition of each column and start, and the number of cases that depend on the start."""
    header = ["rake angle [deg]", "tangent modulus [MPa]", "start", "deepest touching [mm]", "shallowest bending [mm]"]
    header += ["runs of the other regime", "depths at which the start decides"]
    columns: dict[tuple[float, float], dict[str, dict[float, bool]]] = defaultdict(lambda: defaultdict(dict))
    done = [(case_of(run), touches(run)) for run in cases(finest(dataset), "touching", kind="mpm_cutting")]
    for case, touching in [item for part in _sorted_out(done) for item in part]:
        columns[_rake(case), _tangent(case)][start_of(case)][1e3 * case.cut_depth] = touching
    rows = []
    for (rake, tangent), starts in sorted(columns.items()):
        both = set(starts.get("short", {})) & set(starts.get("long", {}))
        differ = sum(starts["short"][depth] != starts["long"][depth] for depth in both) if both else math.nan
        for start, depths in sorted(starts.items(), reverse=True):
            change = transition(list(depths.items()))
            rows.append([rake, tangent, start, change.low or math.nan, change.high, change.strays, differ])
    return Table("Regimes of ductile cuts", header, rows)


def _rake(case: MpmCutting) -> float:
    return round(math.degrees(case.tool.rake_angle), 6)


def _tangent(case: MpmCutting) -> float:
    return round(1e-6 * case.material.modulus_tangent, 9)


Cases = list[tuple[MpmCutting, bool]]


def _sorted_out(runs: Cases) -> tuple[Cases, Cases]:
    """Cases of the left and of the right panel: perfectly plastic; rake angle of 30 degrees."""
    plastic = [run for run in runs if run[0].material.modulus_tangent == 0]
    return plastic, [run for run in runs if math.isclose(run[0].tool.rake_angle, RAKE, rel_tol=1e-6)]


def _panel(ax: Axes, runs: Cases, lost: Cases, along: Callable[[MpmCutting], float], even: bool) -> None:
    """Symbols and lines of transition; `even` puts the values of the axis at equal distances."""
    ax.set_yscale("log")
    if not runs and not lost:
        nothing(ax)
        return
    columns = sorted({along(case) for case, _ in runs + lost})
    place = {value: float(index) if even else value for index, value in enumerate(columns)}
    shift = 0.012 * (max(place.values()) - min(place.values()) or 1.0)
    for case, touching in runs:
        colour = TOUCHING if touching else BENDING
        style = {"fillstyle": SIDES[start_of(case)], "markerfacecoloralt": "none", "mec": "0.4", "mew": 0.4}
        ax.plot(place[along(case)], 1e3 * case.cut_depth, "o", color=colour, ms=8, **style)
    for case, _ in lost:
        x = place[along(case)] + (shift if start_of(case) == "long" else -shift)
        ax.plot(x, 1e3 * case.cut_depth, "x", color=GREY, ms=4, zorder=4)
    for start, style in LINES.items():
        changes = {
            value: transition(
                [(case.cut_depth, found) for case, found in runs if along(case) == value and start_of(case) == start]
            )
            for value in columns
        }
        line = [(place[value], 1e3 * change.middle) for value, change in changes.items() if change.found]
        if line:
            ax.plot(*zip(*line, strict=True), style, color="0.1", lw=1.0, zorder=1.5)
    ax.set_yticks(DEPTHS, [f"{depth:g}" for depth in DEPTHS])
    ax.minorticks_off()
    if even:
        ax.set_xticks(list(place.values()), [f"{value:g}" for value in columns])
    ax.margins(0.08)


def _handles() -> list[Line2D]:
    def half(side: str, colour: str, text: str) -> Line2D:
        style = {"fillstyle": side, "markerfacecoloralt": "none", "mec": "0.4", "mew": 0.4}
        return Line2D([], [], ls="", marker="o", ms=8, color=colour, label=text, **style)

    states = [half("full", TOUCHING, "touching"), half("full", BENDING, "bending")]
    starts = [half(SIDES[start], "0.6", f"started from a {start} notch") for start in SIDES]
    lines = [Line2D([], [], color="0.1", ls=LINES[start], label=f"transition, {start} notch") for start in LINES]
    lost = Line2D([], [], ls="", marker="x", color=GREY, ms=4, label="failed")
    paper = Line2D([], [], ls="", marker="*", color="0.1", mfc="white", ms=7, label="Nairn (2015)")
    return columns_of_handles([*states, lost], starts, [*lines, paper])
