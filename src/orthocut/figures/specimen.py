"""Shared parts of the figures of the glass specimen: the whole beside a magnified part, tests with their curves."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

from orthocut.figures.canvas import PAGE, cases, line, name_axes, nothing, page, values
from orthocut.figures.palette import BLACK, QUANTITY, SERIES, SHEAR, TENSION
from orthocut.figures.scene import draw_cracks, draw_discs, frame, last_snapshot
from orthocut.figures.yang2018_paper import TABLE_2
from orthocut.figures.yang2018_runs import as_printed
from orthocut.io.collect import case_of
from orthocut.variables import VARIABLES


def extent(run: xr.Dataset, snapshot: int = 0) -> tuple[tuple[float, float], tuple[float, float]]:
    """Range of x and of y that the discs of a snapshot fill [mm], at most a third of the packing beyond its sides."""
    scene = run.isel(snapshot=snapshot)
    radius = run["disc_radius"].values * 1e3
    x, y = values(scene, "disc_x"), values(scene, "disc_y")
    width, height = (1e3 * side for side in (case_of(run).packing.width, case_of(run).packing.height))
    low = max(np.nanmin(x - radius), -width / 3), max(np.nanmin(y - radius), -height / 3)
    high = min(np.nanmax(x + radius), 4 * width / 3), min(np.nanmax(y + radius), 4 * height / 3)
    return (low[0], high[0]), (low[1], high[1])


def magnified(dataset: xr.Dataset, paint, factor: float = 12.0) -> Figure:
    """The specimen of the first run beside a part of it.

    Parameters
    ----------
    paint : callable (axes, run, magnified) -> None
        Draws the specimen at its first snapshot.
    factor : float
        Number of mean disc diameters along the sides of the magnified part.
    """
    runs = cases(dataset, "disc_x")
    figure = page(3.4, 5.4)
    if not runs:
        nothing(figure.subplots())
        return figure

    run = runs[0]
    (left, right), (bottom, top) = extent(run)
    margin = 0.02 * (top - bottom)
    ratio = (right - left) / (top - bottom)
    whole, part = figure.subplots(1, 2, width_ratios=[max(ratio, 0.4), 1])
    paint(whole, run, False)
    frame(whole, (left - margin, right + margin), (bottom - margin, top + margin))
    size = factor * 2e3 * float(np.nanmean(run["disc_radius"].values))
    size = min(size, 0.9 * (right - left), 0.9 * (top - bottom))
    x, y = (left + right - size) / 2, (bottom + top - size) / 2
    paint(part, run, True)
    frame(part, (x, x + size), (y, y + size))
    whole.add_patch(Rectangle((x, y), size, size, fill=False, ec="black", lw=0.9, zorder=4))
    for side in part.spines.values():
        side.set_visible(True)
    return figure


def crack_legend(tension: int, shear: int) -> list[Line2D]:
    """Legend entries of both kinds of cracks, with their numbers."""
    return [
        Line2D([], [], color=TENSION, lw=1.5, label=f"tension ({tension})"),
        Line2D([], [], color=SHEAR, lw=1.5, label=f"shear ({shear})"),
    ]


def strength_test(dataset: xr.Dataset, kind: str, sense: str) -> Figure:
    """Specimen with its cracks, beside the stress-strain curves of all replicates.

    Parameters
    ----------
    kind : str
        Kind of run to draw; others are ignored.
    sense : str
        Words for the axes; stress and strain are drawn positive along the loading. The strain is that of the
        measurement region, or that of the whole specimen if not all runs hold the former.
    """
    runs, gauged = (cases(dataset, "stress_axial", name, kind=kind) for name in ("strain_axial", "strain_gauge"))
    strain = "strain_gauge" if len(gauged) >= len(runs) else "strain_axial"
    runs = gauged if strain == "strain_gauge" else runs
    figure = page(3.3, PAGE)
    picture, curves = figure.subplots(1, 2, width_ratios=[1, 1.35])
    name_axes(curves, f"{VARIABLES[strain].long_name}, {sense} [%]", f"axial stress, {sense} [MPa]")
    if not runs:
        nothing(picture)
        nothing(curves)
        picture.set_axis_off()
        return figure

    materials = ["as printed" if as_printed(case_of(run).joint) else "calibrated" for run in runs]
    several = len(set(materials)) > 1
    for colour, run, material in zip(SERIES * 9, runs, materials, strict=False):
        _curve(curves, run, strain, colour, f"{material}, " if several else "")
    _paper(curves, kind)
    curves.set_xlim(left=0)
    curves.set_ylim(bottom=0)
    curves.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncols=1, borderaxespad=0.2)
    _picture(picture, runs[0])
    return figure


def _along(run: xr.Dataset, name: str) -> np.ndarray:
    """Stress or strain, turned so that its largest magnitude is positive."""
    found = values(run, name)
    turned = np.isfinite(found).any() and np.nanmax(found) < -np.nanmin(found)
    return -found if turned else found


def _paper(ax: Axes, kind: str) -> None:
    """Straight line with the modulus of the paper's model, up to its strength."""
    modulus = next(row.model for row in TABLE_2 if row.variable == "modulus_young")
    strength = next(row.model for row in TABLE_2 if (row.kind, row.variable) == (kind, "strength_ultimate"))
    text = f"Yang et al.: $E$ = {modulus:g} GPa, $\\sigma_u$ = {strength:g} MPa"
    ax.plot([0, 0.1 * strength / modulus], [0, strength], "--", color=BLACK, lw=0.9, label=text)
    ax.plot(0.1 * strength / modulus, strength, "x", color=BLACK)


def _curve(ax: Axes, run: xr.Dataset, strain: str, colour: str, prefix: str) -> None:
    """One test; `prefix` names its material where the figure shows several."""
    case = case_of(run)
    parts = [f"{prefix}seed {case.packing.seed}"]
    for name, text in (
        ("modulus_young", "$E$ = {:.3g} GPa"),
        ("ratio_poisson", r"$\nu$ = {:.3f}"),
        ("strength_ultimate", r"$\sigma_u$ = {:.3g} MPa"),
    ):
        value = abs(float(values(run, name)))
        if math.isfinite(value):
            parts.append(text.format(value))
    x, y = _along(run, strain), _along(run, "stress_axial")
    ax.plot(x, y, color=colour, label=", ".join(parts))
    if np.isfinite(y).any():
        peak = int(np.nanargmax(y))
        ax.plot(x[peak], y[peak], "o", color=colour, mfc="white", zorder=3)
    if np.isfinite(values(run, "stress_grip")).any():
        ax.plot(x, _along(run, "stress_grip"), color=colour, ls=":", lw=0.8)


def _picture(ax: Axes, run: xr.Dataset) -> None:
    last = last_snapshot(run, "disc_x")
    if last < 0:
        nothing(ax, "no snapshot")
        return
    draw_discs(ax, run, last, width=0.1)
    counts = draw_cracks(ax, run, width=0.8)
    (left, right), (bottom, top) = extent(run, last)
    margin = 0.03 * (top - bottom)
    frame(ax, (left - margin, right + margin), (bottom - margin, top + margin))
    handles = crack_legend(*counts)
    ax.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, columnspacing=1.0)


def draw_forces(ax: Axes, run: xr.Dataset, **style) -> None:
    """Cutting and thrust force of a cut over the travel of the tool."""
    for name, text in (("force_cutting", "$F_c$"), ("force_thrust", "$F_t$")):
        line(ax, run, "tool_travel", name, color=QUANTITY[name], label=text, **style)
    name_axes(ax, "tool_travel", "force on the tool [N/mm]")
