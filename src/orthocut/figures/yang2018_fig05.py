"""Yang et al. (2018), Fig. 5: the packing of discs."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.palette import DISC_FACE, ORANGE
from orthocut.figures.scene import draw_discs
from orthocut.figures.specimen import magnified

CAPTION = (
    "Packing of the synthetic glass specimen and, magnified, a part of it, to scale, after Yang et al. (2018), Fig. 5. "
    "Discs without any joint are orange. The specimen of the paper has 7406 discs."
)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Specimen of the first run, before loading."""
    return magnified(dataset, _paint)


def _paint(ax, run: xr.Dataset, closer: bool) -> None:
    joined = np.concatenate([run["bond_first"].values, run["bond_second"].values])
    joined = joined[np.isfinite(joined) & (joined >= 0)].astype(int)
    floating = np.setdiff1d(np.arange(run.sizes["disc"]), joined)
    face = np.full(run.sizes["disc"], DISC_FACE, object)
    face[floating] = ORANGE
    draw_discs(ax, run, 0, face=face, width=0.7 if closer else 0.12)
    if not closer:
        count = int(np.isfinite(run["disc_radius"].values).sum())
        floaters = int(np.isfinite(run["disc_radius"].values[floating]).sum())
        ax.set_title(f"{count} discs, {floaters} without joints", loc="left")
