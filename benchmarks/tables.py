"""Table of a benchmark: written as CSV, and printed."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path

from rich.console import Console
from rich.table import Table


def write_table(header: Sequence[str], rows: Iterable[Sequence[object]], output: Path) -> None:
    """Write rows below a header, numbers with three digits, and print them."""
    table = Table(*header)
    output.parent.mkdir(parents=True, exist_ok=True)
    with open(output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        for row in rows:
            words = [f"{cell:.3g}" if isinstance(cell, float) else str(cell) for cell in row]
            writer.writerow(words)
            table.add_row(*words)
    Console().print(table)
