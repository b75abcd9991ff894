"""Identity of cases and sources: what makes two results the same number."""

from __future__ import annotations

import hashlib
import json
from functools import cache
from pathlib import Path

from orthocut.params.block import Block

_PACKAGE = Path(__file__).resolve().parent.parent
_NUMBERS = ("kernels", "mpm", "dem", "experiments", "measure", "params")
_PICTURES = ("figures", "theory", "variables.py")


def canonical(case: Block) -> str:
    """Canonical JSON of a case: every field, SI units, sorted keys."""
    return json.dumps(case.model_dump(mode="json"), sort_keys=True, separators=(",", ":"))


def case_id(case: Block) -> str:
    """Name of a case: kind, a readable part, a hash of every value that can change its numbers."""
    digest = hashlib.sha256(canonical(case).encode()).hexdigest()[:10]
    return f"{case.kind.replace('_', '-')}-{digest}"


def _digest(parts: tuple[str, ...]) -> str:
    sha = hashlib.sha256()
    for part in parts:
        path = _PACKAGE / part
        for file in sorted(path.rglob("*.py")) if path.is_dir() else [path]:
            sha.update(str(file.relative_to(_PACKAGE)).encode() + b"\0" + file.read_bytes() + b"\0")
    return sha.hexdigest()[:16]


@cache
def digest_numbers() -> str:
    """Digest of the sources that can change a simulation's numbers."""
    return _digest(_NUMBERS)


@cache
def digest_pictures() -> str:
    """Digest of the sources that only change figures and tables."""
    return _digest(_PICTURES)
