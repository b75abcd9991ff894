"""What the models say about themselves: the JSON schema of studies and the defaults of all kinds of cases.

``python -m orthocut.params.schema workflow/config`` writes both; a test keeps the files and the models in step.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from orthocut.params import wishes
from orthocut.params.block import Block
from orthocut.params.case import KINDS, block_of
from orthocut.params.quantity import Number, Quantity
from orthocut.params.study import Study

_HEADER = """\
# All fields of all kinds of cases, with their defaults. Generated from src/orthocut/params; do not edit:
#     python -m orthocut.params.schema workflow/config
# A study or a case file gives only what differs; quantities carry units, ratios and coefficients are plain numbers.
# Cuts may also hold `preset` (PRESETS) or `tolerance` (such as 20 %), which stand
# for fields of the method: src/orthocut/params/accuracy.yaml says which, and what they promise.
"""
_PERCENT = {"type": "string", "pattern": "%"}


def study_schema() -> dict[str, Any]:
    """JSON schema (draft 2020-12) of a study file; the base of a sweep is checked against its kind."""
    schema = Study.model_json_schema()
    schema.setdefault("$defs", {})
    for kind, model in KINDS.items():
        body = model.model_json_schema(ref_template="#/$defs/{model}")
        schema["$defs"].update(body.pop("$defs", {}))
        body["required"] = ["kind"]
        schema["$defs"][kind] = body
    for kind, known in wishes.KNOWN.items():
        schema["$defs"][kind]["properties"] |= _wishes(list(known.presets()))
    _partial(schema["$defs"])
    _defaults(schema["$defs"])
    replicates = schema["$defs"]["Sweep"]["properties"]["replicates"]
    count = {limit: replicates.pop(limit) for limit in ("type", "minimum", "maximum")}
    replicates["anyOf"] = [count, _PERCENT]
    schema["$defs"]["Sweep"]["properties"]["base"] = {"oneOf": [{"$ref": f"#/$defs/{kind}"} for kind in KINDS]}
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def _wishes(presets: list[str]) -> dict[str, Any]:
    """Schema of what a cut may hold in place of fields."""
    share = [_PERCENT, {"type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 1}]
    return {
        "preset": {"enum": presets, "description": "Numerical settings by name, in place of fields."},
        "tolerance": {"anyOf": share, "description": "Error of the force; the cheapest settings that promise it."},
    }


def _partial(definitions: dict[str, Any]) -> None:
    """Fields may be left out: they have defaults."""
    for name, body in definitions.items():
        if name not in {"Sweep", "Axes", *KINDS}:
            body.pop("required", None)


def _defaults(definitions: dict[str, Any]) -> None:
    """Write defaults as a user would."""
    for model in _blocks():
        name = model.model_fields["kind"].default if "kind" in model.model_fields else model.__name__
        for field, value in shown(model()).items():
            body = definitions[name]["properties"][field]
            body.pop("default", None)
            if not isinstance(value, dict):
                body["default"] = value


def _blocks() -> Iterator[type[Block]]:
    seen: set[type[Block]] = set()
    pending: list[type[Block]] = list(KINDS.values())
    while pending:
        model = pending.pop()
        if model not in seen:
            seen.add(model)
            yield model
            pending += [b for b in map(block_of, (i.annotation for i in model.model_fields.values())) if b]


def shown(block: Block) -> dict[str, Any]:
    """Fields of a block as a user writes them: quantities in display units."""
    result: dict[str, Any] = {}
    for name, info in type(block).model_fields.items():
        value = getattr(block, name)
        quantity = next((note for note in info.metadata if isinstance(note, Quantity)), None)
        if isinstance(value, Block):
            result[name] = shown(value)
        elif quantity is not None:
            result[name] = quantity.show(value)
        else:
            result[name] = value
    return result


def default_yaml() -> str:
    """Return the defaults of all kinds, with the meaning and the range of every field as comments."""
    names = dict.fromkeys(name for known in wishes.KNOWN.values() for name in known.presets())
    header = _HEADER.replace("PRESETS", ", ".join(names))
    return header + "".join(f"\n{line}" for kind in KINDS.values() for line in _lines(kind(), "")) + "\n"


def _lines(block: Block, indent: str) -> Iterator[str]:
    model = type(block)
    if "kind" in model.model_fields:
        yield f"{block.kind}:"
        indent = "  "
        yield f"{indent}kind: {block.kind}"
    for name, info in model.model_fields.items():
        if name == "kind":
            continue
        value = getattr(block, name)
        nested = block_of(info.annotation)
        meaning = f"  # {' '.join(info.description.split())}" if info.description else ""
        limits = next((note for note in info.metadata if isinstance(note, (Quantity, Number))), None)
        if limits is not None:
            meaning = f"{meaning.rstrip('.')} ({limits.low} to {limits.high})"
        if nested is not None and value is not None:
            yield f"{indent}{name}:{meaning}"
            yield from _lines(value, indent + "  ")
        else:
            yield f"{indent}{name}: {_scalar(shown(block)[name])}{meaning}"
    if "kind" in model.model_fields:
        yield ""


def _scalar(value: Any) -> str:
    if isinstance(value, float):
        return f"{value!r}" if "e" not in repr(value) else f"{value:.6e}"
    return "null" if value is None else str(value)


def files() -> dict[str, str]:
    """File name to content of everything that is generated."""
    return {
        "default.yaml": default_yaml(),
        "study.schema.json": json.dumps(study_schema(), indent=1, sort_keys=True) + "\n",
    }


if __name__ == "__main__":
    for name, content in files().items():
        Path(sys.argv[1], name).write_text(content, encoding="utf-8")
