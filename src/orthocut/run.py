"""The one door to a simulation: a case in, a dataset out."""

from __future__ import annotations

import importlib
import time
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING

from orthocut.params.block import CaseFailed
from orthocut.params.case import Case, load

if TYPE_CHECKING:
    import xarray

    from orthocut.io.checkpoint import Checkpoint

Progress = Callable[[float], None]

SMALLEST = {
    "mpm_cutting": {
        "points_per_depth": 4,
        "length_ratio": 6.0,
        "base_ratio": 0.5,
        "travel_ratio": 1.0,
        "window_ratio": 0.5,
        "notch_ratio": 0.5,
    },
    "dem_cutting": {"packing.width": "0.25 mm", "packing.height": "0.25 mm", "travel": "2 um", "cut_depth": "0.05 mm"},
    "dem_tension": {"packing.width": "0.15 mm", "packing.height": "0.3 mm", "strain_max": 1e-5},
    "dem_compression": {"packing.width": "0.15 mm", "packing.height": "0.3 mm", "strain_max": 1e-5},
    "dem_brazilian": {"packing.width": "0.2 mm", "packing.height": "0.2 mm", "strain_max": 1e-5},
    "dem_toughness": {"packing.width": "0.15 mm", "packing.height": "0.3 mm", "crack_ratio": 0.6, "strain_max": 1e-5},
}
"""What to set to make a case of each kind take a moment and still pass through the whole solver."""


def run_case(
    case: Case, progress: Progress | None = None, checkpoint: Checkpoint | None = None, snapshots: int = 6
) -> xarray.Dataset:
    """Simulate a case.

    Parameters
    ----------
    case : Case
        As `orthocut.params.case.load` or `validate` return it.
    progress : callable, optional
        Called now and then with the fraction that is done, 0 to 1.
    checkpoint : Checkpoint, optional
        File that the run goes on from if it holds a state, and leaves its state in now and then. The result has the
        same bits with and without.
    snapshots : int
        Number of snapshots of a cut; tests of specimens have two, unless 0 are wanted. No other number depends on it.

    Returns
    -------
    xarray.Dataset
        Histories, results and snapshots with units, names and symbols; attributes hold the whole case, its provenance
        and the run time ``wall_time_s``.

    Raises
    ------
    CaseFailed
        If the simulation diverges or a packing cannot be made; the message says when, where and what to change.
    """
    experiment = importlib.import_module(f"orthocut.experiments.{case.kind}")
    guard = importlib.import_module("orthocut.measure.guard")
    start = time.perf_counter()
    dataset = experiment.simulate(case, progress or _ignore, checkpoint, snapshots)
    guard.check_finite(dataset)
    dataset.attrs["wall_time_s"] = checkpoint.seconds if checkpoint else time.perf_counter() - start
    return dataset


def _ignore(fraction: float) -> None:
    """Do nothing."""


def warm(method: str) -> float:
    """Compile the kernels of a method by running the smallest case of each of its kinds; return the seconds it took."""
    start = time.perf_counter()
    for kind, values in SMALLEST.items():
        if kind.startswith(f"{method}_"):
            with suppress(CaseFailed):
                run_case(load(kind, values))
    return time.perf_counter() - start
