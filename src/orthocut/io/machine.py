"""What steps cost on this machine over what the cost model says: measured once, kept in the user's cache folder."""

from __future__ import annotations

import json
import os
import platform
from pathlib import Path

from orthocut.io.files import write_text


def factors() -> dict[str, float]:
    """Method to measured over predicted cost; methods that were never measured on this machine are left out."""
    try:
        found = json.loads(_file().read_text(encoding="utf-8"))
        return {str(method): float(factor) for method, factor in found.items() if float(factor) > 0}
    except (OSError, ValueError, TypeError, AttributeError):
        return {}


def remember(method: str, factor: float) -> None:
    """Keep what was measured.

    Parameters
    ----------
    method : str
        ``mpm`` or ``dem``.
    factor : float
        Measured over predicted cost of a step [-].
    """
    file = _file()
    file.parent.mkdir(parents=True, exist_ok=True)
    write_text(json.dumps(factors() | {method: factor}, indent=1) + "\n", file)


def _file() -> Path:
    """One file a machine: home folders may be shared."""
    home = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(home) / "orthocut" / "machines" / f"{platform.node() or 'unknown'}.json"
