"""A case: everything that determines one simulation, read from a file or from options."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from orthocut.params import wishes
from orthocut.params.block import Block, ConfigError, describe, hint, shorten, show
from orthocut.params.dem import DemBrazilian, DemCompression, DemCutting, DemTension
from orthocut.params.dem_toughness import DemToughness
from orthocut.params.limits import faults
from orthocut.params.mpm import MpmCutting
from orthocut.params.text import MAX_DEPTH, read_yaml

KINDS: dict[str, type[Block]] = {
    model.model_fields["kind"].default: model
    for model in (MpmCutting, DemCutting, DemTension, DemCompression, DemBrazilian, DemToughness)
}
ALIASES = {"mpm": "mpm_cutting", "dem": "dem_cutting"}
BESIDE = frozenset({"workpiece", "joint"})
"""Blocks of which a preset sets some fields and a case may set others."""
Case = MpmCutting | DemCutting | DemTension | DemCompression | DemBrazilian | DemToughness


def fields(model: type[Block], prefix: str = "") -> Iterator[str]:
    """Dotted names of all fields of a model that hold values, depth first."""
    for name, info in model.model_fields.items():
        nested = block_of(info.annotation)
        yield prefix + name
        if nested is not None:
            yield from fields(nested, f"{prefix}{name}.")


def block_of(annotation: Any) -> type[Block] | None:
    """Block that a field holds, if it holds one."""
    options = getattr(annotation, "__args__", (annotation,))
    return next((option for option in options if isinstance(option, type) and issubclass(option, Block)), None)


def resolve(kind: str, name: str, source: str) -> tuple[str, ...]:
    """Path of a field; a short name such as ``rake_angle`` stands for the one field that ends so.

    Raises
    ------
    ConfigError
        If no field or several fields match.
    """
    if kind in wishes.KNOWN and name in wishes.WISHES:
        return (name,)
    matches = _matches(kind, name)
    if len(matches) == 1:
        return tuple(matches[0].split("."))
    if matches:
        raise ConfigError(f"{source}: {name}: several fields have this name ({', '.join(matches)})")
    raise ConfigError(f"{source}: {shorten(name) or '(nothing)'}: {kind} has no such field; {hint(name, _names(kind))}")


@cache
def _names(kind: str) -> tuple[str, ...]:
    return tuple(fields(KINDS[kind]))


@lru_cache(maxsize=1000)
def _matches(kind: str, name: str) -> tuple[str, ...]:
    """Fields that a name stands for."""
    names = _names(kind)
    return (name,) if name in names else tuple(known for known in names if known.endswith(f".{name}"))


@cache
def _defaults(kind: str) -> Mapping[str, Any]:
    return KINDS[kind]().model_dump(mode="json")


def override(data: Mapping[str, Any], values: Mapping[str, Any], source: str) -> dict[str, Any]:
    """Copy of raw case data with some fields replaced; names may be dotted or short."""
    result = {**data}
    kind = case_kind(result, source)
    for name, value in values.items():
        *parents, leaf = resolve(kind, name, source)
        target = result
        for depth, parent in enumerate(parents, 1):
            inner = target.get(parent)
            if not isinstance(inner, Mapping | None):
                raise ConfigError(f"{source}: {'.'.join(parents[:depth])} = {show(inner)}: must hold fields")
            target[parent] = {**(inner or {})}
            target = target[parent]
        target[leaf] = value
    return result


def case_kind(data: Mapping[str, Any], source: str) -> str:
    """Kind of raw case data; raise `ConfigError` unless it is one of those there are."""
    kind = data.get("kind")
    kind = ALIASES.get(kind, kind) if isinstance(kind, str) else kind
    if not isinstance(kind, str) or kind not in KINDS:
        raise ConfigError(f"{source}: kind = {show(kind)}: must be one of {', '.join(KINDS)}")
    return kind


def validate(data: Mapping[str, Any], source: str = "case") -> Case:
    """Check raw data and return the case; a preset or a tolerance in it becomes ordinary fields.

    Raises
    ------
    ConfigError
        One line a fault: source, field, value, allowed range.
    """
    kind = case_kind(data, source)
    _check_names(data, source)
    if wishes.wishes(data):
        return validate(granted(data, source, packings=1)[0], source)
    try:
        case = KINDS[kind].model_validate(merge(_defaults(kind), {**data, "kind": kind}))
    except ValidationError as error:
        raise describe(error, source, _names(kind)) from None
    found = faults(case)
    if found:
        raise ConfigError("\n".join(f"{source}: {fault}" for fault in found))
    return case


def granted(data: Mapping[str, Any], source: str, packings: int | None = None) -> tuple[dict[str, Any], int]:
    """Raw data with the fields that a preset or a tolerance stands for, and the number of packings that it takes.

    Parameters
    ----------
    data : mapping
        Raw data; without a preset or a tolerance nothing changes.
    source : str
    packings : int, optional
        Packings over which a mean is taken, if their number is given.
    """
    wish = wishes.wishes(data)
    if not wish:
        return {**data}, packings or 1
    kind = case_kind(data, source)
    said = " and ".join(f"{name} = {show(value)}" for name, value in wish.items())
    if kind not in wishes.KNOWN:
        raise ConfigError(f"{source}: {said}: {kind} has none (allowed: in cases of {' and '.join(wishes.KNOWN)})")
    rest = {name: value for name, value in data.items() if name not in wish}
    choice = wishes.choose(validate(rest, source), wish, source, packings)
    chosen = choice.fields()
    twice = sorted(
        name for name in chosen if name in rest and not (name in BESIDE and _apart(chosen[name], rest[name]))
    )
    if twice:
        raise ConfigError(f"{source}: {said}: also sets {', '.join(twice)} (allowed: leave these out)")
    return merge(chosen, rest), packings or choice.packings


def _apart(chosen: Mapping[str, Any], given: Any) -> bool:
    """Whether two sets of fields have none in common."""
    return isinstance(given, Mapping) and not set(chosen) & set(given)


def _check_names(data: Mapping[Any, Any], source: str, depth: int = 1) -> None:
    if depth > MAX_DEPTH:
        raise ConfigError(f"{source}: too many levels of fields in fields (allowed: up to {MAX_DEPTH})")
    for name, value in data.items():
        if not isinstance(name, str):
            raise ConfigError(f"{source}: {show(name)}: field names must be words")
        if isinstance(value, Mapping):
            _check_names(value, f"{source}: {shorten(name)}", depth + 1)


def merge(below: Mapping[str, Any], above: Mapping[str, Any]) -> dict[str, Any]:
    """Raw fields overlaid with others, block by block."""
    merged = {**below}
    for name, value in above.items():
        both = isinstance(value, Mapping) and isinstance(merged.get(name), Mapping)
        merged[name] = merge(merged[name], value) if both else value
    return merged


def load_raw(origin: str | Path) -> dict[str, Any]:
    """Fields of a YAML file as written, or the kind alone if a kind such as ``mpm`` is given."""
    name = str(origin)
    if name in KINDS or name in ALIASES:
        data: Any = {"kind": name}
    else:
        data = read_yaml(Path(origin))
    if not isinstance(data, dict):
        raise ConfigError(f"{name}: must hold the fields of a case")
    return {**data, "kind": case_kind(data, name)}


def load(origin: str | Path, values: Mapping[str, Any] | None = None) -> Case:
    """Read a case from a YAML file, or take the defaults of a kind, then override some fields.

    Parameters
    ----------
    origin : str or Path
        A file, or a kind such as ``mpm`` or ``dem_tension``.
    values : mapping, optional
        Field names to values as a user writes them.
    """
    data, source = load_raw(origin), str(origin)
    if values:
        source += " --set"
        data = override(data, values, source)
    return validate(data, source)
