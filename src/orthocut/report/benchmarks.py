"""Benchmarks in the report: their pictures and short tables, new ones in place of published ones of the same name."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from orthocut.report.embed import data_uri, shown_width
from orthocut.report.sheets import Sheet, read_sheet

FOLDERS = ("published/benchmarks", "benchmarks")
"""Where benchmarks leave pictures and tables, below the results; later ones take the place of earlier ones."""
MOST_ROWS = 70
"""Longer tables, such as that of all random scenes, are left to their files."""
TITLES = {
    "skips": "What is left out where a scene does not need it",
    "mpm_features": "Cost of a ductile step by feature",
    "dem_features": "Cost of a step of bonded discs by feature",
    "scaling": "Cost of a step over the size of the scene",
    "threads": "What threads within a run could gain at the most",
    "peers": "Beside LAMMPS",
    "peers_mpm": "Beside Taichi",
    "roofline": "What bounds a step",
    "setup_cost": "Set-up",
    "cost_model": "Predicted and measured run times of short cases",
    "cost_store": "Predicted and measured run times of a store",
    "accuracy": "New ductile cuts beside what presets and tolerances promise",
    "glass_speed": "What the speed of the tool adds to the forces of cuts of glass",
    "stable_step": "Largest stable steps",
    "stress": "Random scenes",
    "workflow": "Cost of the workflow beside the simulations",
    "checkpoints": "Checkpoints",
    "faults": "Faults and what came of them",
}


@dataclass(frozen=True)
class Benchmark:
    """One benchmark: a picture, a table, or both."""

    anchor: str
    title: str
    image: str
    """Data URI; empty if there is none."""
    width: int
    """On screen [px]."""
    table: Sheet | None


def benchmarks(results: Path) -> list[Benchmark]:
    """All benchmarks whose picture or short table lies below the results, known ones first.

    Parameters
    ----------
    results : Path
        Folder of the results of the workflow.
    """
    pictures, tables = _files(results, ".png"), _files(results, ".csv")
    names = sorted(pictures.keys() | tables.keys())
    ordered = [*(name for name in TITLES if name in names), *(name for name in names if name not in TITLES)]
    found = [_benchmark(name, pictures.get(name), tables.get(name), results) for name in ordered]
    return [one for one in found if one.image or one.table]


def files(results: Path) -> list[Path]:
    """Pictures and tables of all benchmarks below the results."""
    return [path for suffix in (".png", ".csv") for path in _files(results, suffix).values()]


def _files(results: Path, suffix: str) -> dict[str, Path]:
    return {path.stem: path for folder in FOLDERS for path in sorted((results / folder).glob(f"*{suffix}"))}


def _benchmark(name: str, picture: Path | None, table: Path | None, results: Path) -> Benchmark:
    place = table.relative_to(results).as_posix() if table else ""
    sheet = read_sheet(table, place, f"benchmark-table-{name}") if table else None
    return Benchmark(
        anchor=f"benchmark-{name}",
        title=TITLES.get(name, name.replace("_", " ")),
        image=data_uri(picture) if picture else "",
        width=shown_width(picture) if picture else 0,
        table=sheet if sheet and 0 < len(sheet.rows) <= MOST_ROWS else None,
    )
