"""Failed cases in figures and tables: holes that everyone sees, with their reasons."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

MOST = 3
"""Failed cases that a figure names; the others are counted."""
GREY = "0.45"


def failed(dataset: xr.Dataset | None, kind: str = "") -> list[xr.Dataset]:
    """Failed runs of a collected dataset, each with its ``failure``, of one kind or of all."""
    if dataset is None or "case" not in dataset.dims or "failure" not in dataset:
        return []
    runs = [dataset.isel(case=index) for index in range(dataset.sizes["case"])]
    return [run for run in runs if run["failure"].item() and kind in ("", run["kind"].item())]


def reasons(dataset: xr.Dataset | None) -> list[str]:
    """One line a failed case: name and reason."""
    return [f"failed: {run['case_id'].item()}: {run['failure'].item()}" for run in failed(dataset)]


def mark(ax: Axes, places: Iterable[float]) -> None:
    """Grey crosses on the lower axis where failed cases would stand."""
    for place in places:
        ax.plot(place, 0.0, "x", color=GREY, ms=6, mew=1.5, transform=ax.get_xaxis_transform(), clip_on=False, zorder=4)


def note(figure: Figure, dataset: xr.Dataset | None) -> None:
    """Name the failed cases and their reasons below a figure; nothing if there are none."""
    lines = reasons(dataset)
    if not lines:
        return
    if len(lines) > MOST:
        lines = [*lines[:MOST], f"and {len(lines) - MOST} more failed cases"]
    width, height = figure.get_size_inches()
    wrapped = [part for text in lines for part in textwrap.wrap(text, int(17 * width))]
    room = 0.12 * len(wrapped) + 0.08
    figure.set_size_inches(width, height + room)
    share = room / (height + room)
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    figure.text(0.01, 0.3 * share / len(wrapped), "\n".join(wrapped), color=GREY, fontsize=6, va="bottom")
