"""Cohesive zone along the cutting path."""

from __future__ import annotations

from typing import Annotated, Literal

from orthocut.params.block import Block
from orthocut.params.quantity import Quantity


class CohesiveZone(Block):
    """Traction-separation law, the same in mode I and mode II (Nairn 2015, eqs 3, 4)."""

    law: Literal["cubic"] = "cubic"
    """Shape of the law."""
    strength: Annotated[float, Quantity("Pa", "1 MPa", "400 MPa", "MPa")] = 40e6
    """Cohesive stress, the largest traction of the law."""
    toughness: Annotated[float, Quantity("J/m^2", "1 J/m^2", "1 MJ/m^2")] = 2000.0
    """Area under the law."""

    @property
    def opening_critical(self) -> float:
        """Opening at which the traction vanishes [m]."""
        return 16 * self.toughness / (9 * self.strength)

    @property
    def stiffness(self) -> float:
        """Slope of the law at zero opening [Pa/m]."""
        return 6.75 * self.strength / self.opening_critical
