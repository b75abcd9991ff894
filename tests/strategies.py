"""Studies that hypothesis makes up, and many ways to write each of them."""

from __future__ import annotations

from decimal import Decimal
from typing import Any, NamedTuple

import yaml
from hypothesis import strategies as st

UNITS = {
    "um": {"um": 0, "mm": -3, "cm": -4, "m": -6, "µm": 0},
    "mm/s": {"mm/s": 0, "m/s": -3, "um/ms": 0, "mm s^-1": 0},
    "deg": {"deg": 0, "°": 0},
    "MPa": {"MPa": 0, "GPa": -3, "kPa": 3, "Pa": 6, "N/mm^2": 0, "N / mm**2": 0},
}
"""Unit of the numbers below to units and the powers of ten that turn a number into them."""


class Amount(NamedTuple):
    """A quantity before it is written down."""

    number: int
    unit: str


class Range(NamedTuple):
    """Whole numbers of a unit that a field takes in every case made up here; plain numbers without a unit."""

    low: int
    high: int
    unit: str = ""


FIELDS: dict[str, dict[str, Range]] = {
    "mpm_cutting": {
        "cut_depth": Range(100, 5000, "um"),
        "cut_speed": Range(500, 20_000, "mm/s"),
        "tool.rake_angle": Range(-20, 40, "deg"),
        "tool.clearance_angle": Range(0, 15, "deg"),
        "tool.friction": Range(0, 1),
        "material.modulus_tangent": Range(0, 300, "MPa"),
        "interface.strength": Range(1, 400, "MPa"),
        "numerics.points_per_depth": Range(2, 20),
    },
    "dem_cutting": {
        "cut_depth": Range(50, 400, "um"),
        "travel": Range(50, 800, "um"),
        "tool.rake_angle": Range(-30, 40, "deg"),
        "joint.modulus": Range(10_000, 200_000, "MPa"),
        "joint.elements": Range(1, 4),
        "grooves.width": Range(40, 100, "um"),
        "grooves.distance": Range(50, 300, "um"),
        "grooves.bottom_ratio": Range(0, 1),
    },
    "dem_tension": {
        "packing.width": Range(500, 2000, "um"),
        "grip_speed": Range(1, 50, "mm/s"),
        "joint.strength_tensile": Range(10, 1000, "MPa"),
    },
}


def values(field: Range) -> st.SearchStrategy:
    """Values of a field."""
    numbers = st.integers(field.low, field.high)
    return numbers.map(lambda number: Amount(number, field.unit)) if field.unit else numbers


@st.composite
def sweeps(draw: st.DrawFn) -> dict[str, Any]:
    """Draw a sweep with axes of all sorts, no field varied twice and no value there twice."""
    kind = draw(st.sampled_from(sorted(FIELDS)))
    names = draw(st.permutations(sorted(FIELDS[kind])))
    base: dict[str, Any] = {"kind": kind}
    axes: dict[str, Any] = {}

    def several(name: str, count: int) -> list[Any]:
        return draw(st.lists(values(FIELDS[kind][name]), min_size=count, max_size=count, unique=True))

    sizes = [draw(st.integers(1, 2)) for _ in range(3)]
    if draw(st.booleans()):
        axes["product"] = {names[0]: several(names[0], sizes[0])}
    if draw(st.booleans()):
        axes["zip"] = {names[1]: several(names[1], sizes[1])}
    if draw(st.booleans()):
        axes["list"] = [{names[2]: value} for value in several(names[2], sizes[2])]
    for name in names[3:]:
        if draw(st.booleans()):
            block, _, leaf = name.rpartition(".")
            (base.setdefault(block, {}) if block else base)[leaf] = draw(values(FIELDS[kind][name]))
    sweep: dict[str, Any] = {"base": base}
    if axes or draw(st.booleans()):
        sweep["axes"] = axes
    if kind != "mpm_cutting" and draw(st.booleans()):
        sweep["replicates"] = draw(st.integers(1, 3))
    return sweep


NAMES = st.from_regex(r"[A-Za-z][A-Za-z0-9_-]{0,20}", fullmatch=True)
NOT_WORDS = ("true", "false", "null", "nan", "inf")
"""What YAML does not read as words."""
LINES = st.text(st.characters(codec="utf-8", categories=("L", "N", "P", "Zs", "So")), min_size=1, max_size=40).filter(
    lambda text: text.isprintable() and text[0].isalpha() and text.lower() not in NOT_WORDS
)


COMMENTS = ["", "a comment", "{[ 'not' closed", "cut_depth: 1 mm"]


def studies() -> st.SearchStrategy[dict[str, Any]]:
    """Studies that are right, as maps of words, numbers and amounts."""
    return st.fixed_dictionaries(
        {
            "title": LINES,
            "sweeps": st.dictionaries(NAMES, sweeps(), min_size=1, max_size=3),
            "figures": st.just({"nairn2015_fig07": []}),
        }
    )


def spell(draw: st.DrawFn, data: Any) -> Any:
    """Write the same again: units, exponents and the order of keys as they come."""
    if isinstance(data, Amount):
        unit, power = draw(st.sampled_from(sorted(UNITS[data.unit].items())))
        number = Decimal(data.number).scaleb(power)
        form = draw(st.sampled_from(["{:f} {}", "{:e} {}", " {:f}   {} ", "{:+f} {}"]))
        return form.format(number, unit)
    if isinstance(data, dict):
        return {key: spell(draw, data[key]) for key in draw(st.permutations(list(data)))}
    if isinstance(data, list):
        return [spell(draw, item) for item in data]
    return data


@st.composite
def written(draw: st.DrawFn, data: Any) -> str:
    """Draw a text that holds a study: style, comments, ends of lines, a byte-order mark."""
    plain = spell(draw, data)
    text = yaml.safe_dump(
        plain, sort_keys=False, allow_unicode=True, default_flow_style=draw(st.sampled_from([None, False])), width=10**6
    )
    lines = [f"{line}  # {draw(st.sampled_from(COMMENTS))}" for line in text.splitlines()]
    end = draw(st.sampled_from(["\n", "\r\n"]))
    return draw(st.sampled_from(["", "\ufeff"])) + end.join(["# a study", "", *lines, ""])
