"""Cost of a step with bonded discs, on scenes of the size of Yang et al. (2018)."""

from __future__ import annotations

import math
import statistics
import time

from orthocut.cost import seconds_of
from orthocut.dem.packing import pack
from orthocut.dem.state import Scene
from orthocut.experiments import dem_cutting, dem_tension
from orthocut.experiments.dem_run import proceed
from orthocut.params.dem import DemCutting, DemTension, Packing

_DISC_AREA = 1 / 2084
"""Area of the paper's block over its number of discs [mm^2]."""


def bench_dem(discs: int = 2085, steps: int = 3000, repeats: int = 5) -> dict[str, float | int | str]:
    """Measure the whole step of a cut and of a quiescent tension test, one thread, compilation excluded [CPU ns].

    Parameters
    ----------
    discs : int
        Number of discs, about; the block is a square of discs as large as in the paper's block.
    steps : int
        Steps of a repeat.
    repeats : int
        The result is the median of so many repeats.

    Returns
    -------
    dict
        ``ns_per_bond_step``: the cut, tool in the block and joints broken, everything included: joints, contacts, tool,
        search for neighbours, integration. ``ns_per_bond_step_quiescent``: tension before the first break.
        ``over_cost_model``: the cut over what `orthocut.cost` says of it. And what was measured: scene, discs, bonds,
        cracks, steps, repeats, threads.
    """
    side = math.sqrt(discs * _DISC_AREA) * 1e-3
    packing = Packing.model_construct(**{**Packing().__dict__, "width": side, "height": side, "radius_min": 10e-6})
    packed = pack(packing)
    cut = DemCutting.model_construct(**{**DemCutting().__dict__, "packing": packing, "cut_depth": 0.1 * side})
    scene = dem_cutting.make_scene(cut, packed)
    proceed(scene, round(0.02 * side / cut.cut_speed / scene.time_step))
    pull = DemTension.model_construct(**{**DemTension().__dict__, "packing": packing})
    quiet = dem_tension.make_scene(pull, packed)
    proceed(quiet, 100)
    bonds = len(scene.joints.first)
    each = _median(scene, steps, repeats)
    return {
        "scene": f"cut of a block, speed {cut.cut_speed:g} m/s, after a travel of 2 % of its side",
        "ns_per_bond_step": each / bonds,
        "over_cost_model": 1e-9 * each / (seconds_of(cut, steps + 1) - seconds_of(cut, steps)),
        "ns_per_bond_step_quiescent": _median(quiet, steps, repeats) / bonds,
        "discs": len(packed.x),
        "bonds": bonds,
        "cracks": int(scene.cracks.count[0]),
        "elements": cut.joint.elements,
        "steps": steps,
        "repeats": repeats,
        "threads": 1,
    }


def _median(scene: Scene, steps: int, repeats: int) -> float:
    """Median CPU time of a step [ns]."""
    times = []
    for _ in range(repeats):
        start = time.thread_time()
        proceed(scene, steps)
        times.append((time.thread_time() - start) / steps)
    return 1e9 * statistics.median(times)
