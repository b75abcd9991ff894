"""Numerical settings of ductile cuts by the error that they promise."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from orthocut.params.accuracy import Promise, evidence, outside
from orthocut.params.mpm import MpmCutting
from orthocut.params.quantity import convert

_POINTS = range(3, 61)


class Choice(NamedTuple):
    """What a preset or a tolerance sets."""

    points_per_depth: int
    cut_speed: str
    error_target: float

    @property
    def work(self) -> float:
        """Cost over that of another choice for the same cut: points times steps [-]."""
        return self.points_per_depth**3 / convert(self.cut_speed, "m/s")

    @property
    def packings(self) -> int:
        """Runs that the promise takes: nothing is random."""
        return 1

    def fields(self) -> dict[str, Any]:
        """Raw fields of a case."""
        common = evidence()["common"]
        numerics = {**common["numerics"], "points_per_depth": self.points_per_depth}
        return {**common, "cut_speed": self.cut_speed, "error_target": self.error_target, "numerics": numerics}


def presets() -> dict[str, Choice]:
    """Preset to what it sets."""
    return {name: Choice(**values) for name, values in evidence()["presets"].items()}


def depth_over_zone(case: MpmCutting) -> float:
    """Depth of cut over the length of the cohesive zone E'Gc/sigma_c^2 [-]."""
    zone = case.interface
    return case.cut_depth * zone.strength**2 / (case.material.modulus_plane_strain * zone.toughness)


def promise(case: MpmCutting, choice: Choice) -> Promise | None:
    """Error of a choice for a cut against the limit at zero particle size; None where the evidence does not reach."""
    if any(outside(case, evidence()["domain"])):
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


def cheapest(case: MpmCutting, tolerance: float, packings: int | None = None) -> Choice | None:
    """Cheapest choice whose bound meets a tolerance [-]; None if there is none. Packings play no part."""
    able = (choice for choice in _choices() if (found := promise(case, choice)) and found.bound <= tolerance)
    return min(able, key=lambda choice: (choice.work, -choice.error_target), default=None)


def _choices() -> Iterator[Choice]:
    for row in evidence()["speed"]:
        for target in evidence()["error_targets"]:
            yield from (Choice(points, row["cut_speed"], target) for points in _POINTS)


def why_not(case: MpmCutting, packings: int | None = None) -> str:
    """Why no setting meets a tolerance, and what could be asked for."""
    beyond = list(outside(case, evidence()["domain"]))
    if beyond:
        return f"errors are not known outside of {', '.join(beyond)}; take a preset"
    least = min((found.bound for choice in _choices() if (found := promise(case, choice))), default=math.inf)
    if math.isfinite(least):
        return f"no setting is known to be as good (allowed: {math.ceil(1e3 * least) / 10:g} % or more)"
    limit = evidence()["bias"][-1]["depth_over_zone"]
    return (
        f"errors are not known for a depth of cut of {depth_over_zone(case):.2g} lengths of the cohesive zone "
        f"(allowed: up to {limit:g}); take a preset"
    )
