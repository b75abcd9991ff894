"""Nairn (2015), Fig. 14: cutting force over depth of cut for several cohesive stresses and laws, hardening."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.forces_over_depth import SYMBOLS, draw_forces

CAPTION = (
    "Cutting force over depth of cut, both dimensionless, for several cohesive stresses, after Nairn (2015), Fig. "
    "14: a tangent modulus of 100 MPa, a rake angle of 30°, without friction, the same toughness; triangles: "
    "triangular law. Black: bending model, which knows toughness alone, dashed as printed with the rubbing forces "
    "of the runs at 40 MPa, solid with the chip in balance. In the paper the cohesive stress takes runs from "
    "above the model to below it. "
) + SYMBOLS
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    return draw_forces(dataset, bending_model=True, one_model=True)
