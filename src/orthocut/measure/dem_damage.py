"""Damage that a cut leaves below its surface."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from orthocut.measure.dem_cracks import CrackList

SHARE = 0.95
"""Share of the cracks below the cut that the robust depth covers."""


class Damage(NamedTuple):
    """Cracks that formed below the height of the tool tip."""

    depth: float
    """Depth of the deepest crack below the cut [m]; zero if there is none."""
    depth_most: float
    """Depth that all but a twentieth of these cracks keep to [m]; single cracks far from the tool hardly move it."""
    tension: int
    """Number of elements broken in tension."""
    shear: int
    """Number of elements broken in shear."""


def damage(found: CrackList, surface: float) -> Damage:
    """Depths and numbers of the cracks below a height.

    Parameters
    ----------
    found : CrackList
        All cracks, where they formed.
    surface : float
        Height of the surface that the cut should leave [m].
    """
    depth = surface - found.crack_y
    below = depth > 0
    if not below.any():
        return Damage(0.0, 0.0, 0, 0)
    shear = int(found.crack_mode[below].sum())
    return Damage(float(depth[below].max()), float(np.quantile(depth[below], SHARE)), int(below.sum()) - shear, shear)
