"""The rigid wedge tool."""

from __future__ import annotations

import math
from typing import Annotated

from pydantic import model_validator

from orthocut.params.block import Block, fault
from orthocut.params.quantity import Number, Quantity

Angle = Annotated[float, Quantity("rad", "-45 deg", "70 deg", "deg")]


class Tool(Block):
    """Two flat faces that meet in a sharp tip; the faces are as long as the cut needs."""

    rake_angle: Angle = 0.523598775598299
    """Angle of the rake face to the normal of the cut; positive when the face leans away from the uncut material."""
    clearance_angle: Annotated[float, Quantity("rad", "0 deg", "45 deg", "deg")] = 0.0872664625997165
    """Angle of the clearance face to the cut."""
    friction: Annotated[float, Number(0.0, 1.5)] = 0.0
    """Coulomb coefficient between tool and workpiece."""

    @model_validator(mode="after")
    def _wedge(self) -> Tool:
        wedge = 90.0 - (self.rake_angle + self.clearance_angle) * math.degrees(1.0)
        if wedge < 5.0 - 1e-9:
            raise fault(f"rake_angle and clearance_angle leave a wedge of {wedge:.3g} deg (allowed: 5 deg or more)")
        return self
