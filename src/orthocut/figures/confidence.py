"""How well a mean over replicates is known: confidence intervals by Student's t."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.special import stdtrit

LEVEL = 0.95
MOST = 10_000
"""Most replicates that are ever asked for."""


class Interval(NamedTuple):
    """Mean of independent values and what is known of it."""

    mean: float
    half: float
    """Half-width of the confidence interval of the mean; NaN for fewer than two values."""
    spread: float
    """Standard deviation of the values."""
    count: int

    @property
    def relative(self) -> float:
        """Half-width over the magnitude of the mean."""
        return self.half / abs(self.mean) if self.mean else math.nan


def quantile(count: int, level: float = LEVEL) -> float:
    """Quantile of Student's t for a two-sided interval from so many values."""
    return float(stdtrit(count - 1, 0.5 + 0.5 * level))


def interval(values: Sequence[float], level: float = LEVEL) -> Interval:
    """Mean, its confidence interval and the spread of some values; those that are no numbers are left out.

    Parameters
    ----------
    values : sequence of float
        Results of independent replicates.
    level : float
        Confidence.
    """
    found = np.asarray(values, float)
    found = found[np.isfinite(found)]
    count = len(found)
    if count < 2:
        return Interval(float(found.mean()) if count else math.nan, math.nan, math.nan, count)
    spread = float(found.std(ddof=1))
    return Interval(float(found.mean()), quantile(count, level) * spread / math.sqrt(count), spread, count)


def ratio(first: Sequence[float], second: Sequence[float], level: float = LEVEL) -> Interval:
    """Ratio of the means of two sets of paired values and its confidence interval, by linear propagation.

    Parameters
    ----------
    first, second : sequence of float
        Results of the same replicates, one by one; what one replicate does to both does not widen the interval.
    level : float
        Confidence.
    """
    pairs = np.array([pair for pair in zip(first, second, strict=True) if np.isfinite(pair).all()]).reshape(-1, 2)
    if not len(pairs) or not pairs[:, 1].mean():
        return Interval(math.nan, math.nan, math.nan, len(pairs))
    base = float(pairs[:, 1].mean())
    found = float(pairs[:, 0].mean()) / base
    return interval((pairs[:, 0] - found * pairs[:, 1]) / base, level)._replace(mean=found)


def prediction(values: Sequence[float], level: float = LEVEL) -> tuple[float, float]:
    """Limits between which one more replicate is expected, as if replicates were normal; NaN for fewer than two."""
    known = interval(values, level)
    half = known.half * math.sqrt(known.count + 1) if known.count > 1 else math.nan
    return known.mean - half, known.mean + half


def needed(values: Sequence[float], relative: float, level: float = LEVEL) -> float:
    """Replicates that bring the half-width of the interval to a fraction of the mean; NaN where that is not known.

    Parameters
    ----------
    values : sequence of float
        Results of independent replicates, which tell the spread.
    relative : float
        Half-width over the mean that is wanted.
    """
    known = interval(values, level)
    if not (known.count > 1 and known.mean):
        return math.nan
    ratio = known.spread / abs(known.mean)
    return float(next((n for n in range(2, MOST) if quantile(n, level) * ratio <= relative * math.sqrt(n)), MOST))
