"""Why simulated cutting forces of glass miss measured ones: what each choice that the paper leaves open changes."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, NullFormatter

from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.confidence import Interval, interval
from orthocut.figures.palette import BLACK, QUANTITY
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_comparison import factor
from orthocut.figures.yang2018_finding import over, over_early
from orthocut.figures.yang2018_paper import EXPERIMENT, FORCES, NAMES, SIMULATION, WIDTHS, mean, words
from orthocut.figures.yang2018_runs import (
    CALIBRATED_STRENGTH,
    GlassRun,
    as_printed,
    condense,
    condition,
    conditions,
    cuts_of,
    forces,
)
from orthocut.io.collect import parameters

__all__ = ["CAPTION", "DIMS", "condense", "draw", "tabulate"]

CAPTION = (
    "Factor by which one change, all else equal, alters the mean main force (filled) and thrust force (open) of cuts "
    "of glass, packing by packing, with 95 % confidence intervals; below, what there is to explain: simulated over "
    "measured forces for the same width, of the paper and of this work."
)
DIMS = ("sample",)
LEAST = 2
"""Fewest packings of a row."""
UNKNOWN = Interval(math.nan, math.nan, math.nan, 0)
GAP = "simulated over measured"
"""Name of the rows that tell what there is to explain."""


class Choice(NamedTuple):
    """Fields that are chosen together, the usual choice, and how to say one."""

    name: str
    fields: tuple[str, ...]
    is_usual: Callable[[GlassRun], bool]
    said: Callable[[GlassRun], str]


def _grooves(run: GlassRun) -> str:
    grooves = run.case.grooves
    if grooves is None:
        return "none"
    shape = {1.0: "rectangles", 0.0: "triangles"}.get(grooves.bottom_ratio, "trapezoids")
    return f"{shape} {1e3 * grooves.distance:g} mm apart"


def _block(run: GlassRun) -> str:
    packing = run.case.packing
    return f"{1e3 * packing.width:g} x {1e3 * packing.height:g} mm of {1e6 * packing.radius_min:g} µm"


def _joints(run: GlassRun) -> str:
    if as_printed(run.case.joint):
        return "as printed"
    stronger = run.case.joint.strength_tensile / CALIBRATED_STRENGTH
    return "calibrated" if _close(stronger, 1.0) else f"{stronger:.3g} times as strong"


def _close(value: float, wanted: float) -> bool:
    return math.isclose(value, wanted, rel_tol=1e-9)


CHOICES = (
    Choice(
        "local damping",
        ("joint_damping",),
        lambda run: _close(run.case.joint.damping, 0.1),
        lambda run: f"{run.case.joint.damping:g}",
    ),
    Choice(
        "speed of the tool",
        ("cut_speed",),
        lambda run: _close(run.case.cut_speed, 1.0),
        lambda run: f"{run.case.cut_speed:g} m/s",
    ),
    Choice(
        "smallest radius",
        ("packing_radius_min",),
        lambda run: _close(run.case.packing.radius_min, 10e-6),
        lambda run: f"{1e6 * run.case.packing.radius_min:g} µm",
    ),
    Choice(
        "height of the block",
        ("packing_height",),
        lambda run: _close(run.case.packing.height, 1e-3),
        lambda run: f"{1e3 * run.case.packing.height:g} mm",
    ),
    Choice(
        "block and discs",
        ("packing_height", "packing_width", "packing_radius_min", "travel"),
        lambda run: _block(run) == "1 x 1 mm of 10 µm",
        _block,
    ),
    Choice(
        "joints",
        ("joint_modulus", "joint_stiffness_ratio", "joint_strength_tensile", "joint_cohesion"),
        lambda run: _joints(run) == "calibrated",
        _joints,
    ),
    Choice(
        "friction at the tool",
        ("friction",),
        lambda run: _close(run.case.tool.friction, 0.577),
        lambda run: f"{run.case.tool.friction:g}",
    ),
    Choice(
        "grooves",
        ("groove_width", "groove_distance", "groove_bottom_ratio", "grooved"),
        lambda run: _grooves(run) == "rectangles 0.2 mm apart",
        _grooves,
    ),
    Choice(
        "time step factor",
        ("joint_time_step_factor",),
        lambda run: _close(run.case.joint.time_step_factor, 0.5),
        lambda run: f"{run.case.joint.time_step_factor:g}",
    ),
)


class Row(NamedTuple):
    """One change and what it does to the forces."""

    choice: str
    change: str
    at: str
    packings: int
    factors: tuple[Interval, ...]
    """For each of `FORCES`."""
    early: Interval = UNKNOWN
    """For the main force over the first three quarters of the travel, before chips pile up at the fixed side."""


def changes(cuts: Sequence[GlassRun]) -> Iterator[Row]:
    """Rows of all choices: each other value against the usual one, where nothing else differs."""
    for choice in CHOICES:
        groups: dict[tuple, dict[str, list[GlassRun]]] = defaultdict(lambda: defaultdict(list))
        for cut in cuts:
            rest = {name: value for name, value in parameters(cut.case).items() if name not in {*choice.fields, "seed"}}
            groups[tuple(sorted(rest.items()))][choice.said(cut)].append(cut)
        for group in groups.values():
            usual = [runs for runs in group.values() if choice.is_usual(runs[0])]
            for said, runs in sorted(group.items(), key=lambda pair: _values(pair[1][0], choice)):
                if usual and runs is not usual[0] and choice is _narrowest(runs[0], usual[0][0]):
                    yield from _row(choice, said, runs, usual[0])


def _values(run: GlassRun, choice: Choice) -> tuple[float, ...]:
    """Values of the fields of a choice, to sort by."""
    fields = parameters(run.case)
    return tuple(float(fields[name]) for name in choice.fields if name in fields)


def _narrowest(run: GlassRun, other: GlassRun) -> Choice:
    """Choice of the fewest fields that tells two cuts apart."""
    first, second = parameters(run.case), parameters(other.case)
    differ = {name for name in first.keys() | second.keys() if first.get(name) != second.get(name)} - {"seed"}
    return min((choice for choice in CHOICES if differ <= {*choice.fields}), key=lambda choice: len(choice.fields))


def _row(choice: Choice, said: str, runs: list[GlassRun], usual: list[GlassRun]) -> Iterator[Row]:
    factors = tuple(over(runs, usual, f"{name}_mean") for name in FORCES)
    if factors[0].count >= LEAST:
        change = f"{choice.said(usual[0])} → {said}"
        before = over_early(runs, usual, FORCES[0])
        yield Row(choice.name, change, _where(runs[0], choice), factors[0].count, factors, before)


def _where(run: GlassRun, choice: Choice | None = None) -> str:
    """Depth of cut and surface, speed and damping, but for the field that changes."""
    fields = choice.fields if choice else ()
    parts = [words(condition(run)) if "grooved" not in fields else f"{1e3 * run.case.cut_depth:g} mm"]
    if "cut_speed" not in fields:
        parts.append(f"{run.case.cut_speed:g} m/s")
    if "joint_damping" not in fields:
        parts.append(f"damping {run.case.joint.damping:g}")
    return ", ".join(parts)


def gaps(cuts: Sequence[GlassRun]) -> Iterator[Row]:
    """Rows of simulated over measured forces: the paper's, ours as most cuts are made, and ours with most damping."""
    for cut in SIMULATION:
        known = tuple(Interval(factor(cut, name), math.nan, math.nan, 3) for name in FORCES)
        yield Row(GAP, "paper", words(cut), 3, known)
    most = max((run.case.joint.damping for run in cuts), default=math.nan)
    damped = [run for run in cuts if run.case.joint.damping == most]
    for found in (conditions(cuts), conditions(damped)):
        for cut, runs in found.items():
            if cut in EXPERIMENT:
                known = tuple(_over_measured(cut, name, runs) for name in FORCES)
                yield Row(GAP, "this work", _where(runs[0]), len(runs), known)


def _over_measured(cut: tuple[float, bool], name: str, runs: list[GlassRun]) -> Interval:
    known = interval(forces(runs, name))
    real = mean(EXPERIMENT[cut][name]) / WIDTHS["experiment"]
    return Interval(known.mean / real, known.half / real, known.spread / real, known.count)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One row a change, on a logarithmic axis; below, the gaps."""
    cuts = cuts_of(dataset)
    rows = [list(changes(cuts)), list(gaps(cuts))]
    if not rows[0]:
        figure = page(2.0, PAGE)
        nothing(figure.subplots())
        return figure

    heights = [len(some) + 1 for some in rows]
    figure = page(0.16 * sum(heights) + 0.8, PAGE)
    panels = figure.subplots(2, 1, height_ratios=heights)
    for ax, some in zip(panels, rows, strict=True):
        _panel(ax, some)
    panels[0].set_xlabel("factor on the mean force [-]")
    panels[1].set_xlabel("simulated over measured force, for the same width [-]")
    handles = [
        Line2D([], [], color=QUANTITY[name], marker="o", mfc=face, ls="", label=f"{NAMES[name]} force")
        for name, face in zip(FORCES, (QUANTITY[FORCES[0]], "white"), strict=True)
    ]
    figure.legend(handles=handles, loc="outside upper center", ncols=2)
    return figure


def _panel(ax: Axes, rows: Sequence[Row]) -> None:
    for shift, name, index in ((-0.15, FORCES[0], 0), (0.15, FORCES[1], 1)):
        places = np.arange(len(rows)) + shift
        values = np.array([row.factors[index].mean for row in rows])
        values = np.where(values > 0, values, np.nan)  # a force that changes its sign has no place on this axis
        half = np.nan_to_num([row.factors[index].half for row in rows])
        low = np.minimum(half, 0.9 * values)  # a bar that reaches zero has no end on this axis
        face = QUANTITY[name] if index == 0 else "white"
        style = {"color": QUANTITY[name], "mfc": face, "capsize": 1.5, "elinewidth": 0.8, "ms": 3.5}
        ax.errorbar(values, places, xerr=[low, half], fmt="o", **style)
    ax.axvline(1.0, color=BLACK, lw=0.6)
    ax.set_xscale("log")
    ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.set_yticks(range(len(rows)), [_label(row) for row in rows], fontsize=5.5)
    ax.set_ylim(len(rows) - 0.4, -0.6)


def _label(row: Row) -> str:
    return f"{row.change if row.choice == GAP else f'{row.choice} {row.change}'} ({row.at})"


def tabulate(dataset: xr.Dataset) -> Table:
    """Factors and their 95 % half-widths."""
    header = ["what", "change", "cut", "packings", "main force: factor [-]", "± 95 %", "thrust force: factor [-]"]
    header += ["± 95 %", "main force, first three quarters of travel: factor [-]", "± 95 %"]
    cuts = cuts_of(dataset)
    rows = [
        [*row[:4], *(number for one in (*row.factors, row.early) for number in (one.mean, one.half))]
        for row in (*changes(cuts), *gaps(cuts))
    ]
    return Table("What changes the mean forces of cuts of glass, and what there is to explain", header, rows)
