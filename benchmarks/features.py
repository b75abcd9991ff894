"""Table of what each feature costs: medians of rounds, and of the ratios to the default of the same round."""

from __future__ import annotations

import csv
import statistics
from collections.abc import Mapping, Sequence
from pathlib import Path

from rich.console import Console
from rich.table import Table


def write_features(costs: Mapping[str, Sequence[float]], header: Sequence[str], output: Path) -> None:
    """Write a table of costs by variant [ns], among them ``default``, as CSV, and print it."""
    table = Table(*header)
    output.parent.mkdir(parents=True, exist_ok=True)
    with open(output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        for name, found in costs.items():
            ratio = statistics.median(cost / base for cost, base in zip(found, costs["default"], strict=True))
            row = [name, f"{statistics.median(found):.3g}", f"{ratio:.3f}"]
            writer.writerow(row)
            table.add_row(*row)
    Console().print(table)
