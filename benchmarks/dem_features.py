"""What each feature of bonded discs costs: nanoseconds a joint and step with it, beside the default case.

The scene is the paper's block, its ends pulled apart before the first break, or cut, where the variant says so.
Each round measures all variants one after the other, so that they share the machine's mood; the table holds medians of
the rounds and of the ratios to the default case of the same round.
"""

from __future__ import annotations

import argparse
import math
import time
from pathlib import Path

from features import write_features
from rich.console import Console
from rich.progress import track

from orthocut.dem.packing import PackedDiscs, pack
from orthocut.dem.state import Scene
from orthocut.experiments import dem_cutting, dem_tension
from orthocut.experiments.dem_run import proceed
from orthocut.params.dem import DemCutting, DemTension, FlatJoint

CUT = "a cut, after a travel of 2 %"
VARIANTS = {
    "default": {},
    "1 element": {"elements": 1},
    "3 elements": {"elements": 3},
    "4 elements": {"elements": 4},
    "a tenth of the joints slit": {"fraction_slit": 0.1},
    "all joints slit": {"fraction_slit": 1.0},
    CUT: {},
}
HEADER = ["variant", "cost of a joint and step [ns]", "over the default [-]"]


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--discs", type=int, default=2085, help="number of discs, about")
    parser.add_argument("--rounds", type=int, default=5, help="rounds over all variants")
    parser.add_argument("--steps", type=int, default=1000, help="steps of one measurement")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/dem_features.csv"))
    options = parser.parse_args()

    side = math.sqrt(options.discs / 2084) * 1e-3
    packing = DemCutting().packing.model_copy(update={"width": side, "height": side})
    packed = pack(packing)
    scenes = {name: make_scene(name, values, packed, packing) for name, values in VARIANTS.items()}
    costs: dict[str, list[float]] = {name: [] for name in VARIANTS}
    for _ in track(range(options.rounds), "measuring", console=Console(stderr=True)):
        for name, scene in scenes.items():
            began = time.thread_time()
            proceed(scene, options.steps)
            spent = time.thread_time() - began
            costs[name].append(1e9 * spent / options.steps / len(scene.joints.first))

    write_features(costs, HEADER, options.output)


def make_scene(name: str, values: dict[str, float], packed: PackedDiscs, packing) -> Scene:
    """Scene of a variant, its kernels compiled and its lists made."""
    joint = FlatJoint().model_copy(update=values)
    if name == CUT:
        case = DemCutting().model_copy(update={"packing": packing, "joint": joint, "cut_depth": 0.1 * packing.height})
        scene = dem_cutting.make_scene(case, packed)
        proceed(scene, round(0.02 * packing.width / case.cut_speed / scene.time_step))
        return scene
    case = DemTension().model_copy(update={"packing": packing, "joint": joint})
    scene = dem_tension.make_scene(case, packed)
    proceed(scene, 100)
    return scene


if __name__ == "__main__":
    main()
