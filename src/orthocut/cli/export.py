"""``orthocut export``: particles for ParaView and OVITO."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from orthocut.cli.common import guarded
from orthocut.params.block import ConfigError

EXAMPLES = """Examples:

orthocut export cut.nc --output cut.pvd

orthocut export cut.nc --output cut.xyz

orthocut export cut.nc --output end.vtp --snapshot 5
"""


@guarded
def export(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="RUN.nc", help="A file that `orthocut run` wrote, or KEY.snapshots.nc of the store of results."
        ),
    ],
    output: Annotated[
        Path,
        typer.Option(
            "--output",
            "-o",
            help="File to write: .pvd (ParaView, all snapshots), .vtp (ParaView, one), .xyz (OVITO, all).",
        ),
    ],
    snapshot: Annotated[
        int | None,
        typer.Option("--snapshot", metavar="N", help="Only this snapshot, counted from 0; default for .vtp: the last."),
    ] = None,
) -> None:
    """Write the snapshots of a run as particles that ParaView and OVITO open.

    All values are SI: positions and radius in m, stress_equivalent in Pa, strain_plastic and deformation (the gradient:
    xx xy xz yx ... zz) without unit, intact (the bonded fraction of the elements of a disc or a joint), TimeValue or
    Time in s. The radius of a material point is the half-width of its undeformed square. ParaView files come with
    joints and cracks (mode: 0 tension, 1 shear; time in s; normal in rad to the x axis) as lines in files of their own.
    """
    from orthocut.io.export import check_format
    from orthocut.io.export import export as write

    check_format(output)
    if output.is_dir():
        raise ConfigError(f"--output {output}: is a folder (allowed: the name of a file)")
    if not output.parent.is_dir():
        raise ConfigError(f"--output {output}: {output.parent} is not a folder (allowed: a file in an existing folder)")
    if not file.is_file():
        raise ConfigError(f"{file}: cannot be read: no such file")

    from orthocut.io.netcdf import read

    try:
        dataset = read(file)
    except (OSError, ValueError) as error:
        raise ConfigError(f"{file}: is not a netCDF file: {error}") from None
    if "case_id" not in dataset.attrs and "case" not in dataset.dims:
        raise ConfigError(f"{file}: was not written by `orthocut run`: it has no case")
    typer.echo(str(write(dataset, output, snapshot, str(file))[0]))
