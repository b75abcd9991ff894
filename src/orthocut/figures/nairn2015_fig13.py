"""Nairn (2015), Fig. 13: cutting force over depth of cut for several rake angles, hardening."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.forces_over_depth import SYMBOLS, draw_forces

CAPTION = (
    "Cutting force over depth of cut, both dimensionless, for several rake angles, after Nairn (2015), Fig. 13: a "
    "tangent modulus of 100 MPa, without friction. Dashed: bending model as printed, eqs (18), (19), with a "
    "straight line through the rubbing forces of the runs that bend; solid: with the chip in balance, which "
    "rubbing does not change. The paper finds all runs bending, 10-90 % above the printed model, and no peak such "
    "as the model has. "
) + SYMBOLS
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    return draw_forces(dataset, bending_model=True)
