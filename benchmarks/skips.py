"""What is skipped where a scene does not need it: the saving, and how far the answer moves.

Both sides of a pair are measured one after the other in each round, so that they share the machine's mood; the table
holds medians of the ratios.
"""

from __future__ import annotations

import argparse
import csv
import math
import statistics
from pathlib import Path

import skips_dem
import skips_mpm
from rich.console import Console
from rich.progress import track
from rich.table import Table

HEADER = ["solver", "skipped", "cost with it over cost without [-]", "saved [%]", "change of the answer [-]"]


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5, help="rounds over each pair")
    parser.add_argument("--only", choices=("glass", "ductile"), help="one solver alone")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/skips.csv"))
    options = parser.parse_args()

    sources = {"glass": skips_dem.skips, "ductile": skips_mpm.skips}
    chosen = [source for solver, source in sources.items() if options.only in (None, solver)]
    table = Table(*HEADER)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for skip in (skip for source in chosen for skip in source()):
            skip.skipping(), skip.without()  # compiles
            rounds = track(range(options.rounds), f"{skip.solver}: {skip.what}", console=Console(stderr=True))
            ratio = statistics.median(skip.without() / skip.skipping() for _ in rounds)
            change = skip.change()
            row = [skip.solver, skip.what, f"{ratio:.3f}", f"{100 * (1 - 1 / ratio):.1f}"]
            row.append("none" if change == 0 else "" if math.isnan(change) else f"{change:.1e}")
            writer.writerow(row)
            table.add_row(*row)
    Console().print(table)


if __name__ == "__main__":
    main()
