"""Rubbing force over depth of cut, as the bending model in its printed form needs it."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr

from orthocut.figures.sweep import cut_depth, dimensionless_depth, touches

FIT_ABOVE = 0.28
"""Dimensionless depth of cut from which Nairn (2015), Fig. 10, fits straight lines [-]."""


def rubbing_line(runs: list[xr.Dataset], above: float = 0.0) -> np.ndarray | None:
    """Straight line through the rubbing forces of runs that bend.

    Parameters
    ----------
    runs : list of xarray.Dataset
        Runs of one series.
    above : float
        Smallest dimensionless depth of cut that counts [-].

    Returns
    -------
    array or None
        Slope [N/m^2] and value at zero depth [N/m], for `numpy.polyval`; None where fewer than two runs count.
    """
    known = [
        (cut_depth(run), float(run["force_rubbing_mean"]))
        for run in runs
        if "force_rubbing_mean" in run and not touches(run) and dimensionless_depth(run) >= above
    ]
    known = [pair for pair in known if math.isfinite(pair[1])]
    return np.polyfit(*zip(*known, strict=True), 1) if len({depth for depth, _ in known}) > 1 else None


def rubbing_at(runs: list[xr.Dataset], depths: np.ndarray, above: float = 0.0) -> np.ndarray:
    """Rubbing force at some depths of cut from the line of `rubbing_line`, not below zero [N/m]; zero without one."""
    line = rubbing_line(runs, above)
    return np.zeros_like(depths) if line is None else np.maximum(np.polyval(line, depths), 0.0)


def rubbing_between(runs: list[xr.Dataset], depths: np.ndarray) -> np.ndarray:
    """Rubbing force at some depths of cut, between those of the runs that touch [N/m]; zero without any."""
    known = [
        (cut_depth(run), float(run["force_rubbing_mean"]))
        for run in runs
        if "force_rubbing_mean" in run and touches(run)
    ]
    known = sorted(pair for pair in known if math.isfinite(pair[1]))
    return np.interp(depths, *zip(*known, strict=True)) if known else np.zeros_like(depths)
