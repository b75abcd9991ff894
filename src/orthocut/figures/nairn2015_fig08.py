"""Nairn (2015), Fig. 8: cutting force over depth of cut for several rake angles, perfectly plastic, frictionless."""

from __future__ import annotations

import math

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.forces_over_depth import SYMBOLS, draw_forces
from orthocut.figures.rubbing import FIT_ABOVE

CAPTION = (
    "Cutting force over depth of cut, both dimensionless, after Nairn (2015), Fig. 8: perfectly plastic, without "
    "friction. Dashed: the models of the paper, touching, eq. (15), up to the transition of the runs and beyond "
    "it bending as printed, eqs (18), (19), with the straight line through the rubbing forces of Fig. 10; dotted: "
    "the bending model at 30° for thinner cuts. Solid: bending with the chip in balance, which rubbing does not "
    "change. The paper sees a drop at a transition (30°: between 0.278 and 0.292), linear forces before it, and "
    "less agreement with the model after it. "
) + SYMBOLS
DIMS = ()


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    return draw_forces(
        dataset, touching_model=True, bending_model=True, rubbing_above=FIT_ABOVE, extended_rake=math.radians(30)
    )
