"""Cohesive zone along the cutting path."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import model_validator

from orthocut.params.block import Block, refuse_unused
from orthocut.params.quantity import Number, Quantity


class CohesiveZone(Block):
    """Traction-separation law, the same in mode I and mode II (Nairn 2015, eqs 3, 4), and when it fails."""

    law: Literal["cubic", "triangular"] = "cubic"
    """Traction over opening: cubic, or triangular (a straight rise and a straight fall)."""
    peak_ratio: Annotated[float, Number(0.02, 0.9)] = 0.1
    """triangular: opening at the largest traction over the opening at which the traction vanishes."""
    failure_criterion: Literal["area", "dissipated", "coupled"] = "area"
    """What adds up to the toughness at failure: area under the law in both modes, or energy dissipated in both modes;
    coupled is one damage of both modes, by the effective opening."""
    strength: Annotated[float, Quantity("Pa", "1 MPa", "400 MPa", "MPa")] = 40e6
    """Cohesive stress, the largest traction of the law."""
    toughness: Annotated[float, Quantity("J/m^2", "1 J/m^2", "1 MJ/m^2")] = 2000.0
    """Area under the law."""

    @model_validator(mode="after")
    def _used(self) -> CohesiveZone:
        refuse_unused(self, "law", {"cubic": (), "triangular": ("peak_ratio",)})
        return self

    @property
    def opening_critical(self) -> float:
        """Opening at which the traction vanishes [m]."""
        if self.law == "triangular":
            return 2 * self.toughness / self.strength
        return 16 * self.toughness / (9 * self.strength)

    @property
    def stiffness(self) -> float:
        """Slope of the law at zero opening [Pa/m]."""
        if self.law == "triangular":
            return self.strength / (self.peak_ratio * self.opening_critical)
        return 6.75 * self.strength / self.opening_critical
