"""What each feature of a ductile cut costs: nanoseconds a point and step with it, beside the default case.

Each round measures all variants one after the other, so that they share the machine's mood; the table holds medians of
the rounds and of the ratios to the default case of the same round.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from features import write_features
from rich.console import Console
from rich.progress import track

from orthocut.experiments.speed_mpm import bench_mpm

THEIRS = {"scheme": "usavg", "grid_offset": 0.0, "affine": 0.0, "support": 0.0, "reach_ratio": 0.0}
VARIANTS = {
    "default": {},
    "without rest far from the tool": {"reach_ratio": 0.0},
    "without support of loose nodes": {"support": 0.0},
    "without yielding": {"hardening": "none"},
    "with friction": {"tool.friction": 0.3},
    "Voce's hardening": {"hardening": "voce"},
    "Ludwik's hardening": {"hardening": "ludwik"},
    "triangular law": {"interface.law": "triangular"},
    "contact by cells": {"numerics.contact": "cells"},
    "loop of the paper's program": THEIRS,
    "paper mode": {**THEIRS, "numerics.contact": "cells"},
}
HEADER = ["variant", "cost of a point and step [ns]", "over the default [-]"]


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=15, help="points through the depth of cut")
    parser.add_argument("--rounds", type=int, default=5, help="rounds over all variants")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/mpm_features.csv"))
    options = parser.parse_args()

    costs: dict[str, list[float]] = {name: [] for name in VARIANTS}
    for _ in track(range(options.rounds), "measuring", console=Console(stderr=True)):
        for name, values in VARIANTS.items():
            costs[name].append(bench_mpm(options.points, 100, 3, values)["ns_per_point_step"])
    write_features(costs, HEADER, options.output)


if __name__ == "__main__":
    main()
