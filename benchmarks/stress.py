"""Random scenes over the whole range of every field and beyond: each is done, refused or failed, with a reason.

Scenes come from a Sobol sequence, are cut down to a second or so and run in a process of their own. Whoever finishes
is checked by other means than the solver's own; what those find is a quiet lie. One row a scene goes into a CSV; a
second run goes on where the first one ended.
"""

from __future__ import annotations

import argparse
import csv
import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from stress_scenes import RANGES, SEED, Scene, draw
from stress_summary import write_summary
from stress_worker import CRASHED, LATE, LIE, OUTCOMES, Outcome, Worker

COLUMNS = ("solver", "scene", "outcome", "why", "time_s")


def main() -> None:
    """Run what is missing, write tables and a picture."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=int, default=1024, help="scenes of each solver")
    parser.add_argument("--solvers", nargs="+", choices=sorted(RANGES), default=sorted(RANGES), help="which solvers")
    parser.add_argument("--seed", type=int, default=SEED, help="seed of the Sobol sequences")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="processes")
    parser.add_argument("--limit", type=float, default=60.0, help="CPU time that a scene may take [s]")
    parser.add_argument("--again", nargs="*", choices=OUTCOMES, default=[], help="outcomes whose scenes are run again")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks"), help="folder for tables and picture")
    options = parser.parse_args()

    scenes = [scene for solver in options.solvers for scene in draw(solver, options.scenes, options.seed)]
    files = {solver: options.output / f"stress_{solver}.csv" for solver in options.solvers}
    rows = {solver: read_rows(file) for solver, file in files.items()}
    for of_solver in rows.values():
        for number in [number for number, row in of_solver.items() if row["outcome"] in options.again]:
            del of_solver[number]
    waiting = [scene for scene in scenes if scene.number not in rows[scene.solver]]
    try:
        run_scenes(waiting, rows, files, options.workers, options.limit)
    finally:
        everything = {solver: read_rows(options.output / f"stress_{solver}.csv") for solver in RANGES} | rows
        write_summary({solver: list(found.values()) for solver, found in everything.items()}, options.output)
    bad = [row for of_solver in rows.values() for row in of_solver.values() if row["outcome"] in (LIE, CRASHED, LATE)]
    raise SystemExit(bool(bad))


def run_scenes(
    waiting: list[Scene], rows: dict[str, dict[int, dict[str, str]]], files: dict[str, Path], workers: int, limit: float
) -> None:
    """Run scenes side by side; the tables are written anew, whole, every few scenes."""
    bar = Progress(
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(),
        console=Console(stderr=True),
    )  # fmt: skip
    count = min(workers, max(len(waiting), 1))
    crew = [Worker(limit) for _ in range(count)]
    with bar, ThreadPoolExecutor(count) as pool:
        task = bar.add_task("scenes", total=len(waiting))

        def work(worker: Worker, share: list[Scene]) -> None:
            for scene in share:
                outcome = worker.run(scene)
                rows[scene.solver][scene.number] = row_of(scene, outcome)
                bar.advance(task)
                if outcome.outcome in (LIE, CRASHED, LATE):
                    bar.console.print(
                        f"{scene.solver} {scene.number}: {outcome.outcome}: {outcome.why}", soft_wrap=True
                    )
                if worker is crew[0]:
                    write_all(rows, files)

        try:
            for done in [pool.submit(work, worker, waiting[k::count]) for k, worker in enumerate(crew)]:
                done.result()
        finally:
            for worker in crew:
                worker.stop()
            write_all(rows, files)


def row_of(scene: Scene, outcome: Outcome) -> dict[str, str]:
    """Row of the table: outcome, what was drawn, what was run, what the checks found."""
    numbers = {**scene.drawn, **{f"ran: {name}": value for name, value in outcome.ran.items()}}
    numbers |= {f"check: {name}": value for name, value in outcome.found.items()}
    texts = {name: value if isinstance(value, str) else f"{value:.6g}" for name, value in numbers.items()}
    plain = (scene.solver, str(scene.number), outcome.outcome, outcome.why, f"{outcome.seconds:.2f}")
    return dict(zip(COLUMNS, plain, strict=True)) | texts


def read_rows(file: Path) -> dict[int, dict[str, str]]:
    """Rows of a table by number of the scene; none if there is no table."""
    if not file.exists():
        return {}
    with open(file, newline="", encoding="utf-8") as stream:
        return {int(row["scene"]): row for row in csv.DictReader(stream)}


def write_all(rows: dict[str, dict[int, dict[str, str]]], files: dict[str, Path]) -> None:
    """Write the tables under other names, then rename them."""
    for solver, file in files.items():
        file.parent.mkdir(parents=True, exist_ok=True)
        found = [rows[solver][number] for number in sorted(rows[solver])]
        names = dict.fromkeys([*COLUMNS, *(name for row in found for name in row)])
        part = file.with_name(f".{file.name}.part")
        with open(part, "w", newline="", encoding="utf-8") as stream:
            writer = csv.DictWriter(stream, list(names), lineterminator="\n", restval="")
            writer.writeheader()
            writer.writerows(found)
        os.replace(part, file)


if __name__ == "__main__":
    main()
