"""Yang et al. (2018), Fig. 6: the network of joints."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.palette import BLUE
from orthocut.figures.scene import draw_bonds, draw_discs
from orthocut.figures.specimen import magnified

CAPTION = (
    "Network of flat joints in the synthetic glass specimen, as lines between the centres of joined discs, and, "
    "magnified, a part of it, after Yang et al. (2018), Fig. 6."
)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Joints of the first run, before loading."""
    return magnified(dataset, _paint)


def _paint(ax, run: xr.Dataset, closer: bool) -> None:
    if closer:
        draw_discs(ax, run, 0, width=0.6)
    count = draw_bonds(ax, run, 0, colors=BLUE, linewidths=1.2 if closer else 0.25)
    if not closer:
        ax.set_title(f"{count} joints", loc="left")
