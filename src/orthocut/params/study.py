"""Studies: sweeps of cases, and the figures that are drawn from them."""

from __future__ import annotations

import itertools
import math
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, ValidationError, model_validator

from orthocut.params.block import Block, ConfigError, describe, fault, hint, shorten, show
from orthocut.params.case import KINDS, Case, case_kind, granted, override, resolve, validate
from orthocut.params.identity import case_id
from orthocut.params.quantity import Number
from orthocut.params.replicates import counted
from orthocut.params.text import Line, Name, read_yaml

Values = dict[str, list[Any]]
MAX_CASES = 100_000
"""Most cases of a study, all sweeps together; more is a slip of the pen."""


class Axes(Block):
    """How a sweep varies its base case; the parts multiply."""

    product: Values = Field(default_factory=dict)
    """Field to values; every combination."""
    zip: Values = Field(default_factory=dict)
    """Field to values; element by element."""
    list: Annotated[list[dict[str, Any]], Field(default_factory=list)]
    """Explicit sets of fields and values."""

    @model_validator(mode="after")
    def _equal(self) -> Axes:
        lengths = {name: len(values) for name, values in self.zip.items()}
        if len(set(lengths.values())) > 1:
            raise fault(f"zip: lists differ in length ({show(lengths)}) (allowed: lists of one length)")
        for name, values in {**self.product, **self.zip}.items():
            if not values:
                raise fault(f"axis {shorten(name)} has no values (allowed: one or more)")
        if "list" in self.model_fields_set and not self.list:
            raise fault("list has no sets of values (allowed: one or more)")
        return self

    def count(self) -> int:
        """Count the points without making them."""
        zipped = len(next(iter(self.zip.values()), [None]))
        return math.prod(map(len, self.product.values())) * zipped * (len(self.list) or 1)

    def points(self) -> list[dict[str, Any]]:
        """Sets of fields and values, in the order written, the last axis fastest."""
        products = [
            dict(zip(self.product, values, strict=True)) for values in itertools.product(*self.product.values())
        ]
        zipped = [dict(zip(self.zip, values, strict=True)) for values in zip(*self.zip.values(), strict=True)] or [{}]
        return [{**a, **b, **c} for a in products for b in zipped for c in (self.list or [{}])]

    def check_names(self, kind: str, source: str) -> None:
        """Raise `ConfigError` if an axis is no field of the kind, or if two vary the same field or a part of it."""
        always = [("product", name) for name in self.product] + [("zip", name) for name in self.zip]
        for point in self.list or [{}]:
            seen: dict[tuple[str, ...], str] = {}
            for part, name in [*always, *(("list", name) for name in point)]:
                path = resolve(kind, name, f"{source}.axes.{part}")
                if path == ("kind",):
                    raise ConfigError(f"{source}.axes.{part}: kind cannot vary (allowed: one kind a sweep)")
                for other, by in seen.items():
                    if all(a == b for a, b in zip(path, other, strict=False)):
                        field = ".".join(other)
                        raise ConfigError(f"{source}.axes.{part}: {name} is already varied by {by} (as {field})")
                seen[path] = part


class Sweep(Block):
    """A base case, axes and replicates."""

    base: dict[str, Any]
    """Fields of the base case; must hold its kind."""
    axes: Axes = Field(default_factory=Axes)
    """What varies."""
    replicates: Annotated[int, Number(1, 1000, integer=True)] = 1
    """Random replicates of each point; replicate k of a packing with seed s has seed s + k. Cuts of glass may have a
    share such as ``10 %`` in its place: as many packings as the mean main force needs to be known to that. With a
    preset or a tolerance as many as that takes, if not given."""
    snapshots: Annotated[int, Number(2, 200, integer=True)] = 6
    """Snapshots of each run, if a figure draws any; more of them change no other number."""

    @model_validator(mode="before")
    @classmethod
    def _replicates(cls, data: Any) -> Any:
        base = data.get("base") if isinstance(data, dict) else None
        if not isinstance(base, dict) or "replicates" not in data:
            return data
        return {**data, "replicates": counted(data["replicates"], base)}

    def expand(self, source: str) -> list[tuple[str, Case]]:
        """Return a label and the case of every member, in order.

        Raises
        ------
        ConfigError
            Names the field, the value and what is allowed.
        """
        kind = case_kind(self.base, source)
        if self.replicates > 1 and "packing" not in KINDS[kind].model_fields:
            raise ConfigError(f"{source}: replicates = {self.replicates}: {kind} has nothing random (allowed: 1)")
        self.axes.check_names(kind, source)
        given = self.replicates if "replicates" in self.model_fields_set else None
        members = []
        for point in self.axes.points():
            label = ", ".join(f"{name} {_words(value)}" for name, value in point.items())
            data, count = granted(override(self.base, point, source), source, given)
            case = validate(data, source)
            members.append((label, case))
            for k in range(1, count):
                seed = case.packing.seed + k
                twin = validate(override(data, {"packing.seed": seed}, source), source)
                members.append((", ".join(filter(None, (label, f"seed {seed}"))), twin))
        return members


def _words(value: Any) -> str:
    """Value of an axis in a label."""
    return shorten(" ".join(value.split())) if isinstance(value, str) else show(value)


class Study(Block):
    """Named sweeps and, for each figure or table, the sweeps it draws."""

    title: Line
    """One line for people."""
    sweeps: dict[Name, Sweep]
    """Name to sweep."""
    figures: dict[Name, list[str]]
    """Figure to the names of the sweeps that it draws; a figure of theory alone has none."""

    @model_validator(mode="after")
    def _known(self) -> Study:
        for figure, names in self.figures.items():
            for name in names:
                if name not in self.sweeps:
                    raise fault(f"figures.{shorten(figure)} = {show(name)}: no such sweep; {hint(name, self.sweeps)}")
        if not self.sweeps and not self.figures:
            raise fault("sweeps and figures are both empty (allowed: one or more of either)")
        return self

    @model_validator(mode="after")
    def _bounded(self) -> Study:
        total = 0
        for name, sweep in self.sweeps.items():
            count = sweep.axes.count() * sweep.replicates
            total += count
            if total > MAX_CASES:
                raise fault(
                    f"sweeps.{name}: has {_round(count)} cases, {_round(total)} with the sweeps before it "
                    f"(allowed: up to {MAX_CASES})"
                )
        return self

    def expand(self, source: str = "study") -> tuple[dict[str, dict[str, Case]], dict[str, str]]:
        """Expand all sweeps, once.

        Returns
        -------
        cases : dict
            Sweep name to case id to case; the same case in two sweeps has the same id.
        labels : dict
            Case id to words for people: the first sweep that holds the case and the values varied there.
        """
        cases: dict[str, dict[str, Case]] = {}
        labels: dict[str, str] = {}
        for name, sweep in self.sweeps.items():
            cases[name] = {}
            words: dict[str, str] = {}
            for label, case in sweep.expand(f"{source}: sweeps.{name}"):
                key = case_id(case)
                if key in words:
                    raise ConfigError(
                        f"{source}: sweeps.{name}: '{label}' and '{words[key]}' are the same case "
                        "(allowed: each case once in a sweep)"
                    )
                words[key] = label
                cases[name][key] = case
                labels.setdefault(key, f"{name}: {label}" if label else name)
        count = sum(map(len, cases.values()))
        if count > MAX_CASES:
            raise ConfigError(f"{source}: has {count} cases (allowed: up to {MAX_CASES})")
        return cases, labels

    def cases(self, source: str = "study") -> dict[str, dict[str, Case]]:
        """Sweep name to case id to case."""
        return self.expand(source)[0]


def _round(count: int) -> str:
    """Whole number, in full unless it is very long."""
    return str(count) if count < 10**30 else f"more than 10^{int(count.bit_length() * math.log10(2)) - 1}"


def load_study(path: Path) -> Study:
    """Read a study; `ConfigError` names file, field, value and what is allowed."""
    data = read_yaml(path)
    if not isinstance(data, dict) or not all(isinstance(name, str) for name in data):
        raise ConfigError(f"{path}: must hold title, sweeps and figures")
    try:
        return Study.model_validate(data)
    except ValidationError as error:
        raise describe(error, str(path), Study.model_fields) from None
