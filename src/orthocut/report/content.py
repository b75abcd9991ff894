"""What the report of a study holds, gathered from the results of the workflow."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from platform import python_version

from orthocut.figures.registry import caption
from orthocut.io.provenance import git_commit
from orthocut.io.store import Store
from orthocut.params.identity import digest_datasets, digest_numbers, digest_pictures
from orthocut.plan import Plan, load_plan
from orthocut.report.benchmarks import Benchmark, benchmarks
from orthocut.report.embed import data_uri, shown_width
from orthocut.report.sheets import (
    PAPERS,
    Sheet,
    claim_sheets,
    claims_of,
    is_claims,
    origin_sheet,
    read_sheet,
    run_time_sheet,
)
from orthocut.survey import Survey, as_rows, survey


@dataclass(frozen=True)
class Picture:
    """A figure with all that belongs to it."""

    anchor: str
    title: str
    caption: str
    image: str
    """Data URI."""
    width: int
    """On screen [px]."""
    animation: str = ""
    """Data URI; empty if there is none."""
    table: Sheet | None = None
    claims: list[Sheet] = field(default_factory=list)


@dataclass(frozen=True)
class Content:
    """Everything that the page shows."""

    title: str
    made: str
    summary: list[tuple[str, str]]
    pictures: list[Picture]
    claims: list[Sheet]
    failures: list[tuple[str, str]]
    times: list[Sheet]
    benchmarks: list[Benchmark]
    origins: Sheet
    provenance: list[tuple[str, str]]
    links: list[tuple[str, str, int]] = field(default_factory=list)
    """Sweep, figure, number of cases."""


def gather(study: Path, results: Path, store: Path) -> Content:
    """Collect what the workflow left for a study.

    Parameters
    ----------
    study : Path
        Study file.
    results : Path
        Folder of figures, tables and animations; what is missing there is left out.
    store : Path
        Folder of the results of cases.
    """
    plan = load_plan(study)
    found = survey(plan, Store(store))
    claims = claim_sheets(results)
    each = read_sheet(results / "tables" / "run_times.csv", "Run time and energy balance of each case")
    pictures = [_picture(name, results, claims) for name in plan.figures if _image(name, results).exists()]
    return Content(
        title=plan.title,
        made=datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        summary=_summary(found, pictures),
        pictures=pictures,
        claims=claims,
        failures=[(row["label"], row["reason"]) for row in as_rows(found) if row["state"] == "failed"],
        times=[run_time_sheet(found), *([each] if each else [])],
        benchmarks=benchmarks(results),
        origins=origin_sheet(found, Store(store)),
        provenance=_provenance(study),
        links=_links(plan),
    )


def _summary(found: Survey, pictures: list[Picture]) -> list[tuple[str, str]]:
    counts = found.counts
    seconds = sum(entry.seconds for entry in found.entries.values())
    cases = f"{counts['done']} done, {counts['failed']} failed, {counts['stale'] + counts['missing']} missing"
    animations = sum(bool(picture.animation) for picture in pictures)
    return [
        ("cases", cases),
        ("figures", f"{len(pictures)}, {animations} of them with an animation"),
        ("time of all simulations on one core", f"{seconds / 60:.1f} min"),
    ]


def _provenance(study: Path) -> list[tuple[str, str]]:
    packages = ("orthocut", "numpy", "numba", "scipy", "xarray", "matplotlib", "snakemake")
    return [
        ("study", study.name),
        ("commit of this page", git_commit()),
        ("sources of MPM numbers", digest_numbers("mpm")),
        ("sources of DEM numbers", digest_numbers("dem")),
        ("sources of datasets", digest_datasets()),
        ("sources of pictures", digest_pictures()),
        ("Python", python_version()),
        *((name, version(name)) for name in packages),
    ]


def _links(plan: Plan) -> list[tuple[str, str, int]]:
    return [(sweep, figure, len(cases)) for figure, sweeps in plan.sweeps.items() for sweep, cases in sweeps.items()]


def _image(name: str, results: Path) -> Path:
    return results / "figures" / f"{name}.png"


def _picture(name: str, results: Path, claims: list[Sheet]) -> Picture:
    paper, _, rest = name.partition("_")
    title = f"{PAPERS[paper]}, {_words(rest)}" if paper in PAPERS else _words(name)
    motion = results / "animations" / f"{name}.gif"
    return Picture(
        anchor=name,
        title=title,
        caption=caption(name),
        image=data_uri(_image(name, results)),
        width=shown_width(_image(name, results)),
        animation=data_uri(motion) if motion.exists() else "",
        table=None if is_claims(name) else read_sheet(results / "tables" / f"{name}.csv", f"Table of {title}"),
        claims=claims_of(name, claims),
    )


def _words(name: str) -> str:
    """Fig. 8 for fig08, Fig. 3A for fig03a, Table 4 for table4, other names as words."""
    for short, long in (("fig", "Fig. "), ("table", "Table ")):
        if found := re.fullmatch(rf"{short}0*(\d+[a-z]?)", name):
            return f"{long}{found[1].upper()}"
    return name.replace("_", " ")
