"""Runs of a sweep of ductile cuts, grouped by what makes them one series of a figure."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping

import xarray as xr

from orthocut.figures.canvas import cases
from orthocut.io.collect import case_of
from orthocut.theory.forces import depth_dimensionless

Group = tuple[float, float, float, float, str]


def group_of(run: xr.Dataset) -> Group:
    """Rake angle, friction, tangent modulus, cohesive stress and cohesive law of a run."""
    case = case_of(run)
    zone = case.interface
    return case.tool.rake_angle, case.tool.friction, case.material.modulus_tangent, zone.strength, zone.law


def grouped(dataset: xr.Dataset, *needed: str) -> dict[Group, list[xr.Dataset]]:
    """Series by rake angle, friction, tangent modulus, cohesive stress and law, in that order; each by depth of cut.

    Parameters
    ----------
    needed : str
        Variables that a run must hold.
    """
    groups = defaultdict(list)
    for run in cases(dataset, *needed, kind="mpm_cutting"):
        groups[group_of(run)].append(run)
    return {key: sorted(groups[key], key=cut_depth) for key in sorted(groups)}


def group_name(group: Group, groups: Mapping[Group, list[xr.Dataset]]) -> str:
    """What tells a series from the others of the figure; the rake angle where nothing does."""
    rake, friction, tangent, strength, law = group
    words = (
        rf"$\alpha$ = {math.degrees(rake):.3g}°",
        rf"$\mu$ = {friction:g}",
        rf"$E_T$ = {tangent * 1e-6:g} MPa",
        rf"$\sigma_c$ = {strength * 1e-6:g} MPa",
        law,
    )
    varied = [word for word, column in zip(words, zip(*groups, strict=True), strict=True) if len(set(column)) > 1]
    return ", ".join(varied) or words[0]


def cut_depth(run: xr.Dataset) -> float:
    """Depth of cut [m]."""
    return case_of(run).cut_depth


def dimensionless_depth(run: xr.Dataset) -> float:
    """Depth of cut in units of 2 E' Gc/sy^2 [-]."""
    case = case_of(run)
    return depth_dimensionless(
        case.cut_depth, case.material.stress_yield, case.material.modulus_plane_strain, case.interface.toughness
    )


def over_toughness(run: xr.Dataset, name: str = "force_cutting_mean") -> float:
    """Force of a run over its toughness [-]; NaN where the run lacks it."""
    return float(run[name]) / case_of(run).interface.toughness if name in run else math.nan


def touches(run: xr.Dataset) -> bool:
    """Whether the tool touched the crack tip."""
    return "touching" in run and float(run["touching"]) >= 0.5
