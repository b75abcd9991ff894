"""Tables: the same rows as CSV for programs and as Markdown for people."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from orthocut.io.files import write_text


@dataclass(frozen=True)
class Table:
    """Title, names of the columns with their units, and rows of texts and numbers; NaN is a hole. Notes say why."""

    title: str
    header: list[str]
    rows: list[list[Any]]
    notes: list[str] = field(default_factory=list)

    def csv(self) -> str:
        """Comma-separated text; holes are empty."""
        file = io.StringIO()
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(self.header)
        writer.writerows([_plain(cell, 6, "") for cell in row] for row in self.rows)
        return file.getvalue()

    def markdown(self) -> str:
        """Markdown with the title on top; holes are dashes."""
        lines = [f"# {self.title}", "", _row(self.header), _row(["---"] * len(self.header))]
        lines += [_row([_plain(cell, 4, "-") for cell in row]) for row in self.rows]
        return "\n".join([*lines, "", *self.notes] if self.notes else lines) + "\n"


_SYMBOLS = {r"\alpha": "α", r"\beta": "β", r"\mu": "μ", r"\sigma": "σ", "^{-2}": "^-2", "$": ""}


def plain(text: str) -> str:
    """Text with its mathtext symbols as plain letters."""
    for symbol, letter in _SYMBOLS.items():
        text = text.replace(symbol, letter)
    return text


def _plain(cell: Any, digits: int, hole: str) -> str:
    if isinstance(cell, float):
        return f"{cell:.{digits}g}" if math.isfinite(cell) else hole
    return str(cell) or hole


def _row(cells: list[str]) -> str:
    return f"| {' | '.join(cells)} |"


def write(table: Table, stem: str | Path) -> list[Path]:
    """Write ``stem.csv`` and ``stem.md``."""
    stem = Path(stem)
    texts = {"csv": table.csv(), "md": table.markdown()}
    return [write_text(text, stem.with_name(f"{stem.name}.{form}")) for form, text in texts.items()]


def run_times(runs: list[xr.Dataset], labels: Mapping[str, str]) -> Table:
    """Size, closure of the energy balance and run time of each case, and the total.

    Parameters
    ----------
    runs : list of xarray.Dataset
        Single runs with the attributes ``case_id``, ``particles``, ``steps``, ``wall_time_s``; a missing one is a hole.
    labels : mapping of str to str
        Case id to words for people.
    """
    rows: list[list[Any]] = []
    for run in sorted(runs, key=lambda run: labels.get(run.attrs["case_id"], "")):
        name = run.attrs["case_id"]
        size = [int(run.attrs[key]) if key in run.attrs else math.nan for key in ("particles", "steps")]
        closure = 100.0 * float(run["energy_closure"]) if "energy_closure" in run else math.nan
        state = run.attrs.get("status", "done")
        seconds = float(run.attrs.get("wall_time_s", math.nan))
        rows.append([name, labels.get(name, ""), state, *size, closure, seconds])
    total = float(np.nansum([row[-1] for row in rows]))
    notes = [f"failed: {run.attrs['case_id']}: {run.attrs['failure']}" for run in runs if run.attrs.get("failure")]
    header = ["case", "what", "status", "points or discs", "steps", "energy not accounted for [%]", "run time [s]"]
    return Table(
        "Run times", header, [*rows, [f"{len(rows)} cases", "total", "", math.nan, math.nan, math.nan, total]], notes
    )
