"""Cuts that touch the crack tip, at zero particle size, beside the touching model at its own and at their angle."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.extrapolation import Fit, extrapolate
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.sweep import over_toughness, touches
from orthocut.figures.symbols import GREY, columns_of_handles, draw_force, draw_limit, state_handles
from orthocut.figures.tables import Table
from orthocut.figures.varied import series_along
from orthocut.io.collect import case_of
from orthocut.theory import touching

CAPTION = (
    "Cutting force over particle size of perfectly plastic cuts, one panel a rake angle, one colour a coefficient of "
    "friction. Open symbols: the tool touches the crack tip; filled: the chip bends. Bars: standard error of the mean; "
    "pale bars: half of the drift over the window to either side. Solid: weighted straight fits through the runs that "
    "touch, with their limits at zero particle size (diamonds) and standard errors. Dashed: touching model, eq. (14), "
    "without friction eq. (15), whose shear plane has the angle that needs least force. Dotted: the same balance of "
    "work, eq. (13), with the shear plane that the thickness of the finest chip tells. Both take the rubbing force of "
    "the finest run. Crosses on the axis: failed runs. The table holds the numbers, and what the finest run spends on "
    "things that the model does not know: plastic work in the base, losses in transfers and contact, elastic energy of "
    "the chip."
)
DIMS = ()
AXIS = "particle size over depth of cut $1/n$ [-]"


SPENT = {
    "rate_plastic_base": ("work_plastic_base",),
    "rate_lost": ("energy_numerical", "energy_contact"),
    "rate_stored": ("energy_elastic", "energy_kinetic"),
}
"""Energies per travel over toughness that the touching model does not know, and the histories that they are from."""


def condense(run: xr.Dataset) -> xr.Dataset:
    """Run with the energies per travel over toughness of `SPENT`, from the start of its window on [-]."""
    needed = {"tool_travel", "window_start", *(name for names in SPENT.values() for name in names)}
    if not needed <= set(run.variables) or not math.isfinite(float(run["window_start"])):
        return run
    late = run.isel(sample=run["tool_travel"].values >= float(run["window_start"]))
    scale = case_of(run).interface.toughness * float(late["tool_travel"][-1] - late["tool_travel"][0])
    rates = {
        rate: ((), sum(float(late[name][-1] - late[name][0]) for name in names) / scale, {"units": "1"})
        for rate, names in SPENT.items()
    }
    return run.assign(rates)


class Series(NamedTuple):
    """Runs that differ in particle size alone."""

    runs: list[xr.Dataset]
    """By points through the depth of cut."""
    fit: Fit | None
    """Straight line through the runs that touch; None with fewer than two of them."""
    model: float
    """Force over toughness of eq. (14) [-]."""
    model_measured: float
    """Force over toughness of eq. (13) at the measured angle of the shear plane [-]; NaN where that is not known."""

    @property
    def rake(self) -> float:
        """Rake angle [degree]."""
        return round(math.degrees(case_of(self.runs[0]).tool.rake_angle), 6)

    @property
    def friction(self) -> float:
        """Coefficient of friction [-]."""
        return case_of(self.runs[0]).tool.friction


def series_of(dataset: xr.Dataset) -> list[Series]:
    """All series of two sizes or more of which some touch, by rake angle and friction."""
    found = [_series(runs) for _, runs in series_along(dataset, "points_per_depth", "force_cutting_mean")]
    touched = [series for series in found if any(map(touches, series.runs))]
    return sorted(touched, key=lambda series: (series.rake, series.friction))


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel a rake angle."""
    found = series_of(dataset)
    rakes = sorted({series.rake for series in found})
    lost = failed(dataset, "mpm_cutting")
    figure = page(3.2, PAGE)
    if not found:
        ax = figure.subplots()
        ax.set_xlabel(AXIS)
        ax.set_ylabel("force $F_c/(bG_c)$ [-]")
        mark(ax, [_size(run) for run in lost])
        nothing(ax)
        return figure

    frictions = sorted({series.friction for series in found})
    panels = figure.subplots(1, len(rakes), squeeze=False)[0]
    panels[0].set_ylabel("force $F_c/(bG_c)$ [-]")
    for ax, rake in zip(panels, rakes, strict=True):
        ax.set_xlabel(AXIS)
        ax.set_title(rf"$\alpha$ = {rake:g}°", loc="left")
        mark(ax, [_size(run) for run in lost if math.isclose(math.degrees(case_of(run).tool.rake_angle), rake)])
        for series in found:
            if series.rake == rake:
                _panel(ax, series, (SERIES * 9)[frictions.index(series.friction)])
        ax.margins(y=0.08)
        ax.locator_params(axis="x", nbins=4)
    colours = [
        Line2D([], [], ls="", marker="o", color=colour, label=rf"$\mu$ = {friction:g}")
        for colour, friction in zip(SERIES * 9, frictions, strict=False)
    ]
    lines = [("-", "straight fit"), ("--", "eqs (14), (15)"), (":", "eq. (13), measured angle")]
    models = [Line2D([], [], color=GREY, ls=style, label=text) for style, text in lines]
    handles = columns_of_handles(colours, state_handles(), models)
    figure.legend(handles=handles, loc="outside upper center", ncols=3)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Forces at each size and their limits, beside the model at its own and at the measured angle."""
    found = series_of(dataset)
    points = sorted({case_of(run).numerics.points_per_depth for series in found for run in series.runs})
    header = ["rake angle [deg]", "friction [-]", *(f"force at {n} points [-]" for n in points)]
    header += ["limit [-]", "standard error [-]", "eq. (14) [-]", "limit over eq. (14) [-]"]
    header += ["chip thickness ratio [-]", "angle of the shear plane [deg]", "angle of least force [deg]"]
    header += ["eq. (13) at the measured angle [-]", "limit over eq. (13) [-]"]
    header += ["plastic work in the base [-]", "lost in transfers and contact [-]", "stored in the chip [-]"]
    header += ["finest force less these, over eq. (13) [-]"]
    rows = []
    for series in found:
        forces = {case_of(run).numerics.points_per_depth: over_toughness(run) for run in series.runs}
        limit, error = (series.fit.limit, series.fit.error) if series.fit else (math.nan, math.nan)
        fine = series.runs[-1]
        spent = [_number(fine, name) for name in SPENT]
        rows.append(
            [
                series.rake,
                series.friction,
                *(forces.get(n, math.nan) for n in points),
                limit,
                error,
                series.model,
                limit / series.model,
                _number(fine, "chip_thickness_ratio"),
                math.degrees(_number(fine, "angle_shear")),
                math.degrees(_model(fine).angle_shear),
                series.model_measured,
                limit / series.model_measured,
                *spent,
                (over_toughness(fine) - sum(spent)) / series.model_measured,
            ]
        )
    return Table("Touching cuts at zero particle size, cutting force over toughness", header, rows)


def _series(runs: list[xr.Dataset]) -> Series:
    touched = [run for run in runs if touches(run)]
    fit = None
    if len(touched) > 1:
        errors = [over_toughness(run, "force_cutting_error") for run in touched]
        fit = extrapolate([_size(run) for run in touched], [over_toughness(run) for run in touched], errors)
    return Series(runs, fit, _model(runs[-1]).force_over_toughness, _model_measured(runs[-1]))


def _panel(ax: Axes, series: Series, colour: str) -> None:
    """Symbols, fit and levels of the models of one series."""
    for run in series.runs:
        draw_force(ax, run, _size(run), colour)
    ends = np.array([0.0, max(_size(run) for run in series.runs)])
    if series.fit:
        ax.plot(ends, series.fit.at(ends), "-", color=colour, lw=0.8)
        draw_limit(ax, series.fit.limit, series.fit.error, colour)
    for level, style in ((series.model, "--"), (series.model_measured, ":")):
        ax.plot(ends, [level, level], style, color=colour, lw=1.0, zorder=1.5)


def _size(run: xr.Dataset) -> float:
    """Particle size over depth of cut [-]."""
    return 1.0 / case_of(run).numerics.points_per_depth


def _number(run: xr.Dataset, name: str) -> float:
    """Value of a variable; NaN where the run lacks it."""
    return float(run[name]) if name in run else math.nan


def _rubbing(run: xr.Dataset) -> float:
    """Rubbing force [N/m]; zero where it is not known."""
    force = _number(run, "force_rubbing_mean")
    return force if math.isfinite(force) else 0.0


def _model(run: xr.Dataset) -> touching.TouchingSolution:
    case = case_of(run)
    return touching.solve(case.material, case.interface, case.tool, case.cut_depth, _rubbing(run))


def _model_measured(run: xr.Dataset) -> float:
    """Force over toughness of eq. (13) at the angle that the thickness of the chip tells [-]."""
    case, angle = case_of(run), _number(run, "angle_shear")
    toughness = case.interface.toughness
    if not math.isfinite(angle):
        return math.nan
    force = touching.force_of_angle(
        angle,
        case.cut_depth,
        case.tool.rake_angle,
        case.tool.friction,
        case.material.stress_yield,
        toughness,
        _rubbing(run),
    )
    return force / toughness
