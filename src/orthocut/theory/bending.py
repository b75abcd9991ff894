"""Cut with a gap between tool and crack tip: the chip bends off elastically or plastically (Nairn 2015, eqs 16-22)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from scipy.optimize import brentq

from orthocut.params.cohesive import CohesiveZone
from orthocut.params.material import ElasticPlastic
from orthocut.params.tool import Tool
from orthocut.theory.beam import area_complementary, area_dissipated
from orthocut.theory.forces import NAN, Forces, depth_dimensionless, thrust, thrust_ratio

ROOT_ROTATION = 0.64
"""Correction chi for the rotation at the root of the chip (Nairn 2015, below eq. 17)."""

CURVATURE_MAX = 1e9
"""Curvature ratio beyond which a chip counts as not bendable."""

FORMS = ("paper", "consistent")
SLOPES = ("tangent", "literal")


@dataclass(frozen=True)
class BendingSolution(Forces):
    """Forces of the bending model."""

    curvature_ratio: float
    """Curvature of the chip over its curvature at first yield, k0 [-]."""


def slope_ratio(material: ElasticPlastic, slope: str = "tangent") -> float:
    """Slope of the chip's fibres after yielding over E' [-].

    Parameters
    ----------
    material : ElasticPlastic
        Material of the chip.
    slope : {"tangent", "literal"}
        ``tangent``: E_T/E', the slope of the stress-strain curve, which eqs (20)-(22) need. ``literal``: E_p/E' with
        the plastic modulus, as the symbol in the paper says.

    Raises
    ------
    ValueError
        If the slope is unknown or the material does not harden linearly.
    """
    if material.hardening != "linear":
        raise ValueError(f"hardening = {material.hardening!r} must be linear")
    if slope not in SLOPES:
        raise ValueError(f"slope = {slope!r} must be one of {', '.join(SLOPES)}")
    modulus = material.modulus_tangent if slope == "tangent" else material.modulus_plastic
    return modulus / material.modulus_plane_strain


def solve(
    material: ElasticPlastic,
    interface: CohesiveZone,
    tool: Tool,
    cut_depth: float,
    force_rubbing: float = 0.0,
    form: str = "consistent",
    slope: str = "tangent",
    root_rotation: float = ROOT_ROTATION,
) -> BendingSolution:
    """Forces and curvature of the chip.

    Parameters
    ----------
    material, interface, tool
        Blocks of a case.
    cut_depth : float
        Depth of cut [m], > 0.
    force_rubbing : float
        Normal force of rubbing below the tool [N/m].
    form : {"paper", "consistent"}
        ``paper``: eqs (18), (19) as printed, which load the chip with the rubbing force too. ``consistent``: the chip
        feels the force of the tool without rubbing, as eq. (11) says. Without rubbing they are the same.
    slope : {"tangent", "literal"}
        See `slope_ratio`.
    root_rotation : float
        Correction chi for the rotation at the root of the chip [-].

    Returns
    -------
    BendingSolution
        With NaN and a reason where the equations have no solution.

    Notes
    -----
    Nairn (2015), eqs (16)-(22); eq. (17) lacks a multiplication sign: [Ft/(b Gc)] (2 chi sy k0/E') = A1/(b Gc) - 1.
    """
    if not cut_depth > 0:
        raise ValueError(f"cut_depth = {cut_depth!r} m must be positive")
    if form not in FORMS:
        raise ValueError(f"form = {form!r} must be one of {', '.join(FORMS)}")
    toughness, modulus = interface.toughness, material.modulus_plane_strain
    rake, friction = tool.rake_angle, tool.friction
    depth = depth_dimensionless(cut_depth, material.stress_yield, modulus, toughness)
    ratio = thrust_ratio(rake, friction)

    def unsolved(reason: str) -> BendingSolution:
        return BendingSolution(NAN, NAN, NAN, NAN, depth, reason, NAN)

    if material.hardening != "linear":
        return unsolved(f"it knows linear hardening only, not hardening = {material.hardening}")
    hardening = slope_ratio(material, slope)
    if ratio >= 0:
        return unsolved(
            f"friction = {friction:g} is not below tan(rake_angle) = {math.tan(rake):.4g}: "
            "the tool does not lift the chip (Z >= 0)"
        )
    share = 1 - math.sin(rake) - ratio * math.cos(rake)
    leverage = 2 * root_rotation * material.stress_yield / modulus
    rubbing = (1 - friction * ratio) * force_rubbing / toughness if form == "paper" else 0.0

    def imbalance(k: float) -> float:
        lift = ratio * (1 + depth * area_dissipated(k, hardening)) + rubbing * (1 - math.sin(rake))
        return float(depth * area_complementary(k, hardening) - 1 - leverage * k * lift / share)

    high = 1.0
    while imbalance(high) < 0:
        high *= 2
        if high > CURVATURE_MAX:
            return unsolved("the energy released in bending never reaches the toughness, at any curvature of the chip")
    k0 = brentq(imbalance, 0.0, high, xtol=1e-13, rtol=1e-14)

    chip = (1 + depth * float(area_dissipated(k0, hardening)) + rubbing * math.cos(rake)) / share
    cutting = toughness * chip + (friction * force_rubbing if form == "consistent" else 0.0)
    down = thrust(cutting, rake, friction, force_rubbing)
    return BendingSolution(cutting, down, cutting / toughness, down / toughness, depth, "", k0)
