"""Stress and strain in the measurement region of a specimen, elastic constants."""

from __future__ import annotations

import numpy as np

from orthocut.measure.dem_energy import Forces


def stress_axial(found: Forces, y: np.ndarray, low: float, high: float, width: float) -> float:
    """Mean axial stress in the band between two heights, over the whole width [Pa].

    Each force counts with the part of its branch, from centre to centre, that lies in the band: in equilibrium the
    result is the force through a section over the width, for any band.

    Parameters
    ----------
    found : Forces
    y : float array, shape (n_discs,)
        Heights of the discs [m].
    low, high : float
        Limits of the band [m].
    width : float
        Width of the specimen [m].
    """
    inside = np.clip(y, low, high)
    branch = inside[found.second] - inside[found.first]
    return float(np.sum(found.force[:, 1] * branch) / (width * (high - low)))


def slope(x: np.ndarray, values: np.ndarray) -> float:
    """Slope of the straight line of least squares; NaN if it is not defined."""
    centred = x - x.mean()
    square = float(np.sum(centred**2))
    return float(np.sum(centred * values) / square) if square > 0 else float("nan")


def strains(initial: np.ndarray, places: np.ndarray, members: np.ndarray) -> tuple[float, float]:
    """Axial (y) and lateral (x) strain of a group of discs, by straight lines through their displacements.

    Parameters
    ----------
    initial, places : float arrays, shape (n_discs, 2)
        Positions at the start and now [m].
    members : bool array, shape (n_discs,)
    """
    shift = places[members] - initial[members]
    return slope(initial[members, 1], shift[:, 1]), slope(initial[members, 0], shift[:, 0])


def elastic_constants(stress: np.ndarray, axial: np.ndarray, lateral: np.ndarray) -> tuple[float, float]:
    """Young's modulus [Pa] and Poisson's ratio, from the samples at 10 to 50 % of the peak stress before the peak.

    Parameters
    ----------
    stress, axial, lateral : float arrays, shape (n_samples,)
        Stress [Pa], positive along the loading, and strains in the measurement region.
    """
    peak = int(np.argmax(stress))
    early = stress[: peak + 1]
    inside = (early >= 0.1 * early[-1]) & (early <= 0.5 * early[-1])
    if inside.sum() < 3:
        return float("nan"), float("nan")
    axial, lateral = axial[: peak + 1][inside], lateral[: peak + 1][inside]
    return abs(slope(axial, early[inside])), -slope(axial, lateral)
