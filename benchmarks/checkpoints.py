"""What a checkpoint costs: time and size of one, for each kind of case at the size of the papers."""

from __future__ import annotations

import argparse
import contextlib
import statistics
import tempfile
import time
from pathlib import Path

from tables import write_table

from orthocut.io.checkpoint import INTERVAL, Checkpoint
from orthocut.params.case import load
from orthocut.params.size import particles
from orthocut.run import run_case

CASES = {
    "mpm_cutting": {"points_per_depth": 15},
    "dem_cutting": {},
    "dem_tension": {"packing.width": "1 mm", "packing.height": "2 mm"},
    "dem_compression": {"packing.width": "1 mm", "packing.height": "2 mm"},
}
HEADER = ["kind", "particles", "size [MB]", "time [ms]", f"share of the run time at one in {INTERVAL:.0f} s [%]"]
REPEATS = 9


class Enough(Exception):
    """Ends a run that has saved often enough."""


class Timed(Checkpoint):
    """Saves at every occasion and remembers how long it took."""

    def __init__(self, path: Path) -> None:
        super().__init__(path, "benchmark", every=0.0)
        self.times: list[float] = []

    def offer(self, make) -> bool:
        """Save, timed; stop the run when that was done often enough."""
        began = time.perf_counter()
        super().offer(make)
        self.times.append(time.perf_counter() - began)
        if len(self.times) == REPEATS:
            raise Enough
        return True


def measure(kind: str) -> list[object]:
    """One row of the table: the median of some checkpoints, flushed to the disk as in a run."""
    case = load(kind, CASES[kind])
    with tempfile.TemporaryDirectory(prefix="orthocut-checkpoint-") as folder:
        checkpoint = Timed(Path(folder, "state.npz"))
        with contextlib.suppress(Enough):
            run_case(case, lambda fraction: None, checkpoint, 0)
        size = checkpoint.path.stat().st_size
    seconds = statistics.median(checkpoint.times)
    return [kind, particles(case), 1e-6 * size, 1e3 * seconds, 100 * seconds / INTERVAL]


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/checkpoints.csv"))
    options = parser.parse_args()
    write_table(HEADER, map(measure, CASES), options.output)


if __name__ == "__main__":
    main()
