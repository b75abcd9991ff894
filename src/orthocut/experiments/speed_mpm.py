"""Cost of a step with material points, on the scene of Nairn (2015)."""

from __future__ import annotations

import statistics
import time
from collections.abc import Mapping
from typing import Any

from orthocut.cost import seconds_of
from orthocut.mpm import setup
from orthocut.mpm.solver import Solver
from orthocut.params.case import load

_LEAD = 10
"""Steps before the measurement, over those of a repeat."""
_PAPER = {"points_per_depth": 15, "length_ratio": 30.0, "travel_ratio": 15.0, "ramp_fraction": 0.01}
"""The paper's 15 points through the chip and length of 30 depths of cut; the tool at full speed at once."""


def bench_mpm(
    points_per_depth: int = 15, steps: int = 200, repeats: int = 7, values: Mapping[str, Any] | None = None
) -> dict[str, float | int | str]:
    """Measure the whole step of a cut, one thread, compilation excluded [CPU ns].

    Parameters
    ----------
    points_per_depth : int
        Material points through the depth of cut.
    steps : int
        Steps of a repeat.
    repeats : int
        The result is the median of so many repeats.
    values : mapping, optional
        Further fields of the case.

    Returns
    -------
    dict
        ``ns_per_point_step``: transfers, material, interface, contact, grid, energy book-keeping.
        ``over_cost_model``: the same over what `orthocut.cost` says of it. And what was measured: scene, points, pairs
        of the interface, nodes of the grid, steps, repeats, threads.
    """
    case = load("mpm", {**_PAPER, "points_per_depth": points_per_depth, **(values or {})})
    state = setup.build(case)
    solver = Solver(state)
    solver.advance(_LEAD * steps)
    times = []
    for _ in range(repeats):
        start = time.thread_time()
        solver.advance(steps)
        times.append((time.thread_time() - start) / steps)
    begun, ended = (seconds_of(case, count * steps) for count in (_LEAD, _LEAD + repeats))
    predicted = (ended - begun) / (repeats * steps)
    return {
        "scene": f"cut of a strip, speed {case.cut_speed:g} m/s, tool in contact after {_LEAD * steps} steps",
        "ns_per_point_step": 1e9 * statistics.median(times) / state.point_count,
        "over_cost_model": statistics.median(times) / predicted,
        "points": state.point_count,
        "pairs": state.interface.shape[1],
        "nodes": state.frame.count_x * state.frame.count_y,
        "steps": steps,
        "repeats": repeats,
        "threads": 1,
    }
