"""Tables of the report, from CSV files and from what the store tells."""

from __future__ import annotations

import csv
import re
from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path

from orthocut.cost import estimate_seconds
from orthocut.io.store import Store
from orthocut.params.identity import result_key
from orthocut.survey import Survey

PAPERS = {"nairn2015": "Nairn (2015)", "yang2018": "Yang et al. (2018)"}
_ORIGIN = ("git_commit", "source_digest", "versions")


@dataclass(frozen=True)
class Sheet:
    """A table: title, header, rows of texts, place in the page."""

    title: str
    header: list[str]
    rows: list[list[str]]
    anchor: str


def read_sheet(path: Path, title: str, anchor: str = "") -> Sheet | None:
    """Table of a CSV file, without rows if the file is empty; None if there is no file."""
    if not path.exists():
        return None
    with open(path, newline="", encoding="utf-8") as file:
        header, *rows = list(csv.reader(file)) or [[]]
    return Sheet(title, header, rows, anchor or f"table-{path.stem}")


def claim_sheets(results: Path) -> list[Sheet]:
    """Tables of claims: of the study, and the published ones of each paper."""
    own = [
        read_sheet(path, f"Claims, {_study_of(path.stem)}")
        for path in sorted(results.glob("tables/*claims*.csv"))
        if is_claims(path.stem)
    ]
    published = [
        read_sheet(path, f"Claims of {PAPERS.get(path.parent.name, path.parent.name)}", f"claims-{path.parent.name}")
        for path in sorted(results.glob("published/*/claims.csv"))
    ]
    return own + published


def is_claims(stem: str) -> bool:
    """Whether a table is one of claims, by its name."""
    return stem.startswith("claims") or stem.endswith("_claims")


def _study_of(stem: str) -> str:
    """Whose claims a file holds: a paper's or a study's."""
    name = stem.removeprefix("claims").removesuffix("claims").strip("_-")
    return PAPERS.get(name, name) or "this study"


def claims_of(figure: str, sheets: list[Sheet]) -> list[Sheet]:
    """Those rows of each table of claims that name a figure, as a word."""
    word = re.compile(rf"\b{re.escape(figure)}\b")
    found = [replace(sheet, rows=[row for row in sheet.rows if word.search(" ".join(row))]) for sheet in sheets]
    return [replace(sheet, anchor=f"{figure}-{sheet.anchor}") for sheet in found if sheet.rows]


def run_time_sheet(found: Survey) -> Sheet:
    """Measured and predicted run time of each kind of case."""
    kinds = sorted({case.kind for case in found.plan.cases.values()})
    rows = []
    for kind in kinds:
        mine = {case_id for case_id, case in found.plan.cases.items() if case.kind == kind}
        there = [found.entries[case_id] for case_id in mine if case_id in found.entries]
        left = [case_id for case_id in found.missing if case_id in mine]
        measured = sum(entry.seconds for entry in there)
        expected = sum(estimate_seconds(found.plan.cases[case_id]) for case_id in mine if case_id in found.entries)
        ahead = sum(found.seconds(case_id) for case_id in left)
        times = (f"{seconds / 60:.1f}" for seconds in (measured, expected, ahead))
        rows.append([kind, str(len(there)), *(next(times) for _ in range(2)), str(len(left)), next(times)])
    header = ["kind", "cases run", "measured [min]", "predicted [min]", "cases missing", "predicted for these [min]"]
    return Sheet("Run time on one core", header, rows, "times-by-kind")


def origin_sheet(found: Survey, store: Store) -> Sheet:
    """Commits, sources and versions that made the results, with how many each."""
    counted: Counter[tuple[str, ...]] = Counter()
    for case_id in found.entries:
        attributes = store.read(result_key(found.plan.cases[case_id])).attrs
        counted[tuple(str(attributes.get(name, "unknown")) for name in _ORIGIN)] += 1
    rows = [[str(count), *origin] for origin, count in counted.most_common()]
    return Sheet("What made the results", ["results", "commit", "digest of sources", "versions"], rows, "origins")
