"""Nairn (2015), Fig. 5: snapshots of a cut, material points as deformed parallelograms shaded by stress."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.snapshots import draw_snapshots

CAPTION = (
    "Snapshots of a cut: each material point is drawn as the parallelogram into which it is deformed, shaded by "
    "equivalent stress, after Nairn (2015), Fig. 5. The tool moves to the left."
)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Up to six snapshots of the first run, evenly spaced, the last one included."""
    return draw_snapshots(dataset, count=6, columns=2)
