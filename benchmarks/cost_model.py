"""How well the cost model predicts run times: CPU seconds of short cases of all features over what it says of them.

Each case runs alone, compiled beforehand; it is compared at the steps that it took, and as predicted before it ran.
The first columns are for people who fit the constants of `orthocut.cost`: nanoseconds a particle and step.
"""

from __future__ import annotations

import argparse
import csv
import statistics
import time
from pathlib import Path

from rich.console import Console
from rich.progress import track
from rich.table import Table

from orthocut.cost import estimate_seconds, seconds_of
from orthocut.params.case import Case, load
from orthocut.params.size import moving
from orthocut.run import run_case

CUT = {"travel_ratio": 6, "window_ratio": 3, "length_ratio": 12, "modulus_tangent": "0 MPa"}
LONG = {**CUT, "travel_ratio": 18, "window_ratio": 9, "length_ratio": 24}
PAPER = {"scheme": "usavg", "grid_offset": 0, "affine": 0, "support": 0, "reach_ratio": 0}
BLOCK = {"packing.width": "0.5 mm", "packing.height": "0.5 mm", "travel": "0.2 mm", "cut_depth": "0.1 mm"}
TEST = {"packing.width": "0.5 mm", "packing.height": "1 mm", "grip_speed": "40 mm/s"}
CALIBRATED = {"modulus": "79.5 GPa", "stiffness_ratio": 3.215, "strength_tensile": "72.77 MPa", "cohesion": "174 MPa"}
CASES = {
    "ductile, 4 points": ("mpm", {**CUT, "points_per_depth": 4}),
    "ductile, 8 points": ("mpm", {**CUT, "points_per_depth": 8}),
    "ductile, 12 points": ("mpm", {**CUT, "points_per_depth": 12}),
    "ductile, friction": ("mpm", {**CUT, "points_per_depth": 8, "friction": 0.3}),
    "ductile, bending": ("mpm", {**CUT, "points_per_depth": 8, "modulus_tangent": "100 MPa", "cut_depth": "3 mm"}),
    "ductile, no rest": ("mpm", {**CUT, "points_per_depth": 8, "reach_ratio": 0}),
    "ductile, no support": ("mpm", {**CUT, "points_per_depth": 8, "support": 0}),
    "ductile, PIC": ("mpm", {**CUT, "points_per_depth": 8, "affine": 0}),
    "ductile, elastic": ("mpm", {**CUT, "points_per_depth": 8, "hardening": "none", "modulus_tangent": "100 MPa"}),
    "ductile, Voce": ("mpm", {**CUT, "points_per_depth": 8, "hardening": "voce", "modulus_tangent": "100 MPa"}),
    "ductile, Ludwik": ("mpm", {**CUT, "points_per_depth": 8, "hardening": "ludwik", "modulus_tangent": "100 MPa"}),
    "ductile, triangular": ("mpm", {**CUT, "points_per_depth": 8, "law": "triangular", "peak_ratio": 0.1}),
    "ductile, paper's loop": ("mpm", {**CUT, **PAPER, "points_per_depth": 6}),
    "ductile, paper's loop and contact": ("mpm", {**CUT, **PAPER, "points_per_depth": 6, "contact": "cells"}),
    "ductile, ends early": ("mpm", {**LONG, "points_per_depth": 6, "error_target": 0.01}),
    "ductile, ends early, bending": (
        "mpm",
        {**LONG, "points_per_depth": 6, "error_target": 0.02, "modulus_tangent": "100 MPa"},
    ),
    "glass, cut": ("dem", {**BLOCK}),
    "glass, cut at 0.5 m/s": ("dem", {**BLOCK, "cut_speed": "0.5 m/s"}),
    "glass, cut, calibrated": ("dem", {**BLOCK, "joint": CALIBRATED}),
    "glass, cut, fine discs": ("dem", {**BLOCK, "radius_min": "7.5 um"}),
    "glass, cut, less damping": ("dem", {**BLOCK, "damping": 0.3}),
    "glass, cut, a tenth slit": ("dem", {**BLOCK, "fraction_slit": 0.1}),
    "glass, cut, grooves": ("dem", {**BLOCK, "grooves": {"distance": "0.1 mm"}}),
    "glass, tension": ("dem_tension", {**TEST}),
    "glass, tension, calibrated": ("dem_tension", {**TEST, "joint": CALIBRATED}),
    "glass, tension, a tenth slit": ("dem_tension", {**TEST, "fraction_slit": 0.1}),
    "glass, compression": ("dem_compression", {**TEST}),
    "glass, compression, calibrated": ("dem_compression", {**TEST, "joint": CALIBRATED}),
    "glass, Brazilian test": ("dem_brazilian", {"packing.width": "0.5 mm", "packing.height": "0.5 mm"}),
}
HEADER = ["case", "particles", "steps", "CPU time [s]", "ns a moving particle and step"]
HEADER += ["predicted over measured, steps known [-]", "predicted over measured [-]"]


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", help="cases whose names contain this text")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/cost_model.csv"))
    options = parser.parse_args()
    chosen = {name: load(kind, values) for name, (kind, values) in CASES.items() if options.only in name}
    options.output.parent.mkdir(parents=True, exist_ok=True)
    table, rows = Table(*HEADER), []
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for name, case in track(chosen.items(), "measuring", console=Console(stderr=True)):
            rows.append(measure(name, case))
            cells = [f"{cell:.3g}" if isinstance(cell, float) else str(cell) for cell in rows[-1]]
            writer.writerow(cells)
            file.flush()
            table.add_row(*cells)
    Console().print(table)
    for solver in ("ductile", "glass"):
        own = [row for row in rows if row[0].startswith(solver)]
        for column in (-2, -1) if own else ():
            scale = statistics.median(row[column] for row in own)
            near = sum(abs(row[column] / scale - 1) < 0.25 for row in own)
            print(f"{solver}, {HEADER[column]}: median {scale:.2f}; {near} of {len(own)} within 25 % of it")


def measure(name: str, case: Case) -> list:
    """Row of a case: what it took, and what the model says of it."""
    run_case(shortest(case), snapshots=0)
    began = time.process_time()
    run = run_case(case, snapshots=0)
    spent = time.process_time() - began
    steps = run.attrs["steps"]
    share = steps / case.steps if case.kind == "mpm_cutting" else 1.0
    each = 1e9 * spent / moving(case, share) / steps
    return [
        name,
        run.attrs["particles"],
        steps,
        spent,
        each,
        seconds_of(case, steps) / spent,
        estimate_seconds(case) / spent,
    ]


def shortest(case: Case) -> Case:
    """Least of a case that compiles all that it needs."""
    if case.kind == "mpm_cutting":
        numerics = case.numerics.model_copy(update={"points_per_depth": 3})
        return case.model_copy(
            update={"travel_ratio": 2.5, "window_ratio": 0.5, "error_target": 0.0, "numerics": numerics}
        )
    if case.kind == "dem_cutting":
        return case.model_copy(update={"travel": 2e-6})
    return case.model_copy(update={"strain_max": 1e-5})


if __name__ == "__main__":
    main()
