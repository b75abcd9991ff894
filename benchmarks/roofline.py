"""How far the steps are from what the machine can do: operations and bytes of a step against measured peaks.

Operations are counted in the sources, an addition, multiplication, division or root each as one; bytes are those of
the state that a step reads and writes once, without the grid or the discs, which stay in the first caches.
"""

from __future__ import annotations

import argparse
import statistics
import time
from pathlib import Path
from typing import NamedTuple

import numpy as np
from tables import write_table

from orthocut.experiments.speed_dem import bench_dem
from orthocut.experiments.speed_mpm import bench_mpm
from orthocut.figures.canvas import PAGE, page, styled
from orthocut.figures.palette import BLUE, ORANGE
from orthocut.figures.save import save
from orthocut.kernels.jit import jit

HEADER = ["kernel", "operations", "bytes", "measured [ns]", "at peak of operations [ns]", "at memory of state [ns]"]
HEADER += ["of peak operations [%]", "of bandwidth [%]"]
ORDER = 768
"""Rows of a matrix."""
SIZES = {"first cache": 16e3, "second cache": 512e3, "third cache": 12e6, "memory": 400e6}
"""Bytes that a triad touches, to be in one level of the memory."""


class Kernel(NamedTuple):
    """A step of one particle or bond."""

    words: str
    operations: int
    """In one step."""
    bytes: int
    """Read and written in one step."""
    level: str
    """Where the state of a scene of usual size lies."""


KERNELS = {
    "mpm": Kernel("material point: transfers, law, grid", 490, 176, "third cache"),
    "dem": Kernel("flat joint: frame, law, resultants", 96, 112, "second cache"),
}
"""Joint: 20 to gather and turn the frame with one root and one division, 24 of the law and its strengths, 20 to resolve
resultants, 12 to add them; 9 fields read, 5 written. Point: as counted in the prototypes of this solver."""


@jit
def triad(first, second, third, rounds):
    """Read two arrays, write a third."""
    for _ in range(rounds):
        for k in range(first.size):
            third[k] = first[k] + 3.0 * second[k]


def peak_operations() -> float:
    """Operations a second of one core, in the product of two matrices by a tuned library."""
    first = np.ones((ORDER, ORDER))
    return 2 * ORDER**3 / _least(lambda: first @ first)


def bandwidth(size: float) -> float:
    """Bytes a second of one core, with arrays of so many bytes in all."""
    arrays = [np.ones(int(size / 24)) for _ in range(3)]
    rounds = max(1, int(4e8 / size))
    triad(*arrays, 1)
    return 24 * arrays[0].size * rounds / _least(lambda: triad(*arrays, rounds))


def _least(work, repeats: int = 7) -> float:
    found = []
    for _ in range(repeats):
        start = time.process_time()  # of all threads, should the library have more
        work()
        found.append(time.process_time() - start)
    return min(found)


def main() -> None:
    """Measure, write a table as CSV, draw it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/roofline.csv"))
    options = parser.parse_args()

    peak = peak_operations()
    levels = {name: bandwidth(size) for name, size in SIZES.items()}
    costs = {
        "mpm": statistics.median(bench_mpm(values={"reach_ratio": 0.0})["ns_per_point_step"] for _ in range(3)),
        "dem": statistics.median(bench_dem()["ns_per_bond_step_quiescent"] for _ in range(3)),
    }
    rows = []
    for name, kernel in KERNELS.items():
        least = 1e9 * kernel.operations / peak, 1e9 * kernel.bytes / levels[kernel.level]
        shares = [100 * one / costs[name] for one in least]
        rows.append([kernel.words, kernel.operations, kernel.bytes, costs[name], *least, *shares])
    write_table(HEADER, rows, options.output)
    save(draw(peak, levels, costs), options.output.with_suffix(".png"))


@styled
def draw(peak: float, levels: dict[str, float], costs: dict[str, float]):
    """Operations a second over operations a byte, below the roofs."""
    figure = page(2.8, 0.6 * PAGE)
    ax = figure.subplots()
    intensity = np.geomspace(0.03, 100, 200)
    for shade, (name, speed) in zip((0.2, 0.4, 0.55, 0.7), levels.items(), strict=True):
        roof = np.minimum(peak, speed * intensity)
        ax.plot(intensity, 1e-9 * roof, color=str(shade), lw=0.8)
        ax.text(0.035, 1.5e-9 * speed * 0.035, name, color=str(shade), fontsize=5, rotation=38, va="bottom")
    ax.text(100, 1.1e-9 * peak, "product of matrices", ha="right", fontsize=5)
    for (name, kernel), colour in zip(KERNELS.items(), (BLUE, ORANGE), strict=True):
        ax.plot(
            kernel.operations / kernel.bytes, kernel.operations / costs[name], "o", color=colour, label=kernel.words
        )
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel("operations for a byte of state [1/B]")
    ax.set_ylabel("operations of one core [1/ns]")
    figure.legend(loc="outside upper center", ncols=1)
    return figure


if __name__ == "__main__":
    main()
