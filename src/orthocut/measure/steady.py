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
