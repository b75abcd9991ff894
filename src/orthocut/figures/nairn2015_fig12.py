"""Nairn (2015), Fig. 12: cutting force over depth of cut for several tangent moduli."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.forces_over_depth import SYMBOLS, draw_forces

CAPTION = (
    "Cutting force over depth of cut, both dimensionless, for several tangent moduli, after Nairn (2015), Fig. "
    "12: a rake angle of 30°, without friction. Dotted lines join the runs of a series and are no model. The "
    "paper sees that hardening moves the transition to thinner cuts, and that at 25 MPa its drop is nearly gone. "
) + SYMBOLS
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    return draw_forces(dataset, joined=True)
