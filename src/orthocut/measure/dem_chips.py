"""Chips: fragments of bonded discs that have come off the block."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components


class Chips(NamedTuple):
    """What has come off a block."""

    areas: np.ndarray
    """(n_chips,) areas of the discs of each fragment of two discs or more, the largest first [m^2]."""
    grains: int
    """Number of single discs that have lost all of their joints."""
    grain_area: float
    """Area of these discs [m^2]."""


def fragments(first: np.ndarray, second: np.ndarray, intact: np.ndarray, discs: int) -> np.ndarray:
    """Number of the fragment that each disc belongs to: discs that joints with bonded elements connect.

    Parameters
    ----------
    first, second : int arrays, shape (n_joints,)
        Indices of the discs of each joint.
    intact : float array, shape (n_joints,)
        Fraction of bonded elements.
    discs : int
        Number of discs.

    Returns
    -------
    int array, shape (n_discs,)
    """
    held = intact > 0
    links = coo_array((np.ones(held.sum()), (first[held], second[held])), shape=(discs, discs))
    return connected_components(links, directed=False)[1]


def chips(
    first: np.ndarray,
    second: np.ndarray,
    intact: np.ndarray,
    start: np.ndarray,
    radius: np.ndarray,
    fixed: np.ndarray,
) -> Chips:
    """Fragments without a fixed disc.

    Parameters
    ----------
    first, second, intact
        As in `fragments`.
    start : float array, shape (n_joints,)
        Fraction of bonded elements before the cut: a disc that had none then is no chip.
    radius : float array, shape (n_discs,)
        [m].
    fixed : int array, shape (n_fixed,)
        Indices of the fixed discs.
    """
    number = fragments(first, second, intact, len(radius))
    area = np.bincount(number, np.pi * radius**2)
    size = np.bincount(number)
    once = np.zeros(len(radius), dtype=bool)
    once[first[start > 0]] = once[second[start > 0]] = True
    free = np.ones(len(size), dtype=bool)
    free[number[fixed]] = False
    free[number[~once]] = False
    single = free & (size == 1)
    return Chips(np.sort(area[free & (size > 1)])[::-1], int(single.sum()), float(area[single].sum()))
