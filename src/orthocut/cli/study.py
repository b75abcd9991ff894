"""``orthocut study``: what studies hold and how far they are."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from orthocut.cli.common import Json, guarded, print_json
from orthocut.params.block import ConfigError, shorten

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
    """Name the studies in a folder: title, number of cases, figures; faulty ones come last, with what is wrong."""
    from orthocut.params.study import load_study

    if not folder.is_dir():
        raise ConfigError(f"{folder}: is not a folder")
    found, faults = [], []
    for path in sorted(folder.glob("*.yaml")):
        if path.name == "default.yaml":
            continue
        try:
            study = load_study(path)
            cases = {key for members in study.cases(str(path)).values() for key in members}
        except ConfigError as error:
            faults.append(str(error))
            continue
        found.append({"name": path.stem, "title": study.title, "cases": len(cases), "figures": list(study.figures)})
    if as_json:
        print_json({"studies": found})
    else:
        for row in found:
            typer.echo(f"{row['name']:<12} {row['cases']:>4} cases, {len(row['figures'])} figures   {row['title']}")
    if faults:
        raise ConfigError("\n".join(faults))


@app.command("expand", epilog="Example:\n\northocut study expand quick --json")
@guarded
def expand(file: StudyFile, as_json: Json = False) -> None:
    """Print the cases of a study: id, sweeps, what varies."""
    rows, study = _cases(file)
    if as_json:
        print_json({"study": str(study_path(file)), "title": study.title, "figures": study.figures, "cases": rows})
        return
    for row in rows:
        typer.echo(f"{row['case_id']}  {row['label']}")
    typer.echo(f"{len(rows)} cases", err=True)


@app.command("status", epilog="Example:\n\northocut study status quick --store results/store")
@guarded
def status(
    file: StudyFile,
    root: Annotated[Path, typer.Option("--store", help="Folder of the results.")] = Path("results/store"),
    as_json: Json = False,
) -> None:
    """Tell which cases are done, failed, stale (made by other sources) and missing, and how long the rest will take."""
    import os

    from orthocut.io.store import Store
    from orthocut.plan import load_plan
    from orthocut.survey import as_rows, survey

    plan = load_plan(study_path(file))
    if root.exists() and not root.is_dir():
        raise ConfigError(f"--store {root}: is not a folder (allowed: the folder of a store, or a new one)")
    found = survey(plan, Store(root))
    rows, counts, cores = as_rows(found), found.counts, os.cpu_count() or 1
    if as_json:
        totals = {"seconds_left_one_core": found.seconds_left, "cores": cores}
        print_json(
            {"study": str(study_path(file)), "title": found.plan.title, "counts": counts, **totals, "cases": rows}
        )
        return
    for row in rows:
        predicted = "" if row["state"] in ("done", "failed") else "predicted"
        typer.echo(f"{row['state']:<8} {row['seconds']:>8.1f} s {predicted:<9}  {row['case_id']}  {row['label']}")
        if row["reason"]:
            typer.echo(f"         {row['reason']}")
    typer.echo(", ".join(f"{count} {state}" for state, count in counts.items()), err=True)
    typer.echo(f"left: about {found.seconds_left / cores / 60:.1f} min on {cores} cores", err=True)


def study_path(file: Path) -> Path:
    """File of a study that is given by its file or by its name; `ConfigError` if it cannot be either."""
    named = CONFIG / f"{file}.yaml"
    try:
        return named if not file.suffix and not file.exists() and named.exists() else file
    except OSError as error:
        raise ConfigError(f"{shorten(str(file))}: cannot be read: {error.strerror}") from None


def _cases(file: Path) -> tuple[list[dict[str, Any]], Study]:
    """One row a case, each case once, in the order of the study."""
    from orthocut.params.study import load_study
    from orthocut.plan import check_figures

    path = study_path(file)
    study = load_study(path)
    sweeps, labels = study.expand(str(path))
    check_figures(study, sweeps, str(path))
    rows: dict[str, dict[str, Any]] = {}
    for sweep, cases in sweeps.items():
        for key, case in cases.items():
            row = rows.setdefault(
                key, {"case_id": key, "label": labels[key], "sweeps": [], "case": case.model_dump(mode="json")}
            )
            row["sweeps"].append(sweep)
    return list(rows.values()), study
