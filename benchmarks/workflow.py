"""What the workflow costs beside the simulations: overhead per case, planning, reruns that do nothing.

Each measurement runs the real workflow in a copy of the project. For the trivial simulation, the copy's tension test is
replaced by one that returns made-up histories at once: what is left is the cost of planning, scheduling, starting
workers, checking, writing and collecting.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from rich.console import Console
from tables import write_table

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from slurm.cluster import Cluster, reason_to_skip  # noqa: E402

TRIVIAL = '''

def simulate(case, progress, checkpoint=None, snapshots=0):
    """Make histories up."""
    rise = np.linspace(0.0, 1.0, 200) * case.packing.seed
    names = ("strain_axial", "strain_gauge", "strain_lateral", "stress_axial", "stress_grip", "work_tool")
    data = {name: (("sample",), rise) for name in names}
    data |= {name: ((), float(case.packing.seed)) for name in ("modulus_young", "strength_ultimate", "energy_closure")}
    return build_dataset(case, "made up", data, {"time": (("sample",), rise)})
'''
MODES = {
    "one process": ["--cores", "1", "--config", "batch_cores=1"],
    "dask workers": ["--cores", "all", "--config"],
    "a job a case": ["--cores", "all", "--config", "batch_minutes=0"],
    "slurm": ["--profile", "workflow/profiles/slurm", "--jobs", "2", "--slurm-status-command", "squeue", "--config"],
}
HEADER = [
    "execution",
    "simulation",
    "cases",
    "dry run [s]",
    "run [s]",
    "simulations [core s]",
    "overhead per case [core s]",
    "overhead [%]",
    "rerun without work [s]",
]


@contextmanager
def project(cases: int, trivial: bool) -> Iterator[Path]:
    """Copy of the project with a study of so many tension tests."""
    with tempfile.TemporaryDirectory(prefix="orthocut-benchmark-") as name:
        root = Path(name)
        for folder in ("src", "workflow", "profiles"):
            shutil.copytree(ROOT / folder, root / folder, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
        shutil.copy(ROOT / "Snakefile", root)
        seeds = ", ".join(str(seed) for seed in range(1, cases + 1))
        size = "{width: 0.15 mm, height: 0.3 mm}" if trivial else "{width: 0.5 mm, height: 1 mm}"
        study = f"title: benchmark\nsweeps:\n  pull:\n    base: {{kind: dem_tension, packing: {size}}}\n"
        study += f"    axes: {{product: {{seed: [{seeds}]}}}}\nfigures: {{}}\n"
        (root / "workflow/config/benchmark.yaml").write_text(study, encoding="utf-8")
        if trivial:
            path = root / "src/orthocut/experiments/dem_tension.py"
            text = path.read_text(encoding="utf-8")
            imports = "import numpy as np\n\nfrom orthocut.io.datasets import build as build_dataset\n"
            path.write_text(text + "\n" + imports + TRIVIAL, encoding="utf-8")
        yield root


def snakemake(root: Path, options: Sequence[str]) -> float:
    """Run the workflow in a copy; return the seconds it took."""
    command = [sys.executable, "-m", "snakemake", *options, "study=benchmark"]
    environment = {**os.environ, "PYTHONPATH": str(root / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
    began = time.perf_counter()
    done = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return time.perf_counter() - began


def seconds_simulated(root: Path) -> float:
    """Run time of all simulations in the copy's store, as their seals tell [s]."""
    code = (
        "from orthocut.io.store import Store; s = Store('results/store'); "
        "print(sum(s.entry(key).seconds for key in s.names()))"
    )
    environment = {**os.environ, "PYTHONPATH": str(root / "src")}
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=root, env=environment, capture_output=True, text=True, check=True
    )
    return float(done.stdout)


def measure(mode: str, cases: int, trivial: bool) -> list[object]:
    """One row of the table."""
    options = MODES[mode]
    cores = 1 if mode == "one process" else os.cpu_count() or 1
    with project(cases, trivial) as root:
        dry = snakemake(root, ["--dry-run", "--quiet", "all", *options[options.index("--config") :]])
        snakemake(root, ["results/kernels/dem.compiled", *options])
        run = snakemake(root, ["runs", *options])
        simulated = seconds_simulated(root)
        idle = snakemake(root, ["runs", *options])
    overhead = run * cores - simulated
    kind = "trivial" if trivial else "tension test"
    share = 100 * overhead / simulated if not trivial else float("nan")
    return [mode, kind, cases, dry, run, simulated, overhead / cases, share, idle]


def measured(mode: str, cases: int, trivial: bool) -> list[object]:
    """One row of the table, with a Slurm of one node where it is needed."""
    if mode != "slurm":
        return measure(mode, cases, trivial)
    with tempfile.TemporaryDirectory(prefix="orthocut-slurm-") as folder:
        cluster = Cluster(Path(folder))
        try:
            cluster.start()
            return measure(mode, cases, trivial)
        finally:
            cluster.stop()


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=int, nargs="+", default=[100, 1000, 5000], help="numbers of trivial cases")
    parser.add_argument("--real", type=int, default=100, help="number of real cases, 0 for none")
    parser.add_argument("--modes", nargs="+", choices=MODES, default=list(MODES))
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/workflow.csv"))
    options = parser.parse_args()

    console = Console()
    rows = []
    for mode in options.modes:
        if mode == "slurm" and (reason := reason_to_skip()):
            console.print(f"slurm left out: {reason}")
            continue
        for cases in options.cases if mode != "a job a case" else options.cases[:1]:
            rows.append(measured(mode, cases, trivial=True))
            console.print(rows[-1])
        if options.real and mode != "a job a case":
            rows.append(measured(mode, options.real, trivial=False))
            console.print(rows[-1])
    write_table(HEADER, rows, options.output)


if __name__ == "__main__":
    main()
