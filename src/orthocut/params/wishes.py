"""Presets and tolerances: what a case may say of the error that it wants, in place of numerical settings.

``preset: standard`` or ``tolerance: 10 %`` becomes ordinary fields before a case is checked, so that nothing else knows
of them. What they promise stands in ``accuracy.yaml``.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import ModuleType
from typing import Any

from orthocut.params import accuracy_ductile, accuracy_glass
from orthocut.params.accuracy import percent
from orthocut.params.block import Block, ConfigError, hint, show

WISHES = ("preset", "tolerance")
"""What a case may hold in place of fields."""
KNOWN: dict[str, ModuleType] = {"mpm_cutting": accuracy_ductile, "dem_cutting": accuracy_glass}
"""Kind of cases that may to what is known of it."""


def wishes(data: Mapping[str, Any]) -> dict[str, Any]:
    """Preset and tolerance that raw data hold."""
    return {name: data[name] for name in WISHES if name in data}


def choose(case: Block, wish: Mapping[str, Any], source: str, packings: int | None = None) -> Any:
    """Choice that a preset or a tolerance stands for.

    Parameters
    ----------
    case : Block
        The cut without it, of one of the `KNOWN` kinds.
    wish : mapping
        One of `WISHES` and its value.
    source : str
        The file or option that it came from.
    packings : int, optional
        Packings over which a mean is taken, if their number is given.

    Returns
    -------
    Choice of the module of the kind
        With its ``fields()`` and the number of ``packings`` that it takes.

    Raises
    ------
    ConfigError
        If there is no such preset, if both are given, or if no setting is known to meet the tolerance.
    """
    known = KNOWN[case.kind]
    if len(wish) > 1:
        raise ConfigError(f"{source}: preset and tolerance are both given (allowed: one of them)")
    if "preset" in wish:
        name, presets = wish["preset"], known.presets()
        if not isinstance(name, str) or name not in presets:
            raise ConfigError(f"{source}: preset = {show(name)}: no such preset; {hint(str(name), presets)}")
        return presets[name]
    tolerance = _share(wish["tolerance"], source)
    found = known.cheapest(case, tolerance, packings)
    if found is None:
        raise ConfigError(f"{source}: tolerance = {tolerance:.3g}: {known.why_not(case, packings)}")
    return found


def _share(value: Any, source: str) -> float:
    """Tolerance as a share of the force: ``2 %`` or 0.02."""
    number = percent(value) if isinstance(value, str) else value
    if isinstance(number, bool) or not isinstance(number, int | float) or not 0 < number < 1:
        raise ConfigError(f"{source}: tolerance = {show(value)}: must be a share of the force, such as 10 % or 0.1")
    return float(number)
