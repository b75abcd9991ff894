"""The depth of cut at which the tool loses the crack tip: where a series of runs turns from touching to bending."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

NOTCH_LONG = 4.0
"""Length of the notch over depth of cut from which a cut starts with a bent chip, not with a touching tool."""


class Transition(NamedTuple):
    """Two neighbouring depths of cut between which the regime changes."""

    low: float
    """Deepest cut that touches [m]; 0 where all bend."""
    high: float
    """Shallowest cut that bends [m]; infinite where all touch."""
    strays: int
    """Runs of the other regime on either side."""

    @property
    def found(self) -> bool:
        """Whether both regimes are there."""
        return self.low > 0 and math.isfinite(self.high)

    @property
    def middle(self) -> float:
        """Middle of the interval [m]; NaN where only one regime is there."""
        return 0.5 * (self.low + self.high) if self.found else math.nan

    @property
    def half_width(self) -> float:
        """Half of the interval [m]; NaN where only one regime is there."""
        return 0.5 * (self.high - self.low) if self.found else math.nan

    @property
    def standard_error(self) -> float:
        """Standard deviation of a depth that may be anywhere in the interval with the same chance [m]."""
        return self.half_width / math.sqrt(3.0)


def transition(cuts: Sequence[tuple[float, bool]]) -> Transition:
    """Depth of cut that parts touching from bending cuts with the fewest strays; of equal ones the shallowest.

    Parameters
    ----------
    cuts : sequence of (float, bool)
        Depth of cut [m] and whether the tool touches the crack tip, in any order.
    """
    cuts = sorted(cuts)
    strays = [
        sum(not touching for _, touching in cuts[:split]) + sum(touching for _, touching in cuts[split:])
        for split in range(len(cuts) + 1)
    ]
    split = strays.index(min(strays))
    low = cuts[split - 1][0] if split else 0.0
    high = cuts[split][0] if split < len(cuts) else math.inf
    return Transition(low, high, strays[split])
