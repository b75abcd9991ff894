"""Cuts with extreme parameters: which finish, what transfers lose, and how well the energy balance closes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.holes import GREY
from orthocut.figures.palette import BLUE
from orthocut.figures.sweep import over_toughness, touches
from orthocut.figures.tables import Table
from orthocut.figures.varied import words
from orthocut.io.collect import case_of, parameters
from orthocut.variables import VARIABLES

__all__ = ["CAPTION", "DIMS", "condense", "draw", "tabulate"]

CAPTION = (
    "Ductile cuts with extreme parameters, one row a cut, named by all parameters that vary. Left: share of the tool's "
    "work that contact and the transfers between points and grid have lost at the end; below zero, they made energy. "
    "Right: share of that work that the energy balance does not account for. Vertical lines: the shares at which a run "
    "stops. Open symbols: the tool touches the crack tip; filled: the chip bends. Crosses: failed runs, whose "
    "reasons are in the table, which also holds the forces."
)
DIMS = ()
STOPS = 5.0
"""Share of the tool's work, made or not accounted for, at which a run stops [%]; see `experiments.mpm_cutting`."""
ROW = 0.16  # inches
LOSS = "share_lost"
PANELS = (("work lost in transfers and contact [%]", LOSS), ("work not accounted for [%]", "energy_closure"))


def condense(run: xr.Dataset) -> xr.Dataset:
    """Run with the share of the tool's work that transfers and contact have lost at the end, from its histories."""
    if not {"energy_numerical", "energy_contact", "work_tool"} <= set(run.variables):
        return run
    attributes = {"units": "1", "long_name": "energy lost in transfers and contact over the work of the tool"}
    lost = run["energy_numerical"][-1] + run["energy_contact"][-1]
    return run.assign({LOSS: ((), float(lost / run["work_tool"][-1]), attributes)})


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One row a case."""
    runs = _cuts(dataset)
    figure = page(ROW * len(runs) + 1.0 if runs else 2.0, PAGE)
    panels = figure.subplots(1, 2, sharey=True)
    if not runs:
        for ax in panels:
            nothing(ax)
            ax.set_axis_off()
        return figure

    for ax, (text, name) in zip(panels, PANELS, strict=True):
        ax.set_xlabel(text.removeprefix("work "))
        ax.axvline(0, color="0.4", lw=0.6, zorder=1)
        for row, run in enumerate(runs):
            share = 100.0 * float(run[name]) if name in run else math.nan
            if _failed(run):
                ax.plot(0.0, row, "x", color=GREY, ms=5, mew=1.2, transform=ax.get_yaxis_transform(), clip_on=False)
            elif math.isfinite(share):
                ax.plot(share, row, "o", color=BLUE, mfc="white" if touches(run) else BLUE)
    for ax, stop in ((panels[0], -STOPS), (panels[1], -STOPS), (panels[1], STOPS)):
        ax.axvline(stop, color="0.7", lw=0.8, zorder=1)
    panels[0].set_ylabel("cut")
    panels[0].set_yticks(range(len(runs)), names(runs))
    panels[0].set_ylim(len(runs) - 0.5, -0.5)
    figure.legend(handles=_handles(), loc="outside upper center", ncols=3)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Varied parameters of each case, how it ended, its force, and its energies."""
    runs = _cuts(dataset)
    varied = _varied(runs)
    header = [_column(name) for name in varied] + ["outcome", "regime"]
    header += ["force over toughness [-]", "standard error [-]", *(text for text, _ in PANELS)]
    rows = []
    for run in runs:
        fields = parameters(case_of(run))
        cells = [_cell(name, fields[name]) for name in varied]
        failed = _failed(run)
        outcome = f"failed: {run['failure'].item()}" if failed else "done"
        regime = "" if failed else "touching" if touches(run) else "bending"
        forces = [over_toughness(run), over_toughness(run, "force_cutting_error")]
        shares = [100.0 * float(run[name]) if name in run else math.nan for _, name in PANELS]
        rows.append([*cells, outcome, regime, *forces, *shares])
    return Table("Ductile cuts with extreme parameters", header, rows)


def names(runs: list[xr.Dataset]) -> list[str]:
    """Values of all parameters that vary."""
    varied = _varied(runs)
    fields = [parameters(case_of(run)) for run in runs]
    return [", ".join(filter(None, (words(name, one[name]) for name in varied))) for one in fields]


def _cuts(dataset: xr.Dataset) -> list[xr.Dataset]:
    """Ductile cuts, failed ones too, in the order of their parameters."""
    if "case" not in dataset.dims:
        return [dataset] if dataset.attrs.get("kind") == "mpm_cutting" else []
    runs = [dataset.isel(case=index) for index in range(dataset.sizes["case"])]
    runs = [run for run in runs if run["kind"].item() == "mpm_cutting"]
    fields = [parameters(case_of(run)) for run in runs]
    order = [[one[name] for name in _varied(runs)] for one in fields]
    return [run for _, run in sorted(zip(order, runs, strict=True), key=lambda pair: pair[0])]


def _varied(runs: list[xr.Dataset]) -> list[str]:
    """Parameters that are not the same in all runs."""
    fields = [parameters(case_of(run)) for run in runs]
    return [name for name in (fields[0] if fields else {}) if len({one[name] for one in fields}) > 1]


def _failed(run: xr.Dataset) -> bool:
    return bool("failure" in run and run["failure"].item())


def _column(name: str) -> str:
    """Name of a column with its unit."""
    row = VARIABLES[name]
    unit = row.display or row.unit
    return f"{row.long_name} [{'-' if unit == '1' else unit}]"


def _cell(name: str, value: Any) -> Any:
    """Value in the unit of its column, rounded to what a study says."""
    if isinstance(value, str):
        return value
    return float(np.round(value * VARIABLES[name].scale, 9))


def _handles() -> list[Line2D]:
    style = {"ls": "", "marker": "o", "color": BLUE}
    return [
        Line2D([], [], mfc="white", label="touching", **style),
        Line2D([], [], label="bending", **style),
        Line2D([], [], ls="", marker="x", color=GREY, ms=5, mew=1.2, label="failed"),
    ]
