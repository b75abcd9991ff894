"""One set of joint parameters tried on all packings: its cases, and what they measured."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
import xarray as xr

from orthocut.params.calibration import DemCalibration
from orthocut.params.dem import DemCompression, DemTension, FlatJoint

FITTED = ("modulus", "stiffness_ratio", "strength_tensile", "cohesion")
"""Fields of the joint that are fitted."""
REACHED = ("modulus_young", "ratio_poisson", "strength_tension", "strength_compression")
"""Properties to reach, in the order of the parameters that move them most."""
DIGITS = 4
"""Significant digits of fitted parameters: what is printed is what was simulated."""
_RATIO = (1.05, 9.95)  # the search may not leave the range of the stiffness ratio

Test = DemTension | DemCompression
Simulate = Callable[[Sequence[Test]], list[xr.Dataset]]
"""Takes cases, gives their results in the same order."""


class Trial(NamedTuple):
    """Outcome of one set of parameters."""

    purpose: str
    """``search`` or ``slope``."""
    parameters: np.ndarray
    """(4,) in the order of `FITTED`, SI."""
    properties: np.ndarray
    """(n_packings, 4) in the order of `REACHED`, SI."""


def start_of(calibration: DemCalibration) -> np.ndarray:
    """Parameters to start from, shape (4,)."""
    return np.array([getattr(calibration.joint, name) for name in FITTED])


def goal_of(calibration: DemCalibration) -> np.ndarray:
    """Properties to reach, shape (4,)."""
    return np.array([getattr(calibration, name) for name in REACHED])


def rounded(parameters: np.ndarray) -> np.ndarray:
    """Parameters with few digits and in range."""
    kept = [float(f"{value:.{DIGITS}g}") for value in parameters]
    kept[1] = min(max(kept[1], _RATIO[0]), _RATIO[1])
    return np.array(kept)


def joint_of(calibration: DemCalibration, parameters: np.ndarray) -> FlatJoint:
    """Joint with these parameters, all else as in the one to start from."""
    return calibration.joint.model_copy(update=dict(zip(FITTED, parameters.tolist(), strict=True)))


def cases_of(calibration: DemCalibration, parameters: np.ndarray) -> list[Test]:
    """Tension and compression of every packing, one packing after the other."""
    joint = joint_of(calibration, parameters)
    cases: list[Test] = []
    for k in range(calibration.replicates):
        packing = calibration.packing.model_copy(update={"seed": calibration.packing.seed + k})
        speeds = calibration.speed_tension, calibration.speed_compression
        cases.append(DemTension().model_copy(update={"packing": packing, "joint": joint, "grip_speed": speeds[0]}))
        crush = {"packing": packing, "joint": joint, "grip_speed": speeds[1]}
        cases.append(DemCompression().model_copy(update=crush | {"friction_platen": calibration.friction_platen}))
    return cases


def attempt(calibration: DemCalibration, parameters: np.ndarray, purpose: str, simulate: Simulate) -> Trial:
    """Simulate all cases of one set of parameters."""
    runs = simulate(cases_of(calibration, parameters))
    rows = [
        [*(float(pull[name]) for name in ("modulus_young", "ratio_poisson", "strength_ultimate")), _strength(crush)]
        for pull, crush in zip(runs[::2], runs[1::2], strict=True)
    ]
    return Trial(purpose, parameters, np.array(rows))


def _strength(run: xr.Dataset) -> float:
    return float(run["strength_ultimate"])
