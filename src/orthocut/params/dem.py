"""Cases of brittle glass made of bonded discs (Yang et al. 2018)."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field, model_validator

from orthocut.params.block import Block, fault
from orthocut.params.quantity import Number, Quantity
from orthocut.params.tool import Tool

Size = Annotated[float, Quantity("m", "10 um", "100 mm", "mm")]
Modulus = Annotated[float, Quantity("Pa", "1 MPa", "10 TPa", "GPa")]
Stress = Annotated[float, Quantity("Pa", "1 kPa", "1 TPa", "MPa")]


class Packing(Block):
    """Random dense packing in a rectangular vessel, by radius scaling to a target pressure."""

    width: Size = 1e-3
    """Width of the vessel."""
    height: Size = 2e-3
    """Height of the vessel."""
    radius_min: Annotated[float, Quantity("m", "0.1 um", "10 mm", "um")] = 7.5e-6
    """Smallest radius before scaling; radii are uniform between the smallest and the largest."""
    radius_ratio: Annotated[float, Number(1.0, 4.0)] = 1.3333333333333333
    """Largest over smallest radius."""
    porosity_cloud: Annotated[float, Number(0.05, 0.4)] = 0.103
    """Porosity of the cloud of discs before scaling, overlaps ignored; sets the number of discs."""
    pressure_ratio: Annotated[float, Number(1e-4, 0.1)] = 0.03
    """Confining pressure over contact modulus at which the joints are installed."""
    seed: Annotated[int, Number(0, 2**31 - 1, integer=True)] = 1
    """Seed of the random positions and radii; one packing a replicate."""


class FlatJoint(Block):
    """Flat joints between discs and linear contacts between discs that meet later; defaults are Table 1 as printed."""

    modulus: Modulus = 107e9
    """Contact and joint modulus."""
    stiffness_ratio: Annotated[float, Number(1.0, 10.0)] = 3.1
    """Normal over shear stiffness."""
    strength_tensile: Stress = 200e6
    """Tensile strength of an element."""
    cohesion: Stress = 113e6
    """Shear strength of an element at zero normal stress."""
    friction_angle: Annotated[float, Quantity("rad", "0 deg", "60 deg", "deg")] = 0.436332312998582
    """Friction angle of bonded elements."""
    friction: Annotated[float, Number(0.0, 1.5)] = 0.577
    """Residual Coulomb coefficient of broken elements and of new contacts."""
    elements: Annotated[int, Number(1, 4, integer=True)] = 2
    """Elements of a joint (N_r)."""
    radius_multiplier: Annotated[float, Number(0.1, 1.0)] = 1.0
    """Half-length of the faces of a joint over the smaller radius of its discs (lambda)."""
    gap_ratio: Annotated[float, Number(0.0, 0.3)] = 0.0
    """Largest distance of two surfaces that are joined, over the smaller radius (installation gap)."""
    fraction_slit: Annotated[float, Number(0.0, 1.0)] = 0.0
    """Fraction of slit joints: closed but not bonded."""
    fraction_gapped: Annotated[float, Number(0.0, 1.0)] = 0.0
    """Fraction of gapped joints: neither closed nor bonded. The rest, one less both fractions, is bonded."""
    gapped_opening: Annotated[float, Number(1e-6, 0.1)] = 1e-3
    """Initial gap of gapped joints over the smaller radius."""
    density: Annotated[float, Quantity("kg/m^3", "10 kg/m^3", "30000 kg/m^3")] = 2400.0
    """Density of the discs."""
    damping: Annotated[float, Number(0.0, 0.95)] = 0.7
    """Local damping coefficient."""
    time_step_factor: Annotated[float, Number(0.01, 1.0)] = 0.5
    """Time step over sqrt(smallest disc mass/(modulus x width)). Damping and stiff shear lower the stable limit; beyond
    it a case is refused. The default packing and damping stand 0.59, or 0.34 with stiffness_ratio = 1."""

    @property
    def fraction_bonded(self) -> float:
        """Fraction of bonded joints."""
        return 1 - self.fraction_slit - self.fraction_gapped

    @model_validator(mode="after")
    def _kinds(self) -> FlatJoint:
        loose = self.fraction_slit + self.fraction_gapped
        if loose > 1 + 1e-12:
            raise fault(
                f"fraction_slit = {self.fraction_slit:.4g} and fraction_gapped = {self.fraction_gapped:.4g} are "
                f"{loose:.4g} together (allowed: up to 1; the rest is bonded)"
            )
        unused = FlatJoint.model_fields["gapped_opening"].default
        if self.fraction_gapped == 0 and self.gapped_opening != unused:
            raise fault(
                f"gapped_opening = {self.gapped_opening:.4g} is of no use with fraction_gapped = 0 "
                f"(allowed: leave it out, or fraction_gapped above 0)"
            )
        return self


class _Dem(Block):
    packing: Packing = Field(default_factory=Packing)
    joint: FlatJoint = Field(default_factory=FlatJoint)


class _Test(_Dem):
    grip_speed: Annotated[float, Quantity("m/s", "0.02 mm/min", "1 m/s", "mm/s")] = 0.01
    """Speed of each grip or platen."""
    drop_fraction: Annotated[float, Number(0.05, 0.99)] = 0.7
    """The test ends when the stress has dropped to this fraction of its peak."""
    strain_max: Annotated[float, Number(1e-5, 0.2)] = 0.02
    """The test ends at this axial strain at the latest."""


class DemTension(_Test):
    """Uniaxial tension by rows of discs at both ends."""

    kind: Literal["dem_tension"] = "dem_tension"
    grip_ratio: Annotated[float, Number(0.01, 0.3)] = 0.05
    """Height of a grip over height of the specimen."""


class DemCompression(_Test):
    """Unconfined compression between rigid platens."""

    kind: Literal["dem_compression"] = "dem_compression"
    friction_platen: Annotated[float, Number(0.0, 1.5)] = 0.0
    """Coulomb coefficient of the platens."""


class DemBrazilian(_Test):
    """A round specimen, cut from a packing, split between rigid platens."""

    kind: Literal["dem_brazilian"] = "dem_brazilian"
    packing: Packing = Packing.model_construct(
        width=1e-3,
        height=1e-3,
        radius_min=7.5e-6,
        radius_ratio=1.3333333333333333,
        porosity_cloud=0.103,
        pressure_ratio=0.03,
        seed=1,
    )
    friction_platen: Annotated[float, Number(0.0, 1.5)] = 0.0
    """Coulomb coefficient of the platens."""
    flat_ratio: Annotated[float, Number(0.0, 0.5)] = 0.2
    """Width of the flats that the platens stand on, over the diameter."""

    @property
    def diameter(self) -> float:
        """Diameter of the specimen [m]: the smaller side without two of the largest discs, which the walls arranged."""
        packing = self.packing
        return min(packing.width, packing.height) - 4 * packing.radius_min * packing.radius_ratio


class Grooves(Block):
    """Grooves in the surface, as deep as the cut, rectangular or inverted trapezoids; made by deleting discs."""

    width: Size = 0.06e-3
    """Width of a groove at the surface."""
    bottom_ratio: Annotated[float, Number(0.0, 1.0)] = 1.0
    """Width at the bottom over width at the surface: 1 is a rectangle; less is a trapezoid, as lasers leave it, with
    walls that are thicker at their feet."""
    distance: Size = 0.2e-3
    """Clear distance between grooves at the surface. The paper's 0.2 mm may be meant as the pitch, from one groove to
    the next; then it is 0.14 mm."""

    def edges(self, block: float) -> list[tuple[float, float]]:
        """Left and right edges at the surface of a block [m], from the free side on.

        Parameters
        ----------
        block : float
            Width of the block [m]; the first groove lies one clear distance inside.
        """
        pitch = self.width + self.distance
        count = math.floor((block - pitch) / pitch + 1e-9) + 1
        right = [block - self.distance - k * pitch for k in range(count)]
        return [(edge - self.width, edge) for edge in right]


class DemCutting(_Dem):
    """Orthogonal cut of a block whose far side and bottom are fixed."""

    kind: Literal["dem_cutting"] = "dem_cutting"
    packing: Packing = Packing.model_construct(
        width=1e-3,
        height=1e-3,
        radius_min=10e-6,
        radius_ratio=1.3333333333333333,
        porosity_cloud=0.103,
        pressure_ratio=0.03,
        seed=1,
    )
    tool: Tool = Tool.model_construct(rake_angle=-0.261799387799149, clearance_angle=0.261799387799149, friction=0.577)
    cut_depth: Annotated[float, Quantity("m", "1 um", "10 mm", "mm")] = 0.1e-3
    """Depth of cut."""
    cut_speed: Annotated[float, Quantity("m/s", "0.1 mm/s", "20 m/s", "m/s")] = 1.0
    """Speed of the tool."""
    travel: Annotated[float, Quantity("m", "1 um", "100 mm", "mm")] = 0.8e-3
    """Travel of the tool."""
    grooves: Grooves | None = None
    """Grooves, or none."""

    @model_validator(mode="after")
    def _fits(self) -> DemCutting:
        if self.cut_depth > 0.5 * self.packing.height:
            raise fault(
                f"cut_depth = {self.cut_depth * 1e3:.4g} mm is more than half of the block "
                f"(allowed: up to {0.5e3 * self.packing.height:.4g} mm)"
            )
        if self.travel > 0.9 * self.packing.width:
            raise fault(
                f"travel = {self.travel * 1e3:.4g} mm runs into the fixed side of the block "
                f"(allowed: up to {0.9e3 * self.packing.width:.4g} mm)"
            )
        return self
