"""When a tool is in contact, and mean forces over the whole travel and while it is."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from orthocut.measure.steady import block_mean

AIR = 0.01
"""Resultant force over its root mean square below which the tool is in the air."""
BLOCKS = (4, 10)
"""Fewest and most blocks for the standard error of a mean."""


class Force(NamedTuple):
    """One component of the force on a tool, from means over equal parts of its travel."""

    mean: float
    """Over the travel [N/m]."""
    error: float
    """Standard error of that mean, from blocks at least a depth of cut long where the travel allows [N/m]."""
    contact: float
    """Mean over the parts of the travel in contact [N/m]; NaN if there are none."""
    rms: float
    """Root mean square [N/m]."""


def touching(cutting: np.ndarray, thrust: np.ndarray) -> np.ndarray:
    """Parts of the travel in which the tool is in contact; bool, shape (n_samples,).

    Parameters
    ----------
    cutting, thrust : float arrays, shape (n_samples,)
        Forces [N/m], as means over equal parts of the travel.
    """
    resultant = np.hypot(cutting, thrust)
    return resultant > AIR * math.sqrt(float(np.mean(resultant**2)))


def reduce(force: np.ndarray, contact: np.ndarray, travel: float, depth: float) -> Force:
    """Means of one component.

    Parameters
    ----------
    force : float array, shape (n_samples,)
        [N/m].
    contact : bool array, shape (n_samples,)
        As `touching` gives it.
    travel, depth : float
        Travel of the tool and depth of cut [m]; chips are about as long as the cut is deep, and so are the stretches
        over which the force is correlated.
    """
    blocks = min(max(int(travel / depth * (1 + 1e-9)), BLOCKS[0]), BLOCKS[1])
    mean = block_mean(force, blocks)
    held = float(force[contact].mean()) if contact.any() else math.nan
    return Force(mean.value, mean.error, held, math.sqrt(float(np.mean(force**2))))
