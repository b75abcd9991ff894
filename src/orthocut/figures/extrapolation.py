"""Force at zero particle size, from runs at several sizes, with its standard error."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

FLOOR = 0.005
"""Smallest relative error of a mean: below it, other errors than the statistical one decide."""


class Fit(NamedTuple):
    """Least-squares fit of ``limit + slope size^power``."""

    limit: float
    """Value at size zero, in the unit of the values."""
    error: float
    """Standard error of the limit."""
    slope: float
    """Coefficient of size^power."""
    slope_error: float
    """Standard error of the slope."""
    power: float
    """Order of convergence that was assumed [-]."""
    misfit: float
    """Weighted mean square deviation for a degree of freedom (chi^2); NaN where there is none left."""

    def at(self, size) -> np.ndarray:
        """Fitted values at some sizes."""
        return self.limit + self.slope * np.asarray(size, float) ** self.power


def extrapolate(sizes: Sequence[float], values: Sequence[float], errors: Sequence[float], power: float = 1.0) -> Fit:
    """Weighted least-squares fit of a straight line in size^power.

    Parameters
    ----------
    sizes : sequence of float
        Particle sizes, in any unit; at least two different ones.
    values : sequence of float
        Results at these sizes, in any unit.
    errors : sequence of float
        Standard errors of the values, in their unit. One that is not known, or below half a percent of its value,
        counts as half a percent, of the largest value where its own is zero.
    power : float
        Order of convergence [-].

    Returns
    -------
    Fit
        Standard errors are those that the errors of the values give, widened by the square root of the misfit where the
        values scatter more than their errors say.

    Raises
    ------
    ValueError
        If there are fewer than two sizes.
    """
    x, y = np.asarray(sizes, float) ** power, np.asarray(values, float)
    if np.unique(x).size < 2:
        raise ValueError(f"{np.unique(x).size} particle size is not enough for a fit (allowed: two or more)")
    sigma = np.fmax(np.asarray(errors, float), FLOOR * np.abs(y))
    sigma = np.where(sigma > 0, sigma, FLOOR * (np.abs(y).max() or 1.0))
    design = np.column_stack([np.ones_like(x), x]) / sigma[:, None]
    covariance = np.linalg.inv(design.T @ design)
    limit, slope = covariance @ design.T @ (y / sigma)
    freedom = x.size - 2
    misfit = float(((y - limit - slope * x) ** 2 / sigma**2).sum() / freedom) if freedom else math.nan
    widened = math.sqrt(max(misfit, 1.0)) if freedom else 1.0
    error, slope_error = widened * np.sqrt(np.diag(covariance))
    return Fit(float(limit), float(error), float(slope), float(slope_error), power, misfit)
