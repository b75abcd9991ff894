"""Pairs of discs that touch or nearly do."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree


def close_pairs(x: np.ndarray, y: np.ndarray, radius: np.ndarray, gap_ratio: float = 0.0) -> np.ndarray:
    """Pairs i < j whose surfaces overlap, touch or are close, ordered by i, then j.

    Parameters
    ----------
    x, y, radius : float arrays, shape (n_discs,)
        [m]
    gap_ratio : float
        Largest distance of the surfaces over the smaller radius of the pair.

    Returns
    -------
    int array, shape (n_pairs, 2)
    """
    points = np.column_stack([x, y])
    pairs = cKDTree(points).query_pairs((2 + gap_ratio) * radius.max() * (1 + 1e-9), output_type="ndarray")
    distance = np.hypot(*(points[pairs[:, 0]] - points[pairs[:, 1]]).T)
    reach = radius[pairs].sum(axis=1) + gap_ratio * radius[pairs].min(axis=1)
    pairs = np.sort(pairs[distance <= reach * (1 + 1e-12)], axis=1)
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]
