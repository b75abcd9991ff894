"""Studies: sweeps of cases, and the figures that are drawn from them."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, ValidationError, model_validator

from orthocut.params.block import Block, ConfigError, describe, fault
from orthocut.params.case import Case, override, read_yaml, validate
from orthocut.params.identity import case_id
from orthocut.params.quantity import Number

Values = dict[str, list[Any]]


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
            raise fault(f"zip: lists differ in length ({lengths})")
        for name, values in {**self.product, **self.zip}.items():
            if not values:
                raise fault(f"axis {name} has no values (allowed: one or more)")
        return self

    def points(self) -> list[dict[str, Any]]:
        """Sets of fields and values, in the order written, the last axis fastest."""
        products = [
            dict(zip(self.product, values, strict=True)) for values in itertools.product(*self.product.values())
        ]
        zipped = [dict(zip(self.zip, values, strict=True)) for values in zip(*self.zip.values(), strict=True)] or [{}]
        return [{**a, **b, **c} for a in products for b in zipped for c in (self.list or [{}])]


class Sweep(Block):
    """A base case, axes and replicates."""

    base: dict[str, Any]
    """Fields of the base case; must hold its kind."""
    axes: Axes = Field(default_factory=lambda: Axes(list=[]))
    replicates: Annotated[int, Number(1, 1000, integer=True)] = 1
    """Random replicates of each point; replicate k of a packing with seed s has seed s + k."""

    def expand(self, source: str) -> list[Case]:
        """Return all cases of the sweep, in order."""
        cases = []
        for point in self.axes.points():
            data = override(self.base, point, source)
            case = validate(data, source)
            cases.append(case)
            if self.replicates > 1 and not hasattr(case, "packing"):
                raise ConfigError(
                    f"{source}: replicates = {self.replicates}: {case.kind} has nothing random (allowed: 1)"
                )
            cases += [
                validate(override(data, {"packing.seed": case.packing.seed + k}, source), source)
                for k in range(1, self.replicates)
            ]
        return cases


class Study(Block):
    """Named sweeps and, for each figure or table, the sweeps it draws."""

    title: str
    sweeps: dict[str, Sweep]
    figures: dict[str, list[str]]

    @model_validator(mode="after")
    def _known(self) -> Study:
        for figure, names in self.figures.items():
            for name in names:
                if name not in self.sweeps:
                    raise fault(f"figures.{figure} names the sweep '{name}' (known: {', '.join(self.sweeps)})")
        return self

    def cases(self, source: str = "study") -> dict[str, dict[str, Case]]:
        """Sweep name to case id to case; the same case in two sweeps has the same id."""
        return {
            name: {case_id(case): case for case in sweep.expand(f"{source}: sweeps.{name}")}
            for name, sweep in self.sweeps.items()
        }


def load_study(path: Path) -> Study:
    """Read a study; `ConfigError` names file, field, value and what is allowed."""
    data = read_yaml(path)
    if not isinstance(data, dict):
        raise ConfigError(f"{path}: must hold title, sweeps and figures")
    try:
        return Study.model_validate(data)
    except ValidationError as error:
        raise describe(error, str(path)) from None
