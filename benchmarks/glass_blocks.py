"""Blocks of glass side by side as a scene of any size: one is packed, the others are its copies."""

from __future__ import annotations

import numpy as np

from orthocut.dem.packing import pack
from orthocut.dem.setup import build
from orthocut.dem.state import Scene
from orthocut.params.dem import DemCutting, FlatJoint

GAP = 1.2
"""Distance of the corners of neighbouring blocks over their side."""


def glass_blocks(blocks: int, width: float = 1.0) -> Scene:
    """Square of blocks that are pulled apart slowly.

    Parameters
    ----------
    blocks : int
        Blocks along either side.
    width : float
        Width of a block over that of the paper's.
    """
    usual = DemCutting().packing
    packed = pack(usual.model_copy(update={"width": width * usual.width}))
    shifts = GAP * usual.width * np.mgrid[:blocks, :blocks].reshape(2, -1)
    x, y = ((one[:, None] + own).ravel() for one, own in zip(shifts, (packed.x, packed.y), strict=True))
    scene = build(x, y, np.tile(packed.radius, blocks**2), FlatJoint())
    scene.speeds[:, 0] = 1e-2 * (x / usual.width - 0.5)
    return scene
