"""Yang et al. (2018), Fig. 8: unconfined compression."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.specimen import strength_test

CAPTION = (
    "Unconfined compression of the synthetic glass specimen: cracks at the end of the test and stress-strain curves, "
    "after Yang et al. (2018), Fig. 8. Strain in the measurement region. Solid: stress in the measurement region; "
    "dotted: from the reaction of the platens; circles: strength. Dashed: modulus and strength of "
    "the paper's model (Table 2); it has 8070 broken elements at the end, of unknown number per joint."
)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Specimen of the first replicate, curves of all; compression is drawn positive."""
    return strength_test(dataset, "dem_compression", "compression positive")
