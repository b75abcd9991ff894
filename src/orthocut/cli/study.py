"""``orthocut study``: what studies hold and how far they are."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from orthocut.cli.common import Json, guarded, print_json
from orthocut.params.block import ConfigError

if TYPE_CHECKING:
    from orthocut.params.study import Study

CONFIG = Path("workflow/config")

app = typer.Typer(
    help="List, expand and follow studies.",
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
StudyFile = Annotated[Path, typer.Argument(metavar="STUDY.yaml", help=f"A study file, or the name of one in {CONFIG}.")]


@app.command("list", epilog="Example:\n\northocut study list")
@guarded
def list_studies(
    folder: Annotated[Path, typer.Argument(help="Folder with study files.")] = CONFIG, as_json: Json = False
) -> None:
    """Name the studies in a folder: title, number of cases, figures."""
    from orthocut.params.study import load_study

    if not folder.is_dir():
        raise ConfigError(f"{folder}: is not a folder")
    found = []
    for path in sorted(folder.glob("*.yaml")):
        if path.name != "default.yaml":
            study = load_study(path)
            found.append(
                {
                    "name": path.stem,
                    "title": study.title,
                    "cases": len({key for cases in study.cases(str(path)).values() for key in cases}),
                    "figures": list(study.figures),
                }
            )
    if as_json:
        print_json({"studies": found})
        return
    for row in found:
        typer.echo(f"{row['name']:<12} {row['cases']:>4} cases, {len(row['figures'])} figures   {row['title']}")


@app.command("expand", epilog="Example:\n\northocut study expand quick --json")
@guarded
def expand(file: StudyFile, as_json: Json = False) -> None:
    """Print the cases of a study: id, sweeps, what varies."""
    rows, study = _cases(file)
    if as_json:
        print_json({"study": str(_path(file)), "title": study.title, "figures": study.figures, "cases": rows})
        return
    for row in rows:
        typer.echo(f"{row['case_id']}  {row['label']}")
    typer.echo(f"{len(rows)} cases", err=True)


@app.command("status", epilog="Example:\n\northocut study status quick --results results")
@guarded
def status(
    file: StudyFile,
    results: Annotated[Path, typer.Option(help="Folder that the workflow writes.")] = Path("results"),
    as_json: Json = False,
) -> None:
    """Tell which cases are done, which are out of date because sources changed, and which are missing."""
    import netCDF4

    from orthocut.params.identity import digest_numbers

    rows, study = _cases(file)
    for row in rows:
        path = results / "runs" / f"{row['case_id']}.nc"
        row["state"], row["wall_time_s"] = "missing", None
        if path.exists():
            try:
                with netCDF4.Dataset(path) as run:
                    current = run.source_digest == digest_numbers(row["case"]["kind"])
                    row["state"] = "done" if current else "out of date"
                    row["wall_time_s"] = float(run.wall_time_s)
            except (OSError, AttributeError):
                row["state"] = "unreadable"
    counts = {state: sum(row["state"] == state for row in rows) for state in ("done", "out of date", "missing")}
    if as_json:
        slim = [{key: value for key, value in row.items() if key != "case"} for row in rows]
        print_json({"study": str(_path(file)), "title": study.title, "counts": counts, "cases": slim})
        return
    for row in rows:
        seconds = "" if row["wall_time_s"] is None else f"{row['wall_time_s']:.1f} s"
        typer.echo(f"{row['state']:<12} {seconds:>9}  {row['case_id']}  {row['label']}")
    typer.echo(", ".join(f"{count} {state}" for state, count in counts.items()), err=True)


def _path(file: Path) -> Path:
    named = CONFIG / f"{file}.yaml"
    return named if not file.suffix and not file.exists() and named.exists() else file


def _cases(file: Path) -> tuple[list[dict[str, Any]], Study]:
    """One row a case, each case once, in the order of the study."""
    from orthocut.params.study import load_study

    path = _path(file)
    study = load_study(path)
    sweeps, labels = study.expand(str(path))
    rows: dict[str, dict[str, Any]] = {}
    for sweep, cases in sweeps.items():
        for key, case in cases.items():
            row = rows.setdefault(
                key, {"case_id": key, "label": labels[key], "sweeps": [], "case": case.model_dump(mode="json")}
            )
            row["sweeps"].append(sweep)
    return list(rows.values()), study
