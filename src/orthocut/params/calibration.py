"""What a calibration of synthetic glass is: specimens, joints to start from, measured properties to reach."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError

from orthocut.params.block import Block, ConfigError, describe, show
from orthocut.params.case import fields, merge
from orthocut.params.dem import FlatJoint, Modulus, Packing, Stress
from orthocut.params.quantity import Number, Quantity
from orthocut.params.text import read_yaml

Speed = Annotated[float, Quantity("m/s", "0.02 mm/min", "1 m/s", "mm/s")]


class DemCalibration(Block):
    """Joints whose packings have the stiffness and strengths of a material; defaults are the glass of Yang et al."""

    kind: Literal["dem_calibration"] = "dem_calibration"
    packing: Packing = Packing.model_construct(
        width=0.5e-3,
        height=1e-3,
        radius_min=10e-6,
        radius_ratio=1.3333333333333333,
        porosity_cloud=0.103,
        pressure_ratio=0.03,
        seed=1,
    )
    """Specimen of both tests."""
    replicates: Annotated[int, Number(2, 100, integer=True)] = 5
    """Packings, the same in all evaluations: replicate k has the seed of the packing plus k."""
    joint: FlatJoint = Field(default_factory=FlatJoint)
    """Joints to start from; what is not fitted stays as it is."""
    speed_tension: Speed = 0.02
    """Speed of each grip; strengths at 5 to 40 mm/s differ by less than their standard error."""
    speed_compression: Speed = 0.04
    """Speed of each platen; as for grips."""
    friction_platen: Annotated[float, Number(0.0, 1.5)] = 0.0
    """Coulomb coefficient of the platens."""
    modulus_young: Modulus = 71e9
    """Young's modulus to reach, in tension."""
    ratio_poisson: Annotated[float, Number(0.01, 0.5)] = 0.23
    """Poisson's ratio to reach, in tension."""
    strength_tension: Stress = 41e6
    """Tensile strength to reach."""
    strength_compression: Stress = 330e6
    """Unconfined compressive strength to reach."""
    tolerance: Annotated[float, Number(1e-3, 0.2)] = 0.02
    """Largest deviation of the mean over the packings from any of the four, as a logarithm of the ratio."""
    slope_step: Annotated[float, Number(0.01, 0.3)] = 0.1
    """Relative change of a parameter to either side for its influence on the properties."""
    uncertainty: bool = True
    """Whether to find these influences, and from them the uncertainty of the fit: eight more evaluations."""
    evaluations: Annotated[int, Number(1, 1000, integer=True)] = 40
    """Most evaluations of the search."""


def load_calibration(path: Path | None = None, values: Mapping[str, Any] | None = None) -> DemCalibration:
    """Read a calibration from a YAML file that gives what differs from the defaults.

    Parameters
    ----------
    path : Path, optional
    values : mapping, optional
        Dotted names of fields to values as a user writes them; they replace those of the file.

    Raises
    ------
    ConfigError
        One line a fault: source, field, value, allowed range.
    """
    source = str(path) if path else "calibration"
    data: Any = read_yaml(path) if path else {}
    if not isinstance(data, dict):
        raise ConfigError(f"{source} = {show(data)}: must hold the fields of a calibration")
    for name, value in (values or {}).items():
        data = merge(data, _nested(name.split("."), value))
    try:
        return DemCalibration.model_validate(merge(DemCalibration().model_dump(mode="json"), data))
    except ValidationError as error:
        raise describe(error, source, fields(DemCalibration)) from None


def _nested(names: list[str], value: Any) -> Any:
    return {names[0]: _nested(names[1:], value)} if names else value
