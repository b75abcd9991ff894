"""Nairn (2015), Fig. 3B: cutting force over particle size, and the share of the work that the transfers lose."""

from __future__ import annotations

from collections import defaultdict

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import cases, nothing, page, styled, values
from orthocut.figures.extrapolation import extrapolate
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.sweep import over_toughness, touches
from orthocut.figures.symbols import draw_force, draw_limit
from orthocut.figures.varied import transfers
from orthocut.io.collect import case_of
from orthocut.theory import bending, touching

CAPTION = (
    "Cutting force over particle size, after Nairn (2015), Fig. 3B, and the share of the tool's work in the second "
    "half of the cut that transfers between points and grid lose. Circles: points hand on a share of the velocity "
    "gradient; squares: none of it (PIC, as in the paper). Bars: standard error of the mean; pale bars: half of the "
    "drift over the window to either side. Dashed: weighted straight fits; their ends at zero (diamonds, with standard "
    "errors) are estimates of the converged force, and the distance between those of both schemes shows how sure they "
    "are. Triangles on the axis: the model of the regime, eq. (15) or bending. Open symbols: the tool touches the "
    "crack tip. Crosses on the axis: failed runs. The paper has the force of its 0.9 mm cut decline with particle "
    "size."
)
DIMS = ("sample",)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour for each depth of cut and tangent modulus, one symbol for each scheme of transfers."""
    figure = page(4.4)
    force, loss = figure.subplots(2, sharex=True)
    force.set_ylabel("force $F_c/(bG_c)$ [-]")
    loss.set_ylabel("work lost in transfers [%]")
    loss.set_xlabel("particle size over depth of cut $1/n$ [-]")
    groups = defaultdict(list)
    for run in cases(dataset, "force_cutting_mean", kind="mpm_cutting"):
        case = case_of(run)
        groups[case.cut_depth, case.material.modulus_tangent, case.numerics.affine].append(run)
    for ax in (force, loss):
        mark(ax, [1.0 / case_of(run).numerics.points_per_depth for run in failed(dataset, "mpm_cutting")])
    if not groups:
        nothing(force)
        return figure

    scenes = sorted({group[:2] for group in groups})
    for (depth, tangent, affine), runs in sorted(groups.items()):
        colour, symbol = (SERIES * 9)[scenes.index((depth, tangent))], "o" if affine else "s"
        sizes = np.array([1.0 / case_of(run).numerics.points_per_depth for run in runs])
        for run, size in zip(runs, sizes, strict=True):
            draw_force(force, run, size, colour, symbol)
            loss.plot(size, _share_lost(run), symbol, color=colour, mfc="white" if touches(run) else colour)
        if len(runs) > 2 and len(set(sizes)) > 1:
            errors = [over_toughness(run, "force_cutting_error") for run in runs]
            fit = extrapolate(sizes, [over_toughness(run) for run in runs], errors)
            ends = np.array([0.0, sizes.max()])
            force.plot(ends, fit.at(ends), color=colour, lw=0.8, ls="--")
            draw_limit(force, fit.limit, fit.error, colour)
        force.plot(0.0, _model(runs[0]), marker=5, color=colour, clip_on=False)
    for colour, (depth, tangent) in zip(SERIES * 9, scenes, strict=False):
        name = f"$h$ = {depth * 1e3:g} mm, $E_T$ = {tangent * 1e-6:g} MPa"
        force.plot([], [], ls="", marker="o", color=colour, label=name)
    for affine in sorted({group[2] for group in groups}):
        name = transfers(affine)
        force.plot([], [], ls="", marker="o" if affine else "s", color="0.25", label=name)
    force.set_xlim(left=min(force.get_xlim()[0], 0))
    force.set_ylim(bottom=0)
    loss.set_ylim(bottom=0)
    figure.legend(handles=force.get_legend_handles_labels()[0], loc="outside upper center", ncols=2)
    return figure


def _model(run: xr.Dataset) -> float:
    """Force over toughness of the touching or of the bending model, as the run has it."""
    case = case_of(run)
    model = touching if touches(run) else bending
    return model.solve(case.material, case.interface, case.tool, case.cut_depth).force_over_toughness


def _share_lost(run: xr.Dataset) -> float:
    """Energy lost in transfers over the work of the tool, in the second half of the run [%]."""
    work, lost = values(run, "work_tool"), values(run, "energy_numerical")
    good = np.isfinite(work) & np.isfinite(lost)
    work, lost = work[good], lost[good]
    half = work.size // 2
    return 100.0 * (lost[-1] - lost[half]) / (work[-1] - work[half]) if half else np.nan
