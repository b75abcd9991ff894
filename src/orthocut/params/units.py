"""Units that cases may be written in: one small table and the products, quotients and powers of its rows."""

from __future__ import annotations

import math
import re
from functools import cache

Dimensions = tuple[int, int, int, int]
"""Powers of metre, kilogram, second and radian."""

_METRE, _KILOGRAM, _SECOND, _RADIAN = (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)
_NEWTON, _PASCAL, _JOULE = (1, 1, -2, 0), (-1, 1, -2, 0), (2, 1, -2, 0)

UNITS: dict[str, tuple[float, Dimensions]] = {
    **{name: (scale, _METRE) for name, scale in {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "nm": 1e-9}.items()},
    **{name: (scale, _SECOND) for name, scale in {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}.items()},
    **{name: (scale, _SECOND) for name, scale in {"min": 60.0, "h": 3600.0}.items()},
    **{name: (scale, _KILOGRAM) for name, scale in {"kg": 1.0, "g": 1e-3, "mg": 1e-6}.items()},
    **{name: (scale, _RADIAN) for name, scale in {"rad": 1.0, "mrad": 1e-3, "deg": math.pi / 180.0}.items()},
    **{name: (scale, _NEWTON) for name, scale in {"N": 1.0, "mN": 1e-3, "kN": 1e3, "MN": 1e6}.items()},
    **{name: (scale, _PASCAL) for name, scale in {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "TPa": 1e12}.items()},
    **{name: (scale, _JOULE) for name, scale in {"J": 1.0, "mJ": 1e-3, "kJ": 1e3, "MJ": 1e6}.items()},
}
"""Name to its value in SI units and its dimensions."""

_SPELLINGS = {"µ": "u", "μ": "u", "°": "deg", "**": "^"}
_FACTOR = re.compile(r"(?P<sign>\s*[*/]\s*|\s+|^)(?P<name>[a-zA-Z]+)(\^(?P<power>-?[1-9]))?(?![0-9])")


@cache
def unit_of(text: str) -> tuple[float, Dimensions]:
    """Value in SI and dimensions of a unit such as ``"kg/m^3"`` or ``"mm/min"``.

    Raises
    ------
    ValueError
        If the text is not a product of units of the table.
    """
    for spelling, plain in _SPELLINGS.items():
        text = text.replace(spelling, plain)
    scale, dimensions, at = 1.0, (0, 0, 0, 0), 0
    while at < len(text):
        factor = _FACTOR.match(text, at)
        if factor is None or factor["name"] not in UNITS:
            raise ValueError(f"{text!r} is not a unit (known: {', '.join(UNITS)})")
        value, powers = UNITS[factor["name"]]
        power = int(factor["power"] or 1) * (-1 if "/" in factor["sign"] else 1)
        scale *= value**power
        dimensions = tuple(a + power * b for a, b in zip(dimensions, powers, strict=True))
        at = factor.end()
    return scale, dimensions
