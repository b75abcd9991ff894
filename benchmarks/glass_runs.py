"""Runs of cuts of glass at several speeds of the tool, one row each; a second run goes on where the first one ended."""

from __future__ import annotations

import argparse
import csv
import os
import time
from multiprocessing import get_context
from pathlib import Path

from glass_cuts import GlassCut, wanted
from rich.console import Console
from rich.progress import track

from orthocut.io.files import replacing
from orthocut.params.block import CaseFailed
from orthocut.run import run_case

HEADER = [
    "cut",
    "tool [m/s]",
    "seed",
    "main force [N/mm]",
    "thrust force [N/mm]",
    "energy residual [%]",
    "CPU time [s]",
]
HEADER += ["failure"]


def main() -> None:
    """Run what is missing."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="processes")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/glass_runs.csv"))
    options = parser.parse_args()
    options.output.parent.mkdir(parents=True, exist_ok=True)
    rows = read_rows(options.output)
    waiting = [run for run in wanted() if run not in rows]
    with get_context("spawn").Pool(options.workers) as pool:
        done = pool.imap_unordered(cut, waiting)
        for run, row in track(done, "cutting", len(waiting), console=Console(stderr=True)):
            rows[run] = row
            write_rows(rows, options.output)


def cut(run: GlassCut) -> tuple[GlassCut, list[str]]:
    """Run, and its row."""
    start = time.process_time()
    try:
        result = run_case(run.case(), snapshots=0)
    except CaseFailed as why:
        return run, [*map(str, run), "", "", "", f"{time.process_time() - start:.1f}", str(why)]
    forces = [1e-3 * float(result[name]) for name in ("force_cutting_mean", "force_thrust_mean")]
    numbers = [f"{value:.6g}" for value in (*forces, 100 * float(result.energy_closure))]
    return run, [*map(str, run), *numbers, f"{time.process_time() - start:.1f}", ""]


def read_rows(file: Path) -> dict[GlassCut, list[str]]:
    """Rows of a table by run; none if there is no table."""
    if not file.exists():
        return {}
    with open(file, newline="", encoding="utf-8") as stream:
        return {GlassCut(row[0], float(row[1]), int(row[2])): row for row in list(csv.reader(stream))[1:]}


def write_rows(rows: dict[GlassCut, list[str]], file: Path) -> None:
    """Write the table under another name, then rename it."""
    with replacing(file) as part, open(part, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(HEADER)
        writer.writerows(rows[run] for run in sorted(rows))


if __name__ == "__main__":
    main()
