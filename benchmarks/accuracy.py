"""Whether presets and tolerances keep what they promise: errors and run times of ductile cuts that no study holds.

Cuts are drawn from the box that the promises are made for (Sobol, depth and cohesive stress on logarithmic scales).
Reference: force at zero particle size by a weighted straight fit through three sizes with the tool at 5 m/s.
"""

from __future__ import annotations

import argparse
import csv
import math
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import xarray as xr
from rich.console import Console
from rich.progress import track
from scipy.stats import qmc

from orthocut.cost import estimate_seconds
from orthocut.figures.extrapolation import extrapolate
from orthocut.params.accuracy_ductile import Choice, depth_over_zone, promise
from orthocut.params.block import CaseFailed
from orthocut.params.case import load
from orthocut.run import run_case

SIZES = (8, 12, 16)
"""Points through the chip of the runs that the reference is from."""
FINE = {"courant": 0.5, "travel_ratio": 18, "window_ratio": 9, "length_ratio": 24, "error_target": 0.01}
WISHES = ({"preset": "quick"}, {"preset": "standard"}, {"tolerance": "20 %"})
LOW, HIGH = (math.log(0.3), 12.0, 0.0, 0.0, math.log(15.0)), (math.log(3.0), 48.0, 0.5, 100.0, math.log(70.0))
"""Logarithm of the depth of cut [mm], rake angle [degree], friction, tangent modulus [MPa], logarithm of the cohesive
stress [MPa]."""
DEEPEST = 3.0
"""Largest depth of cut over the length of the cohesive zone."""
HEADER = [
    "cut",
    "depth over cohesive zone [-]",
    "setting",
    "points",
    "tool [m/s]",
    "regime",
    "force over toughness [-]",
]
HEADER += ["reference [-]", "its standard error [-]", "regime at 8, 12, 16 points", "promised of 9 of 10 [%]"]
HEADER += ["of every other one [%]", "error [%]", "standard error [%]", "kept"]
HEADER += ["predicted run time [s]", "CPU time [s]"]


def main() -> None:
    """Run and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cuts", type=int, default=8, help="number of cuts")
    parser.add_argument("--seed", type=int, default=2015, help="seed of the sequence")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/accuracy.csv"))
    options = parser.parse_args()
    options.output.parent.mkdir(parents=True, exist_ok=True)
    cuts = drawn(options.cuts, options.seed)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for cut in track(list(cuts), "cutting", console=Console(stderr=True)):
            for row in tried(cut):
                writer.writerow([f"{cell:.4g}" if isinstance(cell, float) else cell for cell in row])
                file.flush()
    print(options.output.read_text(encoding="utf-8"))


def drawn(count: int, seed: int) -> Iterator[dict[str, Any]]:
    """Raw fields of some cuts of the box."""
    found = 0
    for point in qmc.scale(qmc.Sobol(len(LOW), rng=seed).random(4 * 2 ** math.ceil(math.log2(count))), LOW, HIGH):
        fields = {
            "cut_depth": f"{math.exp(point[0]):.3g} mm",
            "rake_angle": f"{point[1]:.3g} deg",
            "friction": round(float(point[2]), 2),
            "modulus_tangent": f"{point[3]:.3g} MPa",
            "strength": f"{math.exp(point[4]):.3g} MPa",
        }
        if found < count and depth_over_zone(load("mpm", fields)) <= DEEPEST:
            found += 1
            yield fields


def tried(cut: dict[str, Any]) -> Iterator[list]:
    """Rows of a cut, one a wish."""
    words = ", ".join(f"{name} {value}" for name, value in cut.items())
    runs = {n: simulated({**cut, **FINE, "points_per_depth": n}) for n in SIZES}
    failures = [f"{n} points: {run}" for n, run in runs.items() if isinstance(run, str)]
    if failures:
        yield [words, depth_over_zone(load("mpm", cut)), "reference failed", *failures]
        return
    forces = {n: over_toughness(run, cut) for n, run in runs.items()}
    fit = extrapolate([1 / n for n in SIZES], *zip(*(forces[n] for n in SIZES), strict=True))
    regimes = " ".join(regime(run) for run in runs.values())
    for wish in WISHES:
        case, start = load("mpm", {**cut, **wish}), time.process_time()
        run = simulated({**cut, **wish})
        spent = time.process_time() - start
        points, speed = case.numerics.points_per_depth, f"{case.cut_speed:g} m/s"
        said = promise(case, Choice(points, speed, case.error_target))
        first = [words, depth_over_zone(case), " ".join(map(str, next(iter(wish.items())))), points, case.cut_speed]
        if isinstance(run, str):
            yield [*first, f"failed: {run}"]
            continue
        force, own = over_toughness(run, cut)
        error, noise = abs(force / fit.limit - 1), math.hypot(own, fit.error) / fit.limit
        numbers = [100 * said.bound, 100 * said.typical, 100 * error, 100 * noise]
        kept = "yes" if error <= said.bound else "no"
        cost = estimate_seconds(case), spent
        yield [*first, regime(run), force, fit.limit, fit.error, regimes, *numbers, kept, *cost]


def simulated(fields: dict[str, Any]) -> xr.Dataset | str:
    """Run of a cut, or why it failed."""
    try:
        return run_case(load("mpm", fields), snapshots=0)
    except CaseFailed as why:
        return str(why)


def over_toughness(run: xr.Dataset, cut: dict[str, Any]) -> tuple[float, float]:
    """Force of a run and its standard error over toughness [-]."""
    toughness = load("mpm", cut).interface.toughness
    return float(run.force_cutting_mean) / toughness, float(run.force_cutting_error) / toughness


def regime(run: xr.Dataset) -> str:
    """Whether the tool touches the crack tip."""
    return "touching" if float(run.touching) >= 0.5 else "bending"


if __name__ == "__main__":
    main()
