"""Nairn (2015), Fig. 11: cutting force over depth of cut for several coefficients of friction, perfectly plastic."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.forces_over_depth import SYMBOLS, draw_forces

CAPTION = (
    "Cutting force over depth of cut, both dimensionless, for several coefficients of friction, after Nairn "
    "(2015), Fig. 11: perfectly plastic, a rake angle of 30°. Dashed: the models of the paper with the rubbing "
    "forces of the runs, touching, eq. (14), up to the transition and beyond it bending as printed, eqs (18), "
    "(19); solid: bending with the chip in balance. Bending has no solution where friction exceeds the tangent of "
    "the rake angle, 0.577. The paper sees agreement before the transition, and that friction moves it to thicker "
    "cuts. "
) + SYMBOLS
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    return draw_forces(dataset, touching_model=True, bending_model=True)
