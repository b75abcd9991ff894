"""Dimensionless cutting force over depth of cut, simulated and by the models: common to Nairn (2015), Figs 8, 11-15."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import label, nothing, page
from orthocut.figures.discretisation import finest, has_partners
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import BLACK, SERIES
from orthocut.figures.regimes import Transition, transition
from orthocut.figures.rubbing import rubbing_at, rubbing_between
from orthocut.figures.sweep import (
    Group,
    cut_depth,
    dimensionless_depth,
    group_name,
    grouped,
    over_toughness,
    touches,
)
from orthocut.figures.symbols import GREY, columns_of_handles, draw_force, resolution_handles, state_handles
from orthocut.io.collect import case_of
from orthocut.theory import bending, touching

SYMBOLS = (
    "Open symbols: the tool touches the crack tip; filled: the chip bends ahead of it. Bars: standard error of the "
    "mean; pale bars: half of the drift over the window to either side, large where a cut is not yet steady. Thin "
    "lines that end in a tick: from the finest resolution to zero particle size, on a straight line over particle size "
    "through the coarser run of the same cut. That is the discretisation error if it falls with the first order; with "
    "5 and 8 points the tick is known to some three times the bar. Ringed: the coarser run is of the other regime, and "
    "there is no such line. Without coarser runs this error is not shown. Crosses on the axis: failed runs."
)
"""What captions say of the symbols."""
DEFAULT_STRENGTH = 40e6
CURVE_POINTS = 60
WIDTH = 4.6  # inches
PRINTED, CONSISTENT, EXTENSION = "--", "-", ":"

Forces = tuple[np.ndarray, np.ndarray]
"""Dimensionless depths and forces of a curve."""


def draw_forces(
    dataset: xr.Dataset,
    *,
    touching_model: bool = False,
    bending_model: bool = False,
    rubbing_above: float = 0.0,
    extended_rake: float | None = None,
    one_model: bool = False,
    joined: bool = False,
) -> Figure:
    """One colour for each rake angle, friction, tangent modulus, cohesive stress and law.

    Parameters
    ----------
    dataset : xarray.Dataset
        Collected runs; those at the finest resolution of each cut are drawn, and what coarser ones tell of its error.
    touching_model, bending_model : bool
        Whether to draw the touching model up to the transition and the bending model beyond.
    rubbing_above : float
        Dimensionless depth of cut from which rubbing forces enter the printed bending model, on a straight line [-].
    extended_rake : float, optional
        Rake angle whose bending curve goes on to thinner cuts than bend, dotted [rad].
    one_model : bool
        Whether the series share one model: the curves of the one at the paper's cohesive stress, in black.
    joined : bool
        Whether dotted lines join the symbols of a series.
    """
    dataset = finest(dataset, "force_cutting_mean")
    groups = grouped(dataset, "force_cutting_mean")
    figure = page(4.1 if has_partners(dataset) else 3.7, WIDTH)
    ax = figure.subplots()
    ax.set_xlabel(label("depth_dimensionless") + " [-]")
    ax.set_ylabel(label("force_over_toughness") + " [-]")
    mark(ax, [dimensionless_depth(run) for run in failed(dataset, "mpm_cutting")])
    if not groups:
        nothing(ax)
        return figure

    deepest = 1.05 * max(cut_depth(run) for runs in groups.values() for run in runs)
    modelled = _nearest_default(groups) if one_model else None
    colours = dict(zip(groups, SERIES * 9, strict=False))
    for group, runs in groups.items():
        places = [dimensionless_depth(run) for run in runs]
        for run, place in zip(runs, places, strict=True):
            draw_force(ax, run, place, colours[group], _marker(group))
        if joined:
            ax.plot(places, [over_toughness(run) for run in runs], ":", color=colours[group], lw=0.9)
        if modelled in (None, group):
            extended = extended_rake is not None and np.isclose(group[0], extended_rake)
            curves = _curves(runs, deepest, touching_model, bending_model, rubbing_above, extended)
            for style, (x, y) in curves:
                width = 0.7 if style == CONSISTENT else 1.0
                ax.plot(x, y, style, color=colours[group] if modelled is None else BLACK, lw=width, zorder=1.5)
    highest = max(_highest(run) for runs in groups.values() for run in runs)
    ax.set_xlim(left=0)
    ax.set_ylim(0, 1.15 * highest)
    states = state_handles() + resolution_handles(dataset)
    _legend(figure, groups, colours, states, touching_model, bending_model, extended_rake is not None)
    return figure


def _highest(run: xr.Dataset) -> float:
    """Larger one of the force of a run and of its limit, over toughness [-]."""
    return float(np.fmax(over_toughness(run), over_toughness(run, "force_cutting_mean_limit")))


def _marker(group: Group) -> str:
    """Circles for the cubic law, triangles for others."""
    return "o" if group[-1] == "cubic" else "^"


def _nearest_default(groups: dict[Group, list[xr.Dataset]]) -> Group:
    """Series whose cohesive stress is nearest to the paper's; of equal ones the first."""
    return min(groups, key=lambda group: abs(group[3] - DEFAULT_STRENGTH))


def _curves(
    runs: list[xr.Dataset], deepest: float, touched: bool, bent: bool, above: float, extended: bool
) -> list[tuple[str, Forces]]:
    """Line styles and curves of the models that are wanted of a series."""
    found = transition([(cut_depth(run), touches(run)) for run in runs]) if touched else Transition(0.0, 0.0, 0)
    change = found.middle if found.found else found.low and deepest
    thin = np.linspace(0.0, change, CURVE_POINTS)[1:]
    thick = np.linspace(max(change, deepest / CURVE_POINTS), deepest, CURVE_POINTS)
    curves = []
    if touched and change:
        curves.append((PRINTED, _solved(runs, touching.solve, thin, rubbing_between(runs, thin))))
    if bent and change < deepest:
        curves.append((PRINTED, _solved(runs, bending.solve, thick, rubbing_at(runs, thick, above), form="paper")))
        curves.append((CONSISTENT, _solved(runs, bending.solve, thick, rubbing_at(runs, thick, above))))
        if extended and change:
            rubbing = rubbing_at(runs, thin, above)
            curves.append((EXTENSION, _solved(runs, bending.solve, thin, rubbing, form="paper")))
    return curves


def _solved(runs: list[xr.Dataset], solve, depths: np.ndarray, rubbing: np.ndarray, **form: str) -> Forces:
    """Curve of a model through some depths of cut [m] with their rubbing forces [N/m]."""
    case = case_of(runs[0])
    pairs = zip(depths, rubbing, strict=True)
    found = [solve(case.material, case.interface, case.tool, *pair, **form) for pair in pairs]
    return np.array([one.depth_dimensionless for one in found]), np.array([one.force_over_toughness for one in found])


def _legend(figure: Figure, groups, colours, states: list[Line2D], touched: bool, bent: bool, extended: bool) -> None:
    """Series, states and, where there are any, models; one column each where they fit."""
    series = [
        Line2D([], [], ls="", marker=_marker(group), color=colours[group], label=group_name(group, groups))
        for group in groups
    ]
    printed = "models of the paper" if touched else "bending, printed"
    lines = [(PRINTED, printed), (CONSISTENT, "bending, consistent"), (EXTENSION, "bending, thin cuts")]
    models = [Line2D([], [], color=GREY, ls=style, label=text) for style, text in lines[: 3 if extended else 2]]
    rest = states + (models if bent else [])
    columns = [series, rest]
    if len(series) > len(rest):
        half = (len(series) + 1) // 2
        columns = [series[:half], series[half:], rest]
    figure.legend(
        handles=columns_of_handles(*columns), loc="outside upper center", ncols=len(columns), columnspacing=1.2
    )
