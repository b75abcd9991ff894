"""Series of runs that differ in one field of the case, and words for what tells the series apart."""

from __future__ import annotations

from typing import Any

import xarray as xr

from orthocut.figures.canvas import cases
from orthocut.io.collect import case_of, parameters
from orthocut.variables import VARIABLES

Series = list[tuple[str, list[xr.Dataset]]]
"""Name of each series and its runs, in order of the field."""


def transfers(affine: float) -> str:
    """Name of the transfers that hand on a share of the velocity gradient."""
    return {0.0: "PIC", 1.0: "APIC"}.get(affine, f"{affine:g} of the gradient")


ELASTIC = 1e10
"""Yield stress from which on a material is called elastic [Pa]."""


def _yielding(stress: float) -> str:
    if stress == 25e6:
        return ""
    return "elastic" if stress >= ELASTIC else rf"$\sigma_y$ = {stress * 1e-6:g} MPa"


SPECIAL = {
    **dict.fromkeys(("travel_ratio", "window_ratio", "error_target", "length_ratio"), lambda value: ""),
    "stress_yield": _yielding,
    "reach_ratio": lambda value: "" if value in (0.0, 8.0) else f"reach {value:g}",
    "points_per_cell": lambda value: "" if value == 2 else f"{value:g} x {value:g} points a cell",
    "grid_offset": lambda value: {0.0: "nodes on the cut", 0.25: ""}.get(value, f"nodes {value:g} cells above the cut"),
    "affine": lambda value: "" if value == 1.0 else transfers(value),
    "support": lambda value: {0.0: "no support", 0.05: ""}.get(value, f"support {value:g}"),
    "scheme": lambda value: "paper's loop" if value == "usavg" else "",
    "contact": lambda value: "0.8-cell contact" if value == "cells" else "",
    "failure_criterion": lambda value: "" if value == "area" else value,
    "law": str,
}
"""Words for fields whose symbol and value would say little; none for what is usual."""


def series_along(dataset: xr.Dataset, field: str, *needed: str, least: int = 2, beside: tuple[str, ...] = ()) -> Series:
    """Runs that agree in all but one field, in series along that field.

    Parameters
    ----------
    dataset : xarray.Dataset
        Collected runs.
    field : str
        Name of the field, as in the table of variables.
    needed : str
        Variables that a run must hold.
    least : int
        Smallest number of values of the field in a series; shorter ones are left out.
    beside : tuple of str
        Fields that may differ too, since they say how a run is made and not what it is.
    """
    groups: dict[tuple, list[tuple[float, xr.Dataset]]] = {}
    values: dict[tuple, dict[str, Any]] = {}
    for run in cases(dataset, *needed, kind="mpm_cutting"):
        fields = parameters(case_of(run))
        if field not in fields:
            continue
        rest = {name: value for name, value in fields.items() if name != field and name not in beside}
        key = tuple(sorted(rest.items()))
        values[key] = rest
        groups.setdefault(key, []).append((fields[field], run))
    chosen = {key: group for key, group in groups.items() if len({value for value, _ in group}) >= least}
    names = _names([values[key] for key in chosen])
    ordered = [[run for _, run in sorted(group, key=lambda pair: pair[0])] for group in chosen.values()]
    return sorted(zip(names, ordered, strict=True), key=lambda pair: pair[0])


def value_of(run: xr.Dataset, field: str) -> float:
    """Value of a field of a run, in the unit in which figures show it."""
    return parameters(case_of(run))[field] * VARIABLES[field].scale


def words(field: str, value: Any) -> str:
    """A field and its value, for a legend."""
    if field in SPECIAL:
        return SPECIAL[field](value)
    row = VARIABLES.get(field)
    if row is None or isinstance(value, str):
        return f"{field.replace('_', ' ')} {value}"
    name = f"${row.symbol}$" if row.symbol else row.long_name
    unit = "°" if row.display == "deg" else f" {row.display or row.unit}"
    return f"{name} = {float(value) * row.scale:.4g}" + (unit if unit != " 1" else "")


def _names(groups: list[dict[str, Any]]) -> list[str]:
    """What tells each group from the others."""
    varied = [name for name in (groups[0] if groups else {}) if len({group.get(name) for group in groups}) > 1]
    said = [[words(name, group[name]) for name in varied if name in group] for group in groups]
    return [", ".join(filter(None, texts)) or "runs" for texts in said]
