"""Results for people: tables with words and display units."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

from orthocut.variables import VARIABLES


def shown(name: str, value: float, unit: str) -> tuple[str, str, str]:
    """Words, value and unit of a result."""
    row = VARIABLES.get(name)
    if row is None:
        return name, f"{value:.5g}", "" if unit == "1" else unit
    unit = row.display or row.unit
    text = f"{value * row.scale:.5g}" if math.isfinite(value) else "none"
    return row.long_name, text, "" if unit == "1" else unit


def print_rows(title: str, rows: list[tuple[str, str, str]]) -> None:
    """Print words, values and units in columns."""
    table = Table(title=title, title_justify="left", box=None, show_header=False, pad_edge=False)
    table.add_column()
    table.add_column(justify="right")
    table.add_column()
    for row in rows:
        table.add_row(*row)
    Console(highlight=False).print(table)


def print_results(results: dict[str, Any], path: Path) -> None:
    """Print what `orthocut.cli.run.summary` found."""
    rows = [shown(name, value, results["units"][name]) for name, value in results["results"].items()]
    rows.append(("run time", f"{results['wall_time_s']:.3g}", "s"))
    print_rows(f"{results['kind']}: {path}", rows)
