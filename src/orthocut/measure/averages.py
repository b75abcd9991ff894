"""Averages of forces that fluctuate."""

from __future__ import annotations

import numpy as np


def mean_and_error(values: np.ndarray, blocks: int = 10) -> tuple[float, float]:
    """Mean and its standard error, from the scatter of the means of consecutive blocks.

    Parameters
    ----------
    values : float array, shape (n_samples,)
        Samples at equal intervals.
    blocks : int
        Number of blocks; each must be longer than the memory of the signal for the error to be right.
    """
    means = np.array([block.mean() for block in np.array_split(values, blocks)])
    return float(values.mean()), float(means.std(ddof=1) / np.sqrt(blocks))
