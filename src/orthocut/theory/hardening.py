"""Yield stress over plastic strain, for all laws of hardening."""

from __future__ import annotations

import numpy as np

from orthocut.params.material import ElasticPlastic


def yield_stress(material: ElasticPlastic, strain_plastic: np.ndarray) -> np.ndarray:
    """Kirchhoff stress in uniaxial tension at which a material yields.

    Parameters
    ----------
    material : ElasticPlastic
    strain_plastic : ndarray
        Equivalent plastic strain [-].

    Returns
    -------
    ndarray
        Yield stress [Pa], of the same shape; infinite where the material never yields.
    """
    law, start = material.hardening, material.stress_yield
    if law == "none":
        return np.full_like(strain_plastic, np.inf)
    if law == "linear":
        return start + material.modulus_plastic * strain_plastic
    if law == "ludwik":
        return start + material.hardening_modulus * strain_plastic**material.hardening_exponent
    rest = (material.stress_saturation - start) * np.exp(-strain_plastic / material.strain_saturation)
    return material.stress_saturation - rest
