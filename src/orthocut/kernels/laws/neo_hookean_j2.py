"""Neo-Hookean elasticity with von Mises yielding and isotropic hardening by any law in plane strain.

Nairn (2015), eqs (1) and (2), with the return mapping of Simo & Hughes (1998), Computational Inelasticity, ch. 9. The
yield stress is compared with the Kirchhoff stress.
"""

import math

from orthocut.kernels.jit import inline
from orthocut.kernels.laws.hardening import multiplier
from orthocut.kernels.laws.mises import ROOT_2_3


@inline
def update(bxx, byy, bxy, strain_plastic, fxx, fxy, fyx, fyy, modulus_shear, hardening):
    """Isochoric elastic strain, plastic strain and deviatoric stress after an increment of deformation.

    Parameters
    ----------
    bxx, byy, bxy : float
        Isochoric elastic left Cauchy-Green tensor before the increment.
    strain_plastic : float
        Cumulative plastic strain before the increment.
    fxx, fxy, fyx, fyy : float
        Deformation gradient of the increment; its determinant must be within a few per cent of one.
    modulus_shear : float
        Shear modulus [Pa].
    hardening : Hardening
        Law of the yield stress, see `orthocut.kernels.laws.hardening`.

    Returns
    -------
    bxx, byy, bxy, strain_plastic : float
        State after the increment.
    sxx, syy, sxy : float
        Deviatoric Kirchhoff stress [Pa].
    """
    # trial state: f b f^T / det(f)^(2/3), the power by its series
    e = fxx * fyy - fxy * fyx - 1.0
    c = 1.0 + e * (-2.0 / 3.0 + e * (5.0 / 9.0 - e * (40.0 / 81.0)))
    hxx = fxx * bxx + fxy * bxy
    hxy = fxx * bxy + fxy * byy
    hyx = fyx * bxx + fyy * bxy
    hyy = fyx * bxy + fyy * byy
    txx = c * (hxx * fxx + hxy * fxy)
    txy = c * (hxx * fyx + hxy * fyy)
    tyy = c * (hyx * fyx + hyy * fyy)
    tzz = 1.0 / (txx * tyy - txy * txy)
    third = (txx + tyy + tzz) / 3.0
    axx = txx - third
    ayy = tyy - third
    azz = tzz - third
    # return mapping; without yielding the scale is one
    shear = modulus_shear * third
    norm = modulus_shear * math.sqrt(axx * axx + ayy * ayy + azz * azz + 2.0 * txy * txy)
    plastic = multiplier(hardening, norm, shear, strain_plastic)
    scale = 1.0 - 2.0 * shear * plastic / max(norm, 1e-300)
    axx *= scale
    ayy *= scale
    azz *= scale
    axy = txy * scale
    # isotropic part that keeps the determinant at one: a root of x^3 - second x + third order - 1; one Newton step
    # from the trial state, which is an increment away
    second = 0.5 * (axx * axx + ayy * ayy + azz * azz) + axy * axy
    det = azz * (axx * ayy - axy * axy) - 1.0
    x = third - (third * (third * third - second) + det) / (3.0 * third * third - second)
    x = third if plastic <= 0.0 else x
    return (
        axx + x,
        ayy + x,
        axy,
        strain_plastic + ROOT_2_3 * plastic,
        modulus_shear * axx,
        modulus_shear * ayy,
        modulus_shear * axy,
    )


@inline
def pressure_kirchhoff(volume_ratio, modulus_bulk):
    """Isotropic Kirchhoff stress K (J^2 - 1)/2, tension positive [Pa]."""
    return 0.5 * modulus_bulk * (volume_ratio * volume_ratio - 1.0)


@inline
def energy_elastic(volume_ratio, trace, modulus_bulk, modulus_shear):
    """Elastic energy per initial volume [J/m^3], eq (1); `trace` is that of the isochoric elastic strain."""
    volumetric = 0.5 * (volume_ratio * volume_ratio - 1.0) - math.log(volume_ratio)
    return 0.5 * modulus_bulk * volumetric + 0.5 * modulus_shear * (trace - 3.0)
