"""Cut with the tool at the crack tip: the chip yields wholly along one shear plane (Nairn 2015, eqs 13-15)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from orthocut.params.cohesive import CohesiveZone
from orthocut.params.material import ElasticPlastic
from orthocut.params.tool import Tool
from orthocut.theory.forces import NAN, Forces, depth_dimensionless, thrust, thrust_ratio

YIELD_RATIO = {"mises": math.sqrt(3.0), "tresca": 2.0}
"""Tensile over shear yield stress of a yield criterion."""


@dataclass(frozen=True)
class TouchingSolution(Forces):
    """Forces of the touching model."""

    angle_shear: float
    """Angle of the shear plane to the cut that needs the least force [rad]."""


def force_of_angle(
    angle_shear, cut_depth, rake_angle, friction, stress_yield, toughness, force_rubbing=0.0, criterion="mises"
):
    """Cutting force for any angle of the shear plane; the model takes the angle of the least force.

    Parameters
    ----------
    angle_shear : float
        Angle of the shear plane to the cut [rad].
    cut_depth, rake_angle, friction, stress_yield, toughness, force_rubbing, criterion
        As in `force_cutting`.

    Returns
    -------
    float
        Cutting force [N/m].

    Notes
    -----
    Nairn (2015), eq. (13), with the friction S on the chip eliminated by eq. (11).
    """
    stress_shear = stress_yield / YIELD_RATIO[criterion]
    cotangent = 1 / math.tan(angle_shear)
    strain = cotangent + math.tan(angle_shear - rake_angle)
    slide = math.sin(angle_shear) / math.cos(angle_shear - rake_angle)
    ratio = thrust_ratio(rake_angle, friction)
    force_friction = math.sin(rake_angle) + ratio * math.cos(rake_angle)
    chip = (stress_shear * strain * cut_depth + toughness) / (1 - force_friction * slide)
    return chip + friction * force_rubbing


def force_cutting(cut_depth, rake_angle, friction, stress_yield, toughness, force_rubbing=0.0, criterion="mises"):
    """Cutting force and angle of the shear plane.

    Parameters
    ----------
    cut_depth : float
        Depth of cut [m], > 0.
    rake_angle : float
        Rake angle [rad].
    friction : float
        Coulomb coefficient of the tool [-].
    stress_yield : float
        Tensile yield stress of the perfectly plastic material [Pa].
    toughness : float
        Fracture toughness [J/m^2].
    force_rubbing : float
        Normal force of rubbing below the tool [N/m].
    criterion : {"mises", "tresca"}
        Ratio of tensile to shear yield stress.

    Returns
    -------
    force, angle_shear : float
        Cutting force [N/m] and angle of the shear plane [rad].

    Notes
    -----
    Nairn (2015), eq. (14); eq. (15) without friction. The cotangent of the angle follows from the same minimisation.
    """
    plastic = stress_yield * cut_depth / YIELD_RATIO[criterion]
    ratio = thrust_ratio(rake_angle, friction)
    cotangent = ratio + math.sqrt(1 + ratio**2 + toughness * (ratio + math.tan(rake_angle)) / plastic)
    return toughness + friction * force_rubbing + 2 * plastic * cotangent, math.atan2(1.0, cotangent)


def solve(
    material: ElasticPlastic,
    interface: CohesiveZone,
    tool: Tool,
    cut_depth: float,
    force_rubbing: float = 0.0,
    criterion: str = "mises",
) -> TouchingSolution:
    """Forces of the touching model; hardening is ignored, the chip flows at the initial yield stress.

    Parameters
    ----------
    material, interface, tool
        Blocks of a case.
    cut_depth : float
        Depth of cut [m], > 0.
    force_rubbing : float
        Normal force of rubbing below the tool [N/m].
    criterion : {"mises", "tresca"}
        Ratio of tensile to shear yield stress.

    Returns
    -------
    TouchingSolution
        With NaN and a reason where the chip cannot slide on the rake face, or never yields.

    Raises
    ------
    ValueError
        If the depth of cut is not positive or the criterion is unknown.
    """
    if not cut_depth > 0:
        raise ValueError(f"cut_depth = {cut_depth!r} m must be positive")
    if criterion not in YIELD_RATIO:
        raise ValueError(f"criterion = {criterion!r} must be one of {', '.join(YIELD_RATIO)}")
    toughness, rake, friction = interface.toughness, tool.rake_angle, tool.friction
    depth = depth_dimensionless(cut_depth, material.stress_yield, material.modulus_plane_strain, toughness)
    if material.hardening == "none":
        reason = "the chip never yields with hardening = none"
        return TouchingSolution(NAN, NAN, NAN, NAN, depth, reason, NAN)
    if 1 + friction * math.tan(rake) <= 0:
        reason = (
            f"friction = {friction:g} holds the chip on a rake face of {math.degrees(rake):.4g} deg: it cannot slide"
        )
        return TouchingSolution(NAN, NAN, NAN, NAN, depth, reason, NAN)
    cutting, angle = force_cutting(
        cut_depth, rake, friction, material.stress_yield, toughness, force_rubbing, criterion
    )
    down = thrust(cutting, rake, friction, force_rubbing)
    return TouchingSolution(cutting, down, cutting / toughness, down / toughness, depth, "", angle)
