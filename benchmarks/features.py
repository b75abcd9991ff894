"""Table of what each feature costs: medians of rounds, and of the ratios to the default of the same round."""

from __future__ import annotations

import statistics
from collections.abc import Mapping, Sequence
from pathlib import Path

from tables import write_table


def write_features(costs: Mapping[str, Sequence[float]], header: Sequence[str], output: Path) -> None:
    """Write a table of costs by variant [ns], among them ``default``, as CSV, and print it."""
    rows = []
    for name, found in costs.items():
        ratio = statistics.median(cost / base for cost, base in zip(found, costs["default"], strict=True))
        rows.append([name, statistics.median(found), f"{ratio:.3f}"])
    write_table(header, rows, output)
