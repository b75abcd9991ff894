"""Case of a plate of glass with a central crack, pulled apart for its toughness."""

from __future__ import annotations

from typing import Annotated, Literal

from orthocut.params.dem import DemTension
from orthocut.params.quantity import Number


class DemToughness(DemTension):
    """Uniaxial tension of a specimen with a crack across its middle."""

    kind: Literal["dem_toughness"] = "dem_toughness"
    crack_ratio: Annotated[float, Number(0.05, 0.7)] = 0.3
    """Length of the crack over the width of the specimen."""

    @property
    def crack_length(self) -> float:
        """Length of the crack, from tip to tip [m]."""
        return self.crack_ratio * self.packing.width
