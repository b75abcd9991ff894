"""Yang et al. (2018), Fig. 7: uniaxial tension."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import styled
from orthocut.figures.specimen import strength_test

CAPTION = (
    "Uniaxial tension of the synthetic glass specimen: cracks at the end of the test and stress-strain curves, after "
    "Yang et al. (2018), Fig. 7. Strain in the measurement region. Solid: stress in the measurement region; "
    "dotted: from the reaction of the grips; circles: strength. Dashed: modulus and strength of "
    "the paper's model (Table 2); it has 240 broken elements at the end, of unknown number per joint."
)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Specimen of the first replicate, curves of all."""
    return strength_test(dataset, "dem_tension", "tension positive")
