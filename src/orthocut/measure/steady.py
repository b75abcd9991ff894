"""Means of histories, with their errors."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Mean(NamedTuple):
    """Mean of a history over a window."""

    value: float
    """Mean, in the unit of the history."""
    error: float
    """Standard error of the mean from block averages, in the unit of the history."""
    drift: float
    """Change of a straight line through the window, over the mean."""


def block_mean(values: np.ndarray, blocks: int = 10) -> Mean:
    """Mean, standard error and drift of equidistant samples.

    Parameters
    ----------
    values : float array, shape (n_samples,)
        Samples in the window.
    blocks : int
        Number of blocks whose means are taken as independent; a block must be longer than the correlation of the
        samples, or the error comes out too small.

    Returns
    -------
    Mean
        NaN where there are fewer samples than blocks.

    Notes
    -----
    Flyvbjerg & Petersen (1989), J. Chem. Phys. 91, 461.
    """
    if values.size < blocks:
        return Mean(np.nan, np.nan, np.nan)
    value = float(values.mean())
    means = np.array([part.mean() for part in np.array_split(values, blocks)])
    error = float(means.std(ddof=1) / np.sqrt(blocks))
    slope = np.polyfit(np.linspace(0.0, 1.0, values.size), values, 1)[0]
    return Mean(value, error, float(slope / value) if value else np.nan)


def steady_from(values: np.ndarray) -> int:
    """Index of the first sample of the steady part of a history, in its first half.

    What is left out is a start that differs from the rest: the cut that makes the squared standard error of the mean of
    the remaining samples, taken as independent, least.

    Parameters
    ----------
    values : float array, shape (n_samples,)
        Equidistant samples.

    Notes
    -----
    The marginal standard error rule of White (1997), Simulation 69, 323, with blocks of five samples.
    """
    blocks = values[: values.size // 5 * 5].reshape(-1, 5).mean(axis=1)
    if blocks.size < 4:
        return 0
    cuts = range(blocks.size // 2 + 1)
    return 5 * int(np.argmin([blocks[cut:].var() / (blocks.size - cut) for cut in cuts]))


def is_known(mean: Mean, error: float) -> bool:
    """Whether a mean is known to a relative standard error, and does not drift by more than twice that."""
    return mean.error <= error * abs(mean.value) and abs(mean.drift) <= 2.0 * error
