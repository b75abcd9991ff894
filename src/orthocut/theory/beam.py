"""Moment and curvature of a strip with linear hardening, and the areas of that diagram (Nairn 2015, eqs 20-22).

Curvature ratio k: curvature over the curvature 2 sy/(h E') at which the outer fibre yields. Slope ratio r: slope of
the fibre's stress-strain curve after yielding over E'. Eqs (20)-(22) hold with the *tangent* modulus in r; the plastic
modulus that the paper's symbol names is the slope over plastic strain and overestimates the moment.
"""

from __future__ import annotations

import numpy as np


def moment(curvature_ratio, slope_ratio):
    """Bending moment over b h^2 sy/4, the limit moment without hardening.

    Parameters
    ----------
    curvature_ratio : float or array
        Curvature over curvature at first yield, >= 0 [-].
    slope_ratio : float
        Slope after yielding over E', 0 <= r < 1 [-].

    Returns
    -------
    array
        Normalised moment [-].

    Notes
    -----
    Nairn (2015), eq. (20).
    """
    k = np.asarray(curvature_ratio, float)
    p = np.maximum(k, 1.0)
    plastic = 1 - 1 / (3 * p**2) + slope_ratio / 3 * (1 - 1 / p) ** 2 * (2 * p + 1)
    return np.where(k < 1, 2 * k / 3, plastic)


def area_complementary(curvature_ratio, slope_ratio):
    """Area A1 between the moment and the loading curve, over b h sy^2/(2 E').

    Notes
    -----
    Nairn (2015), eq. (21), and the elastic branch below eq. (22).
    """
    k = np.asarray(curvature_ratio, float)
    p = np.maximum(k, 1.0)
    plastic = 1 - 2 / (3 * p) + slope_ratio / 3 * (p - 1) ** 2 * (1 + 2 / p)
    return np.where(k < 1, k**2 / 3, plastic)


def area_dissipated(curvature_ratio, slope_ratio):
    """Area A2 between the loading curve and the elastic unloading line, over b h sy^2/(2 E').

    Notes
    -----
    Nairn (2015), eq. (22); zero in elastic bending. Assumes that unloading is elastic to zero moment.
    """
    p = np.maximum(np.asarray(curvature_ratio, float), 1.0)
    s = 1 - 1 / p
    bracket = p + s / 4 * (1 + 1 / (3 * p) + slope_ratio / 3 * s * (2 * p + 1) ** 2)
    return (1 - slope_ratio) * s**2 * bracket
