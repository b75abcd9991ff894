"""Work of a ductile cut that is skipped: pairs of runs that differ in the skip alone.

The answer is the steady cutting force. Its own standard error is some 1 %, so that a change by less says that there is
none to be seen.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from typing import Any

import xarray as xr
from skip import Skip

from orthocut.params.case import load
from orthocut.run import run_case

CASE = {"cut_depth": "0.9 mm", "rake_angle": "30 deg", "modulus_tangent": "100 MPa", "points_per_depth": 5}


class Run:
    """A run of a case, made anew each time that its cost is asked for."""

    def __init__(self, values: Mapping[str, Any], snapshots: int = 0) -> None:
        self.case = load("mpm", {**CASE, **values})
        self.snapshots = snapshots
        self.result: xr.Dataset | None = None

    def cost(self) -> float:
        """CPU time of the run [s]."""
        start = time.thread_time()
        self.result = run_case(self.case, snapshots=self.snapshots)
        return time.thread_time() - start

    @property
    def force(self) -> float:
        """Steady cutting force [N/m]."""
        if self.result is None:
            self.cost()
        return float(self.result["force_cutting_mean"])


def skips() -> Iterator[Skip]:
    """All pairs, each ready to be measured."""
    usual = Run({})
    yield _pair("material far from the tool", Run({"reach_ratio": 0.0}), usual)
    yield _pair("travel once the force is known to 2 %", usual, Run({"error_target": 0.02}))
    yield _pair("six snapshots", Run({}, snapshots=6), usual)
    yield _pair("friction at the tool", Run({"tool.friction": 1e-9}), usual)


def _pair(what: str, without: Run, skipping: Run) -> Skip:
    return Skip("ductile", what, without.cost, skipping.cost, lambda: abs(skipping.force / without.force - 1))
