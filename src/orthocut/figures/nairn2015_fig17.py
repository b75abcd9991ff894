"""Nairn (2015), Fig. 17: snapshots of a long cut whose chip curls up."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.snapshots import draw_snapshots

CAPTION = (
    "Snapshots of a long cut, after Nairn (2015), Fig. 17: depth of cut 0.5 mm, rake angle 15°, tangent modulus 100 "
    "MPa, where the chip curls over and reaches the surface, to which it sticks, as points of one body do that share a "
    "grid. Each material point is drawn as the parallelogram into which it is deformed, shaded by equivalent stress. "
    "The tool moves to the left."
)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Up to four snapshots of the first run, evenly spaced, the last one included."""
    return draw_snapshots(dataset, count=4, columns=1)
