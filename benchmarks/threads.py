"""What threads within a run could gain at the most: halves of a block of glass, stepped in turn or at once.

The halves do not touch, so that nothing is exchanged, and the threads meet once a step: any division of one block costs
more. Run times are by the clock; the machine must have two idle cores.
"""

from __future__ import annotations

import argparse
import ctypes
import statistics
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numba
import numpy as np
from glass_blocks import glass_blocks
from rich.console import Console
from rich.progress import track
from tables import write_table

from orthocut.dem.solver import step_once

sched_yield = ctypes.CDLL(None).sched_yield
sched_yield.argtypes, sched_yield.restype = [], ctypes.c_int
LINE = 64
"""Numbers in a count of which only the first is used: the counts of two threads share no line of the cache."""

HEADER = ["bonds in both halves", "step of both, one thread [ms]", "two threads [ms]", "ratio [-]"]
SIZES = ((0.25, 1), (0.5, 1), (1.0, 1), (1.0, 2), (1.0, 4), (1.0, 8))
"""Share of the width of the paper's block, and blocks along either side of a square."""
REPEATS = 5
BONDS = 20_000_000
"""Bonds times steps of a repeat."""


@numba.njit(nogil=True)
def in_turn(first, second, steps):
    """Step two scenes one after the other."""
    for _ in range(steps):
        step_once(first)
        step_once(second)


@numba.njit(nogil=True)
def in_step(scene, steps, own, other):
    """Step a scene and wait after each step until another thread has done as many; the counts say how many that are."""
    for n in range(1, steps + 1):
        step_once(scene)
        own[0] = n
        while other[0] < n:
            sched_yield()


def at_once(first, second, steps):
    """Step two scenes in two threads that meet after each step."""
    counts = np.zeros(LINE), np.zeros(LINE)
    with ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(in_step, first, steps, *counts), pool.submit(in_step, second, steps, *counts[::-1])]
        for job in jobs:
            job.result()


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/threads.csv"))
    options = parser.parse_args()
    rows = [measure(*size) for size in track(SIZES, "measuring", console=Console(stderr=True))]
    write_table(HEADER, rows, options.output)


def measure(width: float, blocks: int) -> list:
    """Row of a size."""
    halves = glass_blocks(blocks, width), glass_blocks(blocks, width)
    bonds = sum(len(half.joints.first) for half in halves)
    steps = max(20, BONDS // bonds)
    times = {way: [] for way in (in_turn, at_once)}
    for way in times:
        way(*halves, 20)
    for _ in range(REPEATS):
        for way, found in times.items():
            start = time.perf_counter()
            way(*halves, steps)
            found.append(1e3 * (time.perf_counter() - start) / steps)
    single, double = (statistics.median(found) for found in times.values())
    return [bonds, single, double, single / double]


if __name__ == "__main__":
    main()
