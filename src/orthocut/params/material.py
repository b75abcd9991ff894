"""Material of the ductile workpiece."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import model_validator

from orthocut.params.block import Block, fault, refuse_unused
from orthocut.params.quantity import Number, Quantity

Modulus = Annotated[float, Quantity("Pa", "1 kPa", "1 TPa", "MPa")]


Stress = Annotated[float, Quantity("Pa", "1 kPa", "1 TPa", "MPa")]

_USES = {
    "linear": ("stress_yield", "modulus_tangent"),
    "ludwik": ("stress_yield", "hardening_modulus", "hardening_exponent"),
    "voce": ("stress_yield", "stress_saturation", "strain_saturation"),
    "none": (),
}
"""Hardening law to the fields that it uses."""


class ElasticPlastic(Block):
    """Neo-Hookean solid with von Mises yielding and isotropic hardening (Nairn 2015, eqs 1, 2).

    The defaults are the material of the paper, close to polyethylene. Fields that belong to another hardening law than
    the chosen one keep their defaults.
    """

    modulus_bulk: Modulus = 980e6
    """Bulk modulus K."""
    modulus_shear: Modulus = 376e6
    """Shear modulus G."""
    density: Annotated[float, Quantity("kg/m^3", "10 kg/m^3", "30000 kg/m^3")] = 1000.0
    """Density in the undeformed state."""
    hardening: Literal["linear", "ludwik", "voce", "none"] = "linear"
    """Yield stress over plastic strain: linear, ludwik (a power), voce (tends to a limit); none never yields."""
    stress_yield: Stress = 25e6
    """Initial yield stress in uniaxial tension."""
    modulus_tangent: Annotated[float, Quantity("Pa", "0 MPa", "1 TPa", "MPa")] = 100e6
    """linear: slope E_T of the uniaxial stress-strain curve after yielding; 0 MPa is perfectly plastic."""
    hardening_modulus: Modulus = 50e6
    """ludwik: factor K of the yield stress sigma_y + K eps^n, eps being the plastic strain."""
    hardening_exponent: Annotated[float, Number(0.05, 1.0)] = 0.3
    """ludwik: exponent n."""
    stress_saturation: Stress = 50e6
    """voce: limit of the yield stress s - (s - sigma_y) exp(-eps/e), above the initial one."""
    strain_saturation: Annotated[float, Number(1e-3, 10.0)] = 0.1
    """voce: plastic strain e in which the distance to the limit falls by a factor of 2.718."""

    @model_validator(mode="after")
    def _physical(self) -> ElasticPlastic:
        refuse_unused(self, "hardening", _USES)
        if self.hardening == "voce" and self.stress_saturation <= self.stress_yield:
            raise fault(
                f"stress_saturation = {self.stress_saturation / 1e6:.4g} MPa is too small "
                f"(allowed: more than stress_yield = {self.stress_yield / 1e6:.4g} MPa)"
            )
        if self.hardening == "linear" and self.modulus_tangent > 0.9 * self.modulus_young:
            raise fault(
                f"modulus_tangent = {self.modulus_tangent / 1e6:.4g} MPa is too large "
                f"(allowed: 0 to 0.9 Young's modulus = {0.9 * self.modulus_young / 1e6:.4g} MPa)"
            )
        if not 0.0 <= self.ratio_poisson <= 0.49:
            raise fault(
                f"modulus_bulk and modulus_shear give a Poisson's ratio of {self.ratio_poisson:.3f} "
                "(allowed: 0 to 0.49)"
            )
        return self

    @property
    def modulus_young(self) -> float:
        """Young's modulus E [Pa]."""
        return 9 * self.modulus_bulk * self.modulus_shear / (3 * self.modulus_bulk + self.modulus_shear)

    @property
    def ratio_poisson(self) -> float:
        """Poisson's ratio."""
        return (3 * self.modulus_bulk - 2 * self.modulus_shear) / (6 * self.modulus_bulk + 2 * self.modulus_shear)

    @property
    def modulus_plane_strain(self) -> float:
        """Plane-strain modulus E' = E/(1 - nu^2) [Pa]."""
        return self.modulus_young / (1 - self.ratio_poisson**2)

    @property
    def modulus_plastic(self) -> float:
        """Plastic modulus E_p = E E_T/(E - E_T), slope of yield stress over plastic strain of linear hardening [Pa]."""
        return self.modulus_young * self.modulus_tangent / (self.modulus_young - self.modulus_tangent)

    @property
    def speed_pressure_wave(self) -> float:
        """Speed of pressure waves sqrt((K + 4G/3)/density) [m/s]."""
        return ((self.modulus_bulk + 4 * self.modulus_shear / 3) / self.density) ** 0.5
