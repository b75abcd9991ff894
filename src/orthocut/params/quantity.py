"""Physical quantities in cases: written with a unit, held as a float in SI, always inside a stated range.

A quantity is never a bare number: ``0.9 mm`` is accepted, ``0.0009`` is not, because its unit would be a guess.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import PydanticCustomError, core_schema

from orthocut.params.units import unit_of

_FORM = re.compile(r"(?P<number>[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?)(?P<unit>[^0-9.].*)?")
MAX_LENGTH = 100
"""Most characters of a quantity."""
_NO_SIGN = 0.0  # added to minus zero, gives zero


@lru_cache(maxsize=10_000)
def convert(text: str, unit: str, hint: str = "") -> float:
    """Value of a text such as ``"25 MPa"`` in `unit`, to 15 significant digits.

    Parameters
    ----------
    text : str
        A number and a unit of `orthocut.params.units`.
    unit : str
        Unit of the result.
    hint : str
        Unit to suggest in errors; default `unit`.

    Raises
    ------
    ValueError
        If the text is not a number with a unit of the same dimensions.
    """
    hint = hint or unit
    form = _FORM.fullmatch(text.strip()) if len(text) <= MAX_LENGTH else None
    if form is None:
        raise ValueError(f"is not a number with a unit, such as '1 {hint}'")
    if not (form["unit"] or "").strip():
        raise ValueError(f"has no unit, write for example '{text.strip()} {hint}'")
    try:
        scale, dimensions = unit_of(form["unit"].strip())
    except ValueError as error:
        raise ValueError(f"is not a number with a unit, such as '1 {hint}': {error}") from error
    wanted, needed = unit_of(unit)
    if dimensions != needed:
        raise ValueError(f"is not a quantity in {hint}")
    return float(f"{float(form['number']) * scale / wanted:.15g}") + _NO_SIGN


@dataclass(frozen=True)
class Quantity:
    """Annotation of a physical quantity: ``Annotated[float, Quantity("m", low="1 um", high="1 m", display="mm")]``.

    Attributes
    ----------
    unit : str
        SI unit in which the value is held.
    low, high : str
        Allowed range, ends included, with units.
    display : str
        Unit in which people read the value; default `unit`.
    """

    unit: str
    low: str
    high: str
    display: str = ""

    def validate(self, value: Any) -> float:
        """Value in SI; raise `PydanticCustomError` naming the value and the allowed range."""
        allowed = f"allowed: {self.low} to {self.high}"
        if not isinstance(value, str):
            plain = isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e15
            example = f"{value:g} {self.display or self.unit}" if plain else self.high
            raise PydanticCustomError(
                "quantity_unit", "{why} ({allowed})", {"why": f"needs a unit, such as '{example}'", "allowed": allowed}
            )
        try:
            number = convert(value, self.unit, self.display)
        except ValueError as error:
            raise PydanticCustomError(
                "quantity", "{why} ({allowed})", {"why": str(error), "allowed": allowed}
            ) from None
        low, high = self._range
        if not low <= number <= high:
            raise PydanticCustomError("quantity_range", "is out of range ({allowed})", {"allowed": allowed})
        return number

    @cached_property
    def _range(self) -> tuple[float, float]:
        """Ends of the allowed range in SI, with room for rounding; none at zero."""
        low, high = convert(self.low, self.unit), convert(self.high, self.unit)
        return low - 1e-12 * abs(low), high + 1e-12 * abs(high)

    def show(self, value: float) -> str:
        """Text for people, such as ``"0.9 mm"``; reading it back gives the same value."""
        unit = self.display or self.unit
        shown = f"{convert(f'{value!r} {self.unit}', unit):.12g} {unit}"
        return shown if convert(shown, self.unit) == value else f"{value!r} {self.unit}"

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(
            self.validate,
            serialization=core_schema.plain_serializer_function_ser_schema(
                lambda value: f"{value!r} {self.unit}", return_schema=core_schema.str_schema()
            ),
        )

    def __get_pydantic_json_schema__(self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler) -> dict:
        return {"type": "string", "description": f"{self.low} to {self.high}", "examples": [self.low, self.high]}


@dataclass(frozen=True)
class Number:
    """Annotation of a plain number without a unit: ``Annotated[float, Number(0.0, 1.5)]``.

    Attributes
    ----------
    low, high : float
        Allowed range, ends included.
    integer : bool
        Whether only whole numbers are allowed.
    """

    low: float
    high: float
    integer: bool = False

    def validate(self, value: Any) -> float | int:
        """Return the value as `float` or `int`; raise `PydanticCustomError` naming the allowed range."""
        form = "d" if self.integer else "g"
        allowed = f"allowed: {self.low:{form}} to {self.high:{form}}"
        kind, name = ((int,), "a whole number") if self.integer else ((int, float), "a number without unit")
        if not isinstance(value, kind) or isinstance(value, bool):
            raise PydanticCustomError("number", "must be {name} ({allowed})", {"name": name, "allowed": allowed})
        if not self.low <= value <= self.high:
            raise PydanticCustomError("number_range", "is out of range ({allowed})", {"allowed": allowed})
        return value if self.integer else float(value) + _NO_SIGN

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(self.validate)

    def __get_pydantic_json_schema__(self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler) -> dict:
        return {"type": "integer" if self.integer else "number", "minimum": self.low, "maximum": self.high}
