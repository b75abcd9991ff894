"""Fields of material points for people to look at."""

from __future__ import annotations

from typing import Any

import numpy as np

from orthocut.kernels.mpm import layout, step
from orthocut.mpm.state import State


def snapshot(state: State) -> dict[str, tuple[tuple[str, ...], Any]]:
    """Positions, deformation, equivalent Cauchy stress and plastic strain of all points now.

    Returns
    -------
    dict of str to (dims, values)
    """
    fxx, fxy, fyx, fyy = (state.field(f) for f in (layout.FXX, layout.FXY, layout.FYX, layout.FYY))
    bxx, byy, bxy = (state.field(f) for f in (layout.BXX, layout.BYY, layout.BXY))
    bzz = 1.0 / (bxx * byy - bxy**2)
    third = (bxx + byy + bzz) / 3.0
    square = (bxx - third) ** 2 + (byy - third) ** 2 + (bzz - third) ** 2 + 2.0 * bxy**2
    volume_ratio = fxx * fyy - fxy * fyx
    return {
        "time_snapshot": ((), state.totals[step.TIME]),
        "tool_tip_snapshot": ((), state.totals[step.TIP]),
        "point_x": (("point",), state.field(layout.X)),
        "point_y": (("point",), state.field(layout.Y)),
        "point_deformation": (("point", "component"), np.stack([fxx, fxy, fyx, fyy], axis=-1)),
        "point_stress": (("point",), state.solid.modulus_shear * np.sqrt(1.5 * square) / volume_ratio),
        "point_strain_plastic": (("point",), state.field(layout.EPS)),
    }
