"""Presets and tolerances: numerical settings of ductile cuts by what they promise, from the evidence of one data file.

A case may hold ``preset: standard`` or ``tolerance: 10 %`` in place of fields; both become ordinary fields before it is
checked, so that nothing else knows of them. What they promise stands in ``accuracy.yaml``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from orthocut.params.block import ConfigError, hint, show
from orthocut.params.mpm import MpmCutting
from orthocut.params.quantity import convert
from orthocut.params.text import read_yaml

WISHES = ("preset", "tolerance")
"""What a case may hold in place of fields."""
KIND = "mpm_cutting"
"""The kind of cases that may; mean forces of cuts of glass are not known well enough."""
_POINTS = range(3, 61)
_DOMAIN_UNITS = {"tool.rake_angle": "rad", "material.modulus_tangent": "Pa", "interface.strength": "Pa"}


class Promise(NamedTuple):
    """Relative error of a mean cutting force against its limit at zero particle size."""

    bound: float
    """What 9 of 10 cuts keep to [-]."""
    typical: float
    """What every other cut keeps to [-]."""


class Choice(NamedTuple):
    """What a preset or a tolerance sets."""

    points_per_depth: int
    cut_speed: str
    error_target: float

    @property
    def work(self) -> float:
        """Cost over that of another choice for the same cut: points times steps [-]."""
        return self.points_per_depth**3 / convert(self.cut_speed, "m/s")

    def fields(self) -> dict[str, Any]:
        """Raw fields of a case."""
        common = evidence()["common"]
        numerics = {**common["numerics"], "points_per_depth": self.points_per_depth}
        return {**common, "cut_speed": self.cut_speed, "error_target": self.error_target, "numerics": numerics}


@cache
def evidence() -> dict[str, Any]:
    """Content of the data file."""
    return read_yaml(Path(__file__).with_suffix(".yaml"))


def presets() -> dict[str, Choice]:
    """Preset to what it sets."""
    return {name: Choice(**values) for name, values in evidence()["presets"].items()}


def depth_over_zone(case: MpmCutting) -> float:
    """Depth of cut over the length of the cohesive zone E'Gc/sigma_c^2 [-]."""
    zone = case.interface
    return case.cut_depth * zone.strength**2 / (case.material.modulus_plane_strain * zone.toughness)


def promise(case: MpmCutting, choice: Choice) -> Promise | None:
    """Error of a choice for a cut; None where the evidence does not reach."""
    if any(outside(case)):
        return None
    depth = depth_over_zone(case)
    row = next((row for row in evidence()["bias"] if depth <= row["depth_over_zone"]), None)
    if row is None:
        return None
    speed = convert(choice.cut_speed, "m/s")
    added = next(one["error"] for one in evidence()["speed"] if speed <= convert(one["cut_speed"], "m/s"))
    noise = evidence()["scatter"] * choice.error_target
    bound, typical = (
        math.sqrt((row[name] / choice.points_per_depth) ** 2 + noise**2 + added**2) for name in Promise._fields
    )
    return Promise(bound, typical)


def outside(case: MpmCutting) -> Iterator[str]:
    """Fields in which a cut lies outside of the evidence: name, and what it spans."""
    for name, limits in evidence()["domain"].items():
        block, field = name.split(".")
        unit = _DOMAIN_UNITS.get(name)
        low, high = (convert(limit, unit) if unit else limit for limit in limits)
        if not low - 1e-9 * abs(low) <= getattr(getattr(case, block), field) <= high * (1 + 1e-9):
            yield f"{name} ({show(limits[0])} to {show(limits[1])})".replace("'", "")


def cheapest(case: MpmCutting, tolerance: float) -> Choice | None:
    """Cheapest choice whose bound meets a tolerance [-]; None if there is none."""
    able = (choice for choice in _choices() if (found := promise(case, choice)) and found.bound <= tolerance)
    return min(able, key=lambda choice: (choice.work, -choice.error_target), default=None)


def best(case: MpmCutting) -> float:
    """Least bound that a choice can promise for a cut [-]; infinite where the evidence does not reach."""
    return min((found.bound for choice in _choices() if (found := promise(case, choice))), default=math.inf)


def _choices() -> Iterator[Choice]:
    for row in evidence()["speed"]:
        for target in evidence()["error_targets"]:
            yield from (Choice(points, row["cut_speed"], target) for points in _POINTS)


def wishes(data: Mapping[str, Any]) -> dict[str, Any]:
    """Preset and tolerance that raw data hold."""
    return {name: data[name] for name in WISHES if name in data}


def choose(case: MpmCutting, wish: Mapping[str, Any], source: str) -> Choice:
    """Choice that a preset or a tolerance stands for.

    Parameters
    ----------
    case : MpmCutting
        The cut without it.
    wish : mapping
        One of `WISHES` and its value.
    source : str
        The file or option that it came from.

    Raises
    ------
    ConfigError
        If there is no such preset, if both are given, or if no setting is known to meet the tolerance.
    """
    if len(wish) > 1:
        raise ConfigError(f"{source}: preset and tolerance are both given (allowed: one of them)")
    if "preset" in wish:
        name, known = wish["preset"], presets()
        if not isinstance(name, str) or name not in known:
            raise ConfigError(f"{source}: preset = {show(name)}: no such preset; {hint(str(name), known)}")
        return known[name]
    tolerance = _share(wish["tolerance"], source)
    found = cheapest(case, tolerance)
    if found is None:
        raise ConfigError(f"{source}: tolerance = {tolerance:.3g}: {_why_not(case)}")
    return found


def _why_not(case: MpmCutting) -> str:
    """Why no setting meets a tolerance, and what could be asked for."""
    beyond = list(outside(case))
    if beyond:
        return f"errors are not known outside of {', '.join(beyond)}; take a preset"
    least = best(case)
    if math.isfinite(least):
        return f"no setting is known to be as good (allowed: {math.ceil(1e3 * least) / 10:g} % or more)"
    limit = evidence()["bias"][-1]["depth_over_zone"]
    return (
        f"errors are not known for a depth of cut of {depth_over_zone(case):.2g} lengths of the cohesive zone "
        f"(allowed: up to {limit:g}); take a preset"
    )


def percent(value: Any) -> float | None:
    """Share that a text such as ``2 %`` states; None for anything else."""
    form = re.fullmatch(r"\s*([0-9]+\.?[0-9]*)\s*%\s*", value) if isinstance(value, str) else None
    return float(form[1]) / 100 if form else None


def _share(value: Any, source: str) -> float:
    """Tolerance as a share of the force: ``2 %`` or 0.02."""
    number = percent(value) if isinstance(value, str) else value
    if isinstance(number, bool) or not isinstance(number, int | float) or not 0 < number < 1:
        raise ConfigError(f"{source}: tolerance = {show(value)}: must be a share of the force, such as 10 % or 0.1")
    return float(number)
