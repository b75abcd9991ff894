"""Base of all parameter blocks, and the error that users see."""

from __future__ import annotations

import difflib
import reprlib
from collections.abc import Collection, Iterable, Mapping
from typing import Any

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


def refuse_unused(block: Block, choice: str, uses: Mapping[str, Collection[str]]) -> None:
    """Refuse values of fields that the chosen law does not use: equal physics must be the same case.

    Parameters
    ----------
    block : Block
        Block that is being validated.
    choice : str
        Name of the field that holds the choice.
    uses : mapping of str to collection of str
        Each choice to the fields that it uses; a field that stands nowhere here is used by all.

    Raises
    ------
    PydanticCustomError
        Names the first field that differs from its default although the choice does not use it.
    """
    chosen = getattr(block, choice)
    for name in dict.fromkeys(name for names in uses.values() for name in names):
        if name not in uses[chosen] and getattr(block, name) != type(block).model_fields[name].default:
            takers = ", ".join(law for law, names in uses.items() if name in names)
            raise fault(f"{name} is of no use with {choice} = {chosen} (allowed: leave it out, or {choice} = {takers})")


class ConfigError(ValueError):
    """Bad input of a user; the message names source, field, value and what is allowed."""


MAX_LINES = 20
"""Most faults that are told at a time."""


def shorten(text: str, length: int = 60) -> str:
    """Text of at most `length` characters that prints in one line and changes no terminal; the rest is left out."""
    plain = "".join(char if char.isprintable() else "?" for char in text[:length])
    return plain if len(text) <= length else f"{plain}..."


def show(value: Any) -> str:
    """Value as people wrote it, about, in one short line, whatever it is."""
    short = reprlib.Repr()
    short.maxstring = short.maxother = short.maxlong = 60
    short.maxlevel, short.maxdict, short.maxlist = 3, 6, 6
    try:
        return " ".join(short.repr(value).split())
    except ValueError:
        return "a number of thousands of digits"


class CaseFailed(RuntimeError):
    """A case cannot be simulated because of its own numbers; the message says what was seen. It would fail again."""


def hint(name: str, known: Iterable[str]) -> str:
    """Names that resemble a mistyped one, or all of them."""
    name, known = name[:100], list(known)
    short = {entry.rsplit(".", 1)[-1]: entry for entry in known}
    close = difflib.get_close_matches(name, [*known, *short], n=3)
    if close:
        return f"did you mean {' or '.join(dict.fromkeys(short.get(match, match) for match in close))}?"
    return f"allowed: {', '.join(known)}"


_PLAIN = {
    "list_type": "must be a list of values",
    "dict_type": "must map names to values",
    "string_type": "must be words",
    "missing": "is missing",
}
"""Pydantic's type of a fault to words for people."""


def _allowed(block: str, base: type[Block] = Block) -> str:
    """Fields of the block of this name, in brackets."""
    for model in base.__subclasses__():
        if model.__name__ == block:
            return f" (allowed: {', '.join(model.model_fields)})"
        if found := _allowed(block, model):
            return found
    return ""


def describe(error: ValidationError, source: str, known: Iterable[str] = ()) -> ConfigError:
    """Turn pydantic's report into one line a fault: source, field, value, what is wrong, what is allowed.

    Parameters
    ----------
    error : ValidationError
        As raised by a block.
    source : str
        The file or option the values came from.
    known : iterable of str
        Dotted names of the fields there are; the nearest ones are suggested for an unknown field.
    """
    known = list(known)
    lines = []
    reports = error.errors(include_url=False)
    for report in reports[:MAX_LINES]:
        field = shorten(".".join(str(part) for part in report["loc"] if part != "[key]"), 100)
        value = report["input"]
        message = report["msg"]
        if report["type"] == "extra_forbidden":
            message = "no such field" + (f"; {hint(field, known)}" if known else "")
        elif report["type"] == "model_type":
            message = f"must hold the fields of {report['ctx']['class_name']}{_allowed(report['ctx']['class_name'])}"
        message = _PLAIN.get(report["type"], message)
        bare = isinstance(value, (dict, Block)) or report["type"] == "missing"
        shown = field + ("" if bare else f" = {show(value)}")
        lines.append(": ".join(part for part in (source, shown, message) if part))
    if len(reports) > MAX_LINES:
        lines.append(f"{source}: and {len(reports) - MAX_LINES} more")
    return ConfigError("\n".join(lines))
