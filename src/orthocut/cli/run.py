"""``orthocut run``: simulate one case."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orthocut.cli.common import Json, guarded, parse_settings, print_json, progress_bar
from orthocut.params.block import CaseFailed, ConfigError

if TYPE_CHECKING:
    import xarray

EXAMPLES = """Examples:

orthocut run mpm --set cut_depth="0.9 mm" --set rake_angle="30 deg" --output cut.nc

orthocut run dem --set tool.friction=0.3 --set grooves={} --json

orthocut run my_case.yaml --set points_per_depth=6
"""


@guarded
def run(
    case: Annotated[
        str,
        typer.Argument(
            metavar="CASE",
            help="A YAML file with the fields of a case, or a kind: mpm, dem, "
            "dem_tension, dem_compression, dem_brazilian, dem_toughness.",
        ),
    ],
    settings: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="FIELD=VALUE",
            help="Override a field; quantities carry a unit; a short name will do where it is unique. Repeatable.",
        ),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="The netCDF file to write.", show_default="CASE_ID.nc")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that holds something else.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No progress bar.")] = False,
    as_json: Json = False,
) -> None:
    """Simulate one case, write it to a netCDF file and print its results.

    The file is written whole at the end, or not at all. A file of the same case is replaced, any other is not. A run of
    more than a minute that is interrupted goes on where it was when the same command is given again.
    """
    from orthocut.params.case import load, load_raw

    checked = load(case, parse_settings(settings or [], load_raw(case)["kind"]))
    path = _check_output(output, checked, force)

    from orthocut.io.checkpoint import Checkpoint
    from orthocut.io.netcdf import write
    from orthocut.params.identity import result_key
    from orthocut.run import run_case

    def announce(seconds: float) -> None:
        if not quiet:
            typer.echo(f"going on after {seconds:.0f} s of an earlier run", err=True)

    hidden = path.with_name(f".{path.name}.checkpoint.npz")
    checkpoint = Checkpoint(hidden, result_key(checked), announce=announce)
    try:
        with progress_bar(path.name, quiet or as_json) as progress:
            dataset = run_case(checked, progress, checkpoint)
            write(dataset, path)
    except KeyboardInterrupt:
        if hidden.exists():
            typer.echo(f"the same command goes on from {hidden}", err=True)
        raise
    except CaseFailed:
        checkpoint.remove()
        raise
    checkpoint.remove()
    results = summary(dataset)
    if as_json:
        print_json({**results, "output": str(path)})
    else:
        from orthocut.cli.report import print_results

        print_results(results, path)


def _check_output(output: Path | None, case: object, force: bool) -> Path:
    """Path to write to; refuse before the simulation starts what would fail or destroy something after it."""
    from orthocut.params.identity import case_id

    path = output or Path(f"{case_id(case)}.nc")
    if path.is_dir() or not path.name:
        raise ConfigError(f"--output {path}: is a folder (allowed: the name of a file)")
    folder = path.parent
    if not folder.is_dir():
        why = "is not a folder" if folder.exists() else "does not exist"
        raise ConfigError(f"--output {path}: {folder} {why} (allowed: a file in an existing folder)")
    if not os.access(folder, os.W_OK | os.X_OK):
        raise ConfigError(f"--output {path}: {folder} cannot be written to (allowed: a file in a writable folder)")
    if path.exists() and not force and _held(path) != case_id(case):
        raise ConfigError(
            f"--output {path}: exists and does not hold this case; another name, or --force to replace it"
        )
    return path


def _held(path: Path) -> str | None:
    """Case id of a netCDF file, None when it is something else."""
    import netCDF4

    try:
        with netCDF4.Dataset(path) as file:
            return getattr(file, "case_id", None)
    except OSError:
        return None


def summary(dataset: xarray.Dataset) -> dict[str, object]:
    """Results of a run: every variable without dimensions, in SI units."""
    scalars = {str(name): variable for name, variable in dataset.data_vars.items() if not variable.dims}
    return {
        "case_id": dataset.attrs["case_id"],
        "kind": dataset.attrs["kind"],
        "results": {name: variable.item() for name, variable in scalars.items()},
        "units": {name: variable.attrs.get("units", "1") for name, variable in scalars.items()},
        "wall_time_s": dataset.attrs["wall_time_s"],
        "source_digest": dataset.attrs["source_digest"],
    }
