"""Seals: a last line of a file that tells what the file is, and whether a single bit of it has changed.

netCDF readers do not look behind the end of their data, so that a sealed file opens as any other. The seal is read and
checked without them, in microseconds.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

_START = b"\northocut-seal "
_DIGITS = 64


class Broken(ValueError):
    """A file that is truncated, altered or was never sealed; the message says which."""


def seal(path: Path, facts: dict[str, Any]) -> None:
    """Add a seal to the end of a file.

    Parameters
    ----------
    path : Path
        File that has no seal yet.
    facts : dict
        What the seal tells, as JSON.
    """
    line = _START + json.dumps(facts, sort_keys=True, separators=(",", ":")).encode() + b" "
    with open(path, "rb") as file:
        digest = hashlib.file_digest(file, "sha256")
    digest.update(line)
    with open(path, "ab") as file:
        file.write(line + digest.hexdigest().encode() + b"\n")


def unseal(path: Path) -> dict[str, Any]:
    """Check the seal of a file and return what it tells.

    Raises
    ------
    Broken
        If the file has no seal or does not match it.
    OSError
        If the file cannot be read.
    """
    content = path.read_bytes()
    start = content.rfind(_START)
    if start < 0 or not content.endswith(b"\n"):
        raise Broken("the file is truncated: it has no seal at its end")
    if hashlib.sha256(content[: -_DIGITS - 1]).hexdigest().encode() != content[-_DIGITS - 1 : -1]:
        raise Broken("the file has changed since it was written: its checksum does not match")
    return json.loads(content[start + len(_START) : -_DIGITS - 2])
