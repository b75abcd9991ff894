"""Where the work of the tool goes: all energies of a cut over the travel, stacked, against the work."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import cases, name_axes, nothing, page, styled, values
from orthocut.figures.palette import QUANTITY

CAPTION = (
    "Energies of a cut over the travel of the tool, stacked, against the work of the tool. What is missing to the line "
    "is not accounted for; its share at the end is the closure error. Energies below 0.2 % of the work are left out."
)
DIMS = ("sample",)
VISIBLE = 0.002
"""Energies that stay below this fraction of the work are not drawn."""
ENERGIES = tuple(name for name in QUANTITY if name.startswith("energy_") and name != "energy_residual")


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One panel a run, at most four."""
    runs = cases(dataset, "work_tool", "tool_travel")[:4]
    figure = page(2.6 * max(len(runs), 1) + 0.5)
    panels = figure.subplots(max(len(runs), 1), squeeze=False)[:, 0]
    handles: dict = {}
    for ax, run in zip(panels, runs, strict=False):
        handles |= draw_energies(ax, run)
    if runs:
        figure.legend(handles.values(), handles.keys(), loc="outside upper center", ncols=3, columnspacing=1.0)
    else:
        nothing(panels[0])
    return figure


def draw_energies(ax, run: xr.Dataset, along: str = "tool_travel") -> dict:
    """Stack the energies of one run over a history; return its legend entries by name."""
    travel = values(run, along)
    order = np.flatnonzero(np.isfinite(travel))
    work = values(run, "work_tool")[order]
    energies = {name: np.nan_to_num(values(run, name)[order]) for name in ENERGIES if values(run, name).ndim}
    seen = VISIBLE * np.max(np.abs(work), initial=0.0)
    handles = {}
    top = np.zeros(order.size)
    for name, energy in energies.items():
        if not np.max(np.abs(energy), initial=0.0) > seen:
            continue
        raised = top + energy
        handles[name.removeprefix("energy_")] = ax.fill_between(
            travel[order], top, raised, color=QUANTITY[name], lw=0, alpha=0.85
        )
        top = raised
    handles["work of the tool"] = ax.plot(travel[order], work, color=QUANTITY["work_tool"], lw=1.3)[0]
    name_axes(ax, along, "energy [J/m]")
    ax.margins(x=0)
    if along == "tool_travel":
        ax.set_xlim(left=0)
    closure = float(values(run, "energy_closure")) if "energy_closure" in run else np.nan
    if not np.isfinite(closure) and order.size and work[-1] != 0:
        closure = 100 * (1 - sum(energy[-1] for energy in energies.values()) / work[-1])
    ax.set_title(f"not accounted for: {closure:+.2f} % of the work", loc="left")
    return handles
