"""Balance of forces on the chip, and the result of a cutting model.

Forces act on the tool for unit width [N/m]: cutting positive along the motion of the tool, thrust positive into the
workpiece. The rubbing force presses the clearance face onto the finished surface.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

NAN = math.nan


@dataclass(frozen=True)
class Forces:
    """What a model predicts for one cut; NaN where it has no solution."""

    force_cutting: float
    """Cutting force [N/m]."""
    force_thrust: float
    """Thrust force [N/m]."""
    force_over_toughness: float
    """Cutting force over toughness, Fc/(b Gc) [-]."""
    thrust_over_toughness: float
    """Thrust force over toughness, Ft/(b Gc) [-]."""
    depth_dimensionless: float
    """Dimensionless depth of cut, h sy^2/(2 E' Gc) [-]."""
    reason: str
    """Why there is no solution; empty when there is one."""


def thrust_ratio(rake_angle, friction):
    """Thrust over cutting force of a chip that slides on the rake face, tan(atan(friction) - rake_angle).

    Parameters
    ----------
    rake_angle : float
        Rake angle [rad].
    friction : float
        Coulomb coefficient of tool and chip [-].

    Returns
    -------
    float
        Z [-]; negative when the tool lifts the chip.

    Notes
    -----
    Nairn (2015), eq. (12).
    """
    slope = math.tan(rake_angle)
    return (friction - slope) / (1 + friction * slope)


def depth_dimensionless(cut_depth, stress_yield, modulus_plane_strain, toughness):
    """Depth of cut in units of 2 E' Gc/sy^2 [-]; scaling of Williams et al., used in Nairn (2015), Fig. 8."""
    return cut_depth * stress_yield**2 / (2 * modulus_plane_strain * toughness)


def thrust(force_cutting, rake_angle, friction, force_rubbing):
    """Thrust force [N/m] from the cutting force: Nairn (2015), eqs (11), (12).

    The chip feels the force of the tool without rubbing, ``force_cutting - friction force_rubbing``.
    """
    return thrust_ratio(rake_angle, friction) * (force_cutting - friction * force_rubbing) + force_rubbing
