"""Base of all parameter blocks, and the error that users see."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, ValidationError
from pydantic_core import PydanticCustomError


class Block(BaseModel):
    """A frozen, strict group of parameters: no unknown fields, no silent conversions."""

    model_config = ConfigDict(
        frozen=True, extra="forbid", strict=True, allow_inf_nan=False, use_attribute_docstrings=True
    )


def fault(message: str) -> PydanticCustomError:
    """Error to raise in a validator; the message names the field, the value and what is allowed."""
    return PydanticCustomError("invalid", "{message}", {"message": message})


class ConfigError(ValueError):
    """Bad input of a user; the message names source, field, value and what is allowed."""


def describe(error: ValidationError, source: str) -> ConfigError:
    """Turn pydantic's report into one line a fault: source, field, value, what is wrong, what is allowed.

    Parameters
    ----------
    error : ValidationError
        As raised by a block.
    source : str
        The file or option the values came from.
    """
    lines = []
    for report in error.errors(include_url=False):
        field = ".".join(str(part) for part in report["loc"]) or "case"
        value = report["input"]
        shown = "" if isinstance(value, dict) or report["type"] == "missing" else f" = {value!r}"
        lines.append(f"{source}: {field}{shown}: {report['msg']}")
    return ConfigError("\n".join(lines))
