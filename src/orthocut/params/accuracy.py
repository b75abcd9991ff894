"""What is known of the errors of cutting forces: the data file, and where it holds."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from orthocut.params.block import Block, show
from orthocut.params.quantity import convert
from orthocut.params.text import read_yaml


class Promise(NamedTuple):
    """Relative error of a mean cutting force against its limit."""

    bound: float
    """What 9 of 10 cuts keep to [-]."""
    typical: float
    """What every other cut keeps to [-]."""


@cache
def evidence() -> dict[str, Any]:
    """Content of the data file."""
    return read_yaml(Path(__file__).with_suffix(".yaml"))


def outside(case: Block, domain: Mapping[str, list[Any]]) -> Iterator[str]:
    """Fields in which a case lies outside of a domain: name, and what it spans.

    Parameters
    ----------
    case : Block
    domain : mapping
        Dotted name of a field to its smallest and largest value, numbers or texts with SI units and their multiples.
    """
    for name, limits in domain.items():
        value: Any = case
        for part in name.split("."):
            value = getattr(value, part)
        low, high = (_si(limit) for limit in limits)
        if not low - 1e-9 * abs(low) <= value <= high + 1e-9 * abs(high):
            yield f"{name} ({show(limits[0])} to {show(limits[1])})".replace("'", "")


def _si(limit: Any) -> float:
    """Number of a limit in SI units."""
    return convert(limit, _BASE[limit.split()[-1]]) if isinstance(limit, str) else limit


_BASE = {"deg": "rad", "MPa": "Pa", "GPa": "Pa", "mm": "m", "um": "m"}
"""Unit to that of cases."""


def percent(value: Any) -> float | None:
    """Share that a text such as ``2 %`` states; None for anything else."""
    form = re.fullmatch(r"\s*([0-9]+\.?[0-9]*)\s*%\s*", value) if isinstance(value, str) else None
    return float(form[1]) / 100 if form else None
