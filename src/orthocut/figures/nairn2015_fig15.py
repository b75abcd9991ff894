"""Nairn (2015), Fig. 15: cutting force over depth of cut for several coefficients of friction, weak interface."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.forces_over_depth import SYMBOLS, draw_forces

CAPTION = (
    "Cutting force over depth of cut, both dimensionless, for several coefficients of friction, after Nairn (2015), "
    "Fig. 15: as Fig. 11, but with a cohesive stress of 10 MPa instead of 40 MPa. Dashed: the models of the paper with "
    "the rubbing forces of the runs, touching, eq. (14), up to the transition and beyond it bending as printed, eqs "
    "(18), (19); solid: bending with the chip in balance. The paper sees the transition at thinner cuts, and forces "
    "nearer to the bending model. "
) + SYMBOLS
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    return draw_forces(dataset, touching_model=True, bending_model=True)
