"""Cost of a step over the size of the scene, memory, and what two runs at once on two cores cost each other.

Material points: the strip of Nairn (2015) with more and more points through the chip, and at rest far from the tool or
not. Bonded discs: blocks of Yang et al. (2018) side by side, pulled apart; one block is packed, the others are its
copies. Each size is measured in a process of its own, alone and then beside a second one that does the same.
"""

from __future__ import annotations

import argparse
import csv
import math
import multiprocessing
import resource
import statistics
import time
from pathlib import Path

from rich.console import Console
from rich.progress import track

from orthocut.figures.canvas import PAGE, page, styled
from orthocut.figures.palette import BLUE, ORANGE, PURPLE
from orthocut.figures.save import save

HEADER = ["method", "particles", "bonds", "cost [ns]", "beside another run [ns]", "memory of a particle [kB]"]
POINTS, WHOLE, DISCS = "material point, most at rest", "material point, none at rest", "bond between discs"
SIZES = {POINTS: (3, 6, 12, 23, 46), WHOLE: (3, 6, 12, 23, 46, 92), DISCS: (1, 2, 4, 8, 15)}
"""Points through the chip; blocks along either side of a square."""
MOST = 46
"""Most points through the chip; where more are asked for, the strip is longer instead."""
STEPS = 20_000_000
"""Particles times steps of a repeat."""
REPEATS = 3


def measure(method: str, size: int) -> tuple[int, int, float, float]:
    """Particles, bonds, cost of a particle or bond and step [ns], memory of the process [bytes]."""
    particles, bonds, cost = _discs(size) if method == DISCS else _points(size, 8.0 if method == POINTS else 0.0)
    return particles, bonds, cost, 1024.0 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def _points(size: int, reach_ratio: float) -> tuple[int, int, float]:
    from orthocut.experiments.speed_mpm import bench_mpm

    steps = max(10, STEPS // (118 * size**2))
    length = 30.0 * max(1.0, (size / MOST) ** 2)
    found = bench_mpm(min(size, MOST), steps, REPEATS, {"reach_ratio": reach_ratio, "length_ratio": length})
    return found["points"], 0, found["ns_per_point_step"]


def _discs(blocks: int) -> tuple[int, int, float]:
    from glass_blocks import glass_blocks

    from orthocut.experiments.dem_run import proceed

    scene = glass_blocks(blocks)
    steps = max(20, STEPS // (10 * len(scene.radius)))
    proceed(scene, steps)
    bonds, costs = len(scene.joints.first), []
    for _ in range(REPEATS):
        start = time.thread_time()
        proceed(scene, steps)
        costs.append(1e9 * (time.thread_time() - start) / steps / bonds)
    return len(scene.radius), bonds, statistics.median(costs)


def main() -> None:
    """Measure, write a table as CSV, draw it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--largest", type=int, default=1_000_000, help="largest number of particles, about")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/scaling.csv"))
    options = parser.parse_args()

    jobs = [
        (method, size) for method, sizes in SIZES.items() for size in sizes if _count(method, size) <= options.largest
    ]
    context, rows = multiprocessing.get_context("spawn"), []
    for job in track(jobs, "measuring", console=Console(stderr=True)):
        with context.Pool(1, maxtasksperchild=1) as pool:
            particles, bonds, alone, memory = pool.apply(measure, job)
        with context.Pool(2, maxtasksperchild=1) as pool:
            beside = statistics.mean(found[2] for found in pool.starmap(measure, [job, job], 1))
        rows.append((job[0], particles, bonds, alone, beside, memory))
    least = {method: min(row[5] for row in rows if row[0] == method) for method in SIZES}
    table = [[*row[:3], f"{row[3]:.3g}", f"{row[4]:.3g}", _each(row, least[row[0]])] for row in rows]
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([HEADER, *table])
    save(draw(rows), options.output.with_suffix(".png"))


def _count(method: str, size: int) -> int:
    return 2085 * size**2 if method == DISCS else 118 * size**2


def _each(row: tuple, least: float) -> str:
    """Memory of a particle, that of the interpreter left out [kB]; nothing where the interpreter is all."""
    each = (row[5] - least) / row[1] / 1e3
    return f"{each:.2g}" if row[5] > 1.5 * least else ""


@styled
def draw(rows: list[tuple]):
    """Cost over size, alone and beside another run."""
    figure = page(2.8, 0.6 * PAGE)
    ax = figure.subplots()
    for method, colour in zip(SIZES, (BLUE, PURPLE, ORANGE), strict=True):
        own = [row for row in rows if row[0] == method]
        sizes = [row[2] or row[1] for row in own]
        ax.plot(sizes, [row[3] for row in own], "o-", color=colour, label=method)
        ax.plot(sizes, [row[4] for row in own], "o:", color=colour, mfc="white")
    ax.plot([], [], "o:", color="0.4", mfc="white", label="beside a second run")
    ax.set_xscale("log")
    ax.set_yscale("log")
    top = max(row[3] for row in rows)
    ax.set_ylim(10 ** math.floor(math.log10(min(row[3] for row in rows))), 3 * top)
    ax.set_xlabel("number of points or bonds [-]")
    ax.set_ylabel("cost of one and a step [ns]")
    figure.legend(loc="outside upper center", ncols=2)
    return figure


if __name__ == "__main__":
    main()
