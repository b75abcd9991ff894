"""Nairn (2015), Fig. 7: moment and curvature of the chip, and the areas that enter the bending model."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import name_axes, page, styled
from orthocut.figures.palette import AMBER, BLACK, BLUE, SKY
from orthocut.params.mpm import MpmCutting
from orthocut.theory import beam, bending

CAPTION = (
    "Moment and curvature of a beam with linear hardening (Nairn 2015, eq. 20 and Fig. 7), drawn up to the curvature "
    "$k_0$ that the bending model gives for the default cut. $A_1$: released by the moment beyond the loading curve; "
    "$A_2$: dissipated, between loading and elastic unloading."
)


@styled
def draw(dataset: xr.Dataset | None = None) -> Figure:
    """Needs no runs; the dataset is ignored."""
    case = MpmCutting()
    found = bending.solve(case.material, case.interface, case.tool, case.cut_depth)
    r, top = bending.slope_ratio(case.material), found.curvature_ratio
    k = np.linspace(0, top, 600)
    loading = beam.moment(k, r)
    moment = float(loading[-1])
    returned = top - moment * 3 / 2
    unloading = np.clip((k - returned) * 2 / 3, 0, None)

    figure = page(2.5)
    ax = figure.subplots()
    ax.fill_between(k, loading, moment, color=SKY, alpha=0.45, lw=0)
    ax.fill_between(k, unloading, loading, color=AMBER, alpha=0.45, lw=0)
    ax.axhline(moment, color=BLACK, ls="--", lw=0.8)
    ax.plot(k, loading, color=BLUE, label="loading")
    ax.plot([returned, top], [0, moment], color=BLUE, ls="-.", label="elastic unloading")
    ax.plot(top, moment, "o", color=BLUE)
    ax.text(0.11 * top, 0.95 * moment, "$A_1$", va="top")
    ax.text(0.45 * top, 0.4 * moment, "$A_2$")
    ax.annotate(f"$k_0$ = {top:.2f}", (top, moment), (-4, 7), textcoords="offset points", ha="right")
    name_axes(ax, r"curvature $\kappa/\kappa_y$ [-]", r"moment $M/(bh^2\sigma_y/4)$ [-]")
    ax.set_xlim(0, 1.05 * top)
    ax.set_ylim(0, 1.25 * moment)
    ax.grid(False)
    ax.legend(loc="upper left", ncols=2)
    ax.set_title(
        rf"$h$ = {case.cut_depth * 1e3:.3g} mm, $\alpha$ = {math.degrees(case.tool.rake_angle):.3g}°, "
        rf"$E_T$ = {case.material.modulus_tangent * 1e-6:.3g} MPa",
        loc="right",
    )
    return figure
