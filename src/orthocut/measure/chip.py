"""Shape of a chip from the deformation of its points."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np


class Chip(NamedTuple):
    """What a chip has become of the strip that it was."""

    thickness_ratio: float
    """Thickness of the chip over the depth of cut [-]; NaN if there is no chip yet."""
    angle_shear: float
    """Angle of the shear plane that gives this thickness [rad]."""
    shear_largest: float
    """Largest engineering shear strain of lines that were along and across the cut, 99th percentile [-]."""


def shape(start_x: np.ndarray, deformation: np.ndarray, tip: float, depth: float, rake_angle: float) -> Chip:
    """Thickness and shear of the chip that left the tool tip between one and three depths of cut ago.

    Parameters
    ----------
    start_x : float array, shape (n,)
        Where the points of the chip were along the cut before it [m]; the tool moves towards -x.
    deformation : float array, shape (n, 4)
        Deformation gradients (xx, xy, yx, yy).
    tip : float
        Place of the tool tip along the cut [m].
    depth : float
        Depth of cut [m].
    rake_angle : float
        Rake angle [rad].

    Notes
    -----
    Volume is kept, so that a chip gets thicker as its lines along the cut get shorter, by sin(phi)/cos(phi - alpha) for
    a shear plane at the angle phi (Merchant 1945, J. Appl. Phys. 16, 267).
    """
    behind = start_x - tip
    stretch_x = np.hypot(deformation[:, 0], deformation[:, 2])
    recent = (behind > depth) & (behind < 3.0 * depth)
    if not recent.any():
        return Chip(math.nan, math.nan, math.nan)
    ratio = float(stretch_x[recent].mean())
    cross = (deformation[:, 0] * deformation[:, 1] + deformation[:, 2] * deformation[:, 3])[recent]
    across = np.hypot(deformation[:, 1], deformation[:, 3])[recent]
    shear = np.abs(np.tan(np.arcsin(np.clip(cross / (stretch_x[recent] * across), -1.0, 1.0))))
    angle = math.atan2(ratio * math.cos(rake_angle), 1.0 - ratio * math.sin(rake_angle))
    return Chip(1.0 / ratio, angle, float(np.percentile(shear, 99)))
