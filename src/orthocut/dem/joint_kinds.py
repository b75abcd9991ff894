"""Which joints are bonded, gapped or slit: one random draw a contact, the same whatever else changes."""

from __future__ import annotations

import numpy as np

from orthocut.params.dem import FlatJoint

BONDED, GAPPED, SLIT = range(3)
"""Kinds of joints, after Potyondy: all elements bonded; none, and open at first; none, and closed at first."""

_MULTIPLIERS = (np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB))
_INCREMENT = np.uint64(0x9E3779B97F4A7C15)


def draw_kinds(places: np.ndarray, pairs: np.ndarray, joint: FlatJoint) -> np.ndarray:
    """Kinds of joints, int8, shape (n_pairs,).

    A joint is slit where its draw is below the slit fraction, and gapped where it is above one less the gapped
    fraction: another fraction changes only the joints between the old limit and the new one.

    Parameters
    ----------
    places : float array, shape (n_discs, 2)
        Positions [m].
    pairs : int array, shape (n_pairs, 2)
    joint : FlatJoint
    """
    draws = contact_draws(places, pairs)
    kinds = np.full(len(pairs), BONDED, dtype=np.int8)
    kinds[draws < joint.fraction_slit] = SLIT
    kinds[draws >= 1 - joint.fraction_gapped] = GAPPED
    return kinds


def contact_draws(places: np.ndarray, pairs: np.ndarray) -> np.ndarray:
    """Uniform numbers in [0, 1), one a contact, from the bits of the positions of its discs; shape (n_pairs,).

    Positions come from the seed of the packing. A contact keeps its number when other discs are taken away, as for
    grooves, and when more pairs are joined. The mixing function is that of the generator SplitMix64.
    """
    words = np.ascontiguousarray(places, dtype=np.float64)[pairs].reshape(len(pairs), 4).view(np.uint64)
    mixed = np.zeros(len(pairs), dtype=np.uint64)
    for word in words.T:
        mixed = _mix((mixed ^ word) + _INCREMENT)
    return (mixed >> np.uint64(11)) * 2.0**-53


def _mix(word: np.ndarray) -> np.ndarray:
    for shift, factor in zip((30, 27), _MULTIPLIERS, strict=True):
        word = (word ^ (word >> np.uint64(shift))) * factor
    return word ^ (word >> np.uint64(31))
