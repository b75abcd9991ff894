"""The one table of figures and tables: name to the module that draws it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from types import ModuleType

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.holes import note, reasons
from orthocut.figures.tables import Table

FIGURES = {
    "nairn2015_fig02": "nairn2015_fig02",
    "nairn2015_fig03a": "nairn2015_fig03a",
    "nairn2015_fig03b": "nairn2015_fig03b",
    "nairn2015_fig04": "nairn2015_fig04",
    "nairn2015_fig05": "nairn2015_fig05",
    "nairn2015_fig07": "nairn2015_fig07",
    "nairn2015_fig08": "nairn2015_fig08",
    "nairn2015_fig09": "nairn2015_fig09",
    "nairn2015_fig10": "nairn2015_fig10",
    "nairn2015_fig11": "nairn2015_fig11",
    "nairn2015_fig12": "nairn2015_fig12",
    "nairn2015_fig13": "nairn2015_fig13",
    "nairn2015_fig14": "nairn2015_fig14",
    "nairn2015_fig15": "nairn2015_fig15",
    "nairn2015_fig16": "nairn2015_fig16",
    "nairn2015_fig17": "nairn2015_fig17",
    "nairn2015_regimes": "nairn2015_regimes",
    "nairn2015_transition": "nairn2015_transition",
    "nairn2015_convergence": "nairn2015_convergence",
    "nairn2015_precision": "nairn2015_precision",
    "nairn2015_accuracy": "nairn2015_accuracy",
    "nairn2015_touching": "nairn2015_touching",
    "nairn2015_robustness": "nairn2015_robustness",
    "nairn2015_claims": "nairn2015_claims",
    "nairn2015_animation": "cut_animation",
    "yang2018_animation": "cut_animation",
    "energy_balance": "energy_balance",
    "yang2018_fig05": "yang2018_fig05",
    "yang2018_fig06": "yang2018_fig06",
    "yang2018_fig07": "yang2018_fig07",
    "yang2018_fig08": "yang2018_fig08",
    "yang2018_fig09": "yang2018_fig09",
    "yang2018_fig10": "yang2018_fig10",
    "yang2018_fig11": "yang2018_cuts",
    "yang2018_fig12": "yang2018_cuts",
    "yang2018_fig13": "yang2018_cuts",
    "yang2018_fig14": "yang2018_cuts",
    "yang2018_fig17": "yang2018_comparison",
    "yang2018_fig18": "yang2018_comparison",
    "yang2018_table1": "yang2018_table1",
    "yang2018_table2": "yang2018_table2",
    "yang2018_toughness": "yang2018_toughness",
    "yang2018_table4": "yang2018_table4",
    "yang2018_table4_damped": "yang2018_table4",
    "yang2018_table4_damped_slow": "yang2018_table4",
    "yang2018_table6": "yang2018_table6",
    "yang2018_damage": "yang2018_damage",
    "yang2018_convergence": "yang2018_convergence",
    "yang2018_causes": "yang2018_causes",
    "yang2018_precision": "yang2018_precision",
    "yang2018_claims": "yang2018_claims",
    "show": "show",
}
"""Every module has ``draw(dataset) -> Figure`` and ``CAPTION``; with ``tabulate(dataset) -> Table`` also a table; with
``DIMS`` a dataset of these dimensions of the runs only; with ``condense(run)`` a dataset of what that leaves of each
run: it sees histories and, where other figures asked for them, snapshots."""

WITHOUT_RUNS = frozenset({"nairn2015_fig07"})
"""Figures of theory alone."""


def module(name: str) -> ModuleType:
    """Module of a figure.

    Raises
    ------
    KeyError
        With the known names, if there is no such figure.
    """
    if name not in FIGURES:
        raise KeyError(f"no figure is called {name!r} (known: {', '.join(FIGURES)})")
    return import_module(f"orthocut.figures.{FIGURES[name]}")


def dims(name: str) -> tuple[str, ...] | None:
    """Dimensions of runs that a figure draws, beside single numbers; None for all."""
    return getattr(module(name), "DIMS", None)


def condense(name: str) -> Callable[[xr.Dataset], xr.Dataset] | None:
    """What a figure does to each run before they are joined; None if nothing."""
    return getattr(module(name), "condense", None)


def draw(name: str, dataset: xr.Dataset | None = None) -> Figure:
    """Draw a figure from a collected dataset, or from a single run; failed cases are named below it."""
    figure = module(name).draw(dataset)
    note(figure, dataset)
    return figure


def caption(name: str) -> str:
    """Caption of a figure."""
    return module(name).CAPTION


def tabulate(name: str, dataset: xr.Dataset) -> Table | None:
    """Table that goes with a figure, None if it has none."""
    make = getattr(module(name), "tabulate", None)
    return replace(make(dataset), notes=reasons(dataset)) if make else None
