"""Search for joint parameters that give the properties of a material, and how well the packings fix them.

Parameters and properties are taken as logarithms over their start and their goal. Then each property follows mainly one
parameter, about in proportion (modulus to Young's modulus, stiffness ratio to Poisson's ratio, tensile strength and
cohesion of joints to those of the specimen), and the spectral residual method DF-SANE of scipy (La Cruz, Martinez and
Raydan 2006), which takes steps along the deviations themselves and needs no derivatives, gets there in few evaluations.
All of them use the same packings, so that a change of the outcome comes from the parameters alone.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.optimize import root

from orthocut.calibration.trial import FITTED, Simulate, Trial, attempt, goal_of, rounded, start_of
from orthocut.params.calibration import DemCalibration


class Fit(NamedTuple):
    """Result of a calibration."""

    trials: list[Trial]
    """All evaluations, in the order they were made."""
    best: int
    """Index of the fitted set."""
    converged: bool
    """Whether every property is within the tolerance."""
    slopes: np.ndarray
    """(4, 4) relative change of each property (rows) over that of each parameter, around the fitted set. NaN if
    not asked for, as are spread and error."""
    spread: np.ndarray
    """(4,) standard deviation over packings of the parameters that would fit each packing alone, relative."""
    error: np.ndarray
    """(4,) standard error of the fitted parameters, relative: the spread over the root of the number of packings."""


def deviations(trial: Trial, goal: np.ndarray) -> np.ndarray:
    """Logarithm of the mean properties over the goal, shape (4,)."""
    return np.log(trial.properties.mean(axis=0) / goal)


def fit(calibration: DemCalibration, simulate: Simulate, report: Callable[[Trial], None]) -> Fit:
    """Calibrate.

    Parameters
    ----------
    calibration : DemCalibration
    simulate : callable
        Takes cases, gives their results in the same order.
    report : callable
        Receives every evaluation when it is done.
    """
    start, goal = start_of(calibration), goal_of(calibration)
    trials: dict[tuple[float, ...], Trial] = {}

    def evaluate(parameters: np.ndarray, purpose: str) -> Trial:
        key = tuple(rounded(parameters).tolist())
        if key not in trials:
            trials[key] = attempt(calibration, np.array(key), purpose, simulate)
            report(trials[key])
        return trials[key]

    root(
        lambda logs: deviations(evaluate(start * np.exp(logs), "search"), goal),
        np.zeros(len(FITTED)),
        method="df-sane",
        options={
            "fatol": calibration.tolerance,
            "ftol": 0.0,
            "fnorm": _largest,
            "maxfev": calibration.evaluations - 1,
        },
    )
    best = min(trials.values(), key=lambda trial: _largest(deviations(trial, goal)))

    slopes = np.full((len(FITTED), len(FITTED)), np.nan)
    if calibration.uncertainty:
        slopes = _slopes(best, calibration.slope_step, lambda parameters: evaluate(parameters, "slope"))
    spread = _spread(slopes, best)
    made = list(trials.values())
    return Fit(
        trials=made,
        best=next(index for index, trial in enumerate(made) if trial is best),
        converged=_largest(deviations(best, goal)) <= calibration.tolerance,
        slopes=slopes,
        spread=spread,
        error=spread / np.sqrt(calibration.replicates),
    )


def _largest(values: np.ndarray) -> float:
    return float(np.max(np.abs(values)))


def _slopes(best: Trial, step: float, evaluate: Callable[[np.ndarray], Trial]) -> np.ndarray:
    """Relative change of the mean properties over that of each parameter, by steps to both sides; shape (4, 4)."""
    columns = []
    for k in range(len(FITTED)):
        shift = step * (np.arange(len(FITTED)) == k)
        low, high = (evaluate(best.parameters * np.exp(sign * shift)) for sign in (-1, 1))
        change = np.log(high.properties.mean(axis=0) / low.properties.mean(axis=0))
        columns.append(change / np.log(high.parameters[k] / low.parameters[k]))
    return np.array(columns).T


def _spread(slopes: np.ndarray, best: Trial) -> np.ndarray:
    """Spread of the parameters that would bring each packing alone to the mean, to first order; NaN if not fixed."""
    logs = np.log(best.properties)
    try:
        shifts = np.linalg.solve(slopes, (logs - logs.mean(axis=0)).T).T
    except np.linalg.LinAlgError:
        return np.full(len(FITTED), np.nan)
    return shifts.std(axis=0, ddof=1)
