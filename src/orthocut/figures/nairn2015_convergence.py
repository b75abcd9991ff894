"""Numerical error of ductile cuts: force over size and number of points, transfers, step, speed, rest and damping."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.extrapolation import Fit, extrapolate
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.sweep import over_toughness
from orthocut.figures.symbols import draw_force, draw_limit
from orthocut.figures.tables import Table, plain
from orthocut.figures.varied import series_along, value_of
from orthocut.io.collect import case_of, parameters
from orthocut.theory import bending, touching

CAPTION = (
    "Cutting force over particle size; over the share of the velocity gradient that points hand on (0 is PIC, 1 "
    "APIC) and, with the loop of the paper's program, over the share of their own velocity that they keep (0 is "
    "PIC, 1 FLIP); over the number of points along a side of a cell, at the same size of points; over the height of "
    "the row of nodes next above the cut, in cells (at 0 it lies on the cut, as in the paper); over the Courant "
    "number, to which the time step is proportional; over the speed of the tool; "
    "over the distance ahead of the tool, in depths of cut, beyond which material rests (at 0 all of it moves); and"
    " over the gain of the feedback damping while the tool speeds up. Runs of a series differ in nothing else. "
    "Colours: materials; symbols: schemes and laws of failure. Open: the tool touches the crack tip. Bars: standard "
    "error of the mean; pale bars: half of the drift over the window to either side. Over particle size: weighted "
    "least-squares fits of a limit plus slope times size, dashed, and times its square, dotted, with the limits "
    "(diamonds) and their standard errors; how far both limits lie apart says how much the assumed order matters. "
    "No support: nodes of little mass move on their own, as in the paper; dissipated, coupled: other criteria of "
    "failure than the paper's. Crosses on the axis: failed runs. The table lists all fits beside the models, also "
    "those of other numbers of points along a cell and places of the grid."
)
DIMS = ()
PANELS = (
    ("points_per_depth", "particle size over depth of cut $1/n$ [-]", 3),
    ("affine", "share of the gradient [-]", 3),
    ("flip", "share of FLIP [-]", 3),
    ("points_per_cell", "points a side $n_c$ [-]", 3),
    ("grid_offset", "grid offset [cells]", 3),
    ("courant", "Courant number $C$ [-]", 2),
    ("cut_speed", "tool speed $v$ [m/s]", 2),
    ("reach_ratio", "reach of what moves [-]", 3),
    ("ramp_feedback", "feedback [mm$^{-2}$]", 3),
)
"""Fields, labels and the least number of values of a series."""
PLACES = "AABCD\nEFGHI"
SHOWN = {"points_per_cell": (2,), "grid_offset": (0.0, 0.25)}
"""Values of fields with a panel of their own that the first panel shows too; the table has all."""
MARKERS = "osD^vPX"
POWERS = ((1.0, "--"), (2.0, ":"))


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel for each field."""
    figure = page(5.6, PAGE)
    panels = list(figure.subplot_mosaic(PLACES, sharey=True).values())
    for ax in (panels[0], panels[4]):
        ax.set_ylabel("force $F_c/(bG_c)$ [-]")
    scenes: list[tuple] = []
    handles: dict[str, object] = {}
    for ax, (field, text, least) in zip(panels, PANELS, strict=True):
        ax.set_xlabel(text)
        series = series_along(dataset, field, "force_cutting_mean", least=least)
        if ax is panels[0]:
            series = [(name, runs) for name, runs in series if _is_shown(runs[0])]
        others = [_others(runs[0], field) for _, runs in series]
        missing = [run for run in failed(dataset, "mpm_cutting") if _others(run, field) in others]
        mark(ax, [_place(run, field) for run in missing])
        if not series:
            ax.text(0.5, 0.5, "no series", transform=ax.transAxes, ha="center", color="0.5")
        used: dict[tuple, int] = {}
        for name, runs in series:
            scene = _scene(runs[0])
            scenes += [scene] if scene not in scenes else []
            colour = (SERIES * 9)[scenes.index(scene)]
            marker = MARKERS[used.setdefault(scene, 0) % len(MARKERS)]
            used[scene] += 1
            _series(ax, field, runs, colour, marker)
            if ax is panels[0] or not handles:
                handles[name] = ax.plot([], [], marker, color=colour)[0]
        if field != "points_per_depth":
            ax.set_xlim(left=0)
    if not scenes:
        for ax in panels:
            ax.clear()
            nothing(ax)
            ax.set_axis_off()
        return figure
    panels[0].set_ylim(bottom=0)
    figure.legend(handles.values(), handles.keys(), loc="outside upper center", ncols=2, fontsize="x-small")
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Limits of all series over particle size for both orders, beside the model of the regime of the finest run."""
    header = ["series", "points through the chip", "limit, first order [-]", "standard error [-]", "chi2/freedom"]
    header += ["limit, second order [-]", "standard error [-]", "chi2/freedom", "model [-]"]
    rows = []
    for name, runs in series_along(dataset, "points_per_depth", "force_cutting_mean", least=3):
        fits = [_fit(runs, power) for power, _ in POWERS]
        numbers = [number for fit in fits for number in (fit.limit, fit.error, fit.misfit)]
        points = " ".join(f"{case_of(run).numerics.points_per_depth}" for run in runs)
        rows.append([plain(name), points, *numbers, _model(runs[-1])])
    return Table("Cutting force over toughness at zero particle size", header, rows)


def _place(run: xr.Dataset, field: str) -> float:
    """Where a run stands on the axis of a field."""
    value = value_of(run, field)
    return 1.0 / value if field == "points_per_depth" else value


def _is_shown(run: xr.Dataset) -> bool:
    """Whether the first panel shows the series of a run."""
    numerics = case_of(run).numerics
    return all(getattr(numerics, field) in values for field, values in SHOWN.items())


def _others(run: xr.Dataset, field: str) -> dict[str, Any]:
    """All fields of the case of a run but one."""
    return {name: value for name, value in parameters(case_of(run)).items() if name != field}


def _scene(run: xr.Dataset) -> tuple:
    """Shape and material of what is cut; laws of failure and schemes differ by symbol."""
    case = case_of(run)
    return case.cut_depth, case.tool, case.material


def _fit(runs: list[xr.Dataset], power: float) -> Fit:
    sizes = [_place(run, "points_per_depth") for run in runs]
    errors = [over_toughness(run, "force_cutting_error") for run in runs]
    return extrapolate(sizes, [over_toughness(run) for run in runs], errors, power)


def _model(run: xr.Dataset) -> float:
    """Force over toughness of the touching or of the bending model, as the run has it [-]."""
    case = case_of(run)
    model = touching if float(run["touching"]) >= 0.5 else bending
    return model.solve(case.material, case.interface, case.tool, case.cut_depth).force_over_toughness


def _series(ax: Axes, field: str, runs: list[xr.Dataset], colour: str, marker: str) -> None:
    places = [_place(run, field) for run in runs]
    for run, place in zip(runs, places, strict=True):
        draw_force(ax, run, place, colour, marker)
    if field != "points_per_depth":
        ax.plot(places, [over_toughness(run) for run in runs], color=colour, lw=0.6)
        return
    curve = np.linspace(0.0, max(places), 40)
    for power, style in POWERS:
        fit = _fit(runs, power)
        ax.plot(curve, fit.at(curve), style, color=colour, lw=0.8)
        draw_limit(ax, fit.limit, fit.error, colour)
