"""Yang et al. (2018), Table 1: parameters of the synthetic glass, as printed and as used here."""

from __future__ import annotations

import math
from typing import Any

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, cases, nothing, page, styled
from orthocut.figures.palette import BLACK, BLUE, ORANGE
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_paper import TABLE_1, Parameter
from orthocut.figures.yang2018_runs import as_printed
from orthocut.io.collect import case_of, parameters

CAPTION = (
    "Parameters of the synthetic glass over those printed in Yang et al. (2018), Table 1: runs with the printed joints "
    "and with calibrated ones. The specimen of 7406 discs cannot have the printed radii; as diameters they fit."
)
DIMS = ()
COLOURS = {"as printed": ORANGE, "calibrated": BLUE}


def materials(dataset: xr.Dataset) -> dict[str, dict[str, Any]]:
    """Parameters of the first specimen with the joints of Table 1 as printed and with others, by name."""
    found: dict[str, dict[str, Any]] = {}
    for run in [*cases(dataset, kind="dem_tension"), *cases(dataset, kind="dem_compression")]:
        case = case_of(run)
        name = "as printed" if as_printed(case.joint) else "calibrated"
        found.setdefault(name, parameters(case))
    return {name: found[name] for name in COLOURS if name in found}


def _value(row: Parameter, fields: dict[str, Any]) -> float:
    return float(fields[row.field]) * row.scale if row.field in fields else math.nan


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One row a parameter."""
    found = materials(dataset)
    figure = page(3.0, PAGE)
    ax = figure.subplots()
    if not found:
        nothing(ax)
        return figure
    shift = 0.12
    for (name, fields), place in zip(found.items(), (-shift, shift), strict=False):
        ratios = [_value(row, fields) / row.value for row in TABLE_1]
        ax.plot(ratios, [k + place for k in range(len(TABLE_1))], "o", color=COLOURS[name], label=name)
    ax.axvline(1.0, color=BLACK, lw=0.8)
    ax.set_yticks(range(len(TABLE_1)), [f"{row.words} ${row.symbol}$" for row in TABLE_1])
    ax.set_ylim(len(TABLE_1) - 0.5, -0.5)
    ax.set_xlim(left=0)
    ax.set_ylabel("parameter")
    ax.set_xlabel("value used here over value printed [-]")
    ax.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Printed value, values used, and what is odd about the printed one; then what the paper does not state."""
    found = materials(dataset)
    header = ["parameter", "unit", "paper", *found, "remark"]
    rows: list[list[Any]] = [
        [row.words, row.unit, row.value, *(_value(row, fields) for fields in found.values()), row.remark]
        for row in TABLE_1
    ]
    listed = {row.field for row in TABLE_1}
    for name in dict.fromkeys(name for fields in found.values() for name in fields):
        if name.startswith("joint_") and name not in listed:
            used = [fields.get(name, "") for fields in found.values()]
            rows.append([name.removeprefix("joint_").replace("_", " "), "-", "", *used, "not stated in the paper"])
    return Table("Parameters of the synthetic glass", header, rows)
