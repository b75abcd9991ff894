"""``orthocut show``: a figure of one run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from orthocut.cli.common import guarded
from orthocut.params.block import ConfigError

EXAMPLES = """Example:

orthocut show cut.nc --output cut.png
"""

FORMATS = (".png", ".svg", ".pdf")


@guarded
def show(
    file: Annotated[Path, typer.Argument(metavar="RUN.nc", help="A file that `orthocut run` wrote.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="PNG, SVG or PDF file to draw.", show_default="RUN.png")
    ] = None,
) -> None:
    """Draw the forces, the energies and the last snapshot of a run."""
    output = output or file.with_suffix(".png")
    if output.suffix.lower() not in FORMATS:
        raise ConfigError(f"--output {output}: unknown kind of picture (allowed: {', '.join(FORMATS)})")
    if not file.is_file():
        raise ConfigError(f"{file}: cannot be read: no such file")

    import matplotlib

    matplotlib.use("agg")
    from orthocut.figures.save import save
    from orthocut.figures.show import draw
    from orthocut.io.netcdf import read

    try:
        dataset = read(file)
    except (OSError, ValueError) as error:
        raise ConfigError(f"{file}: is not a netCDF file: {error}") from None
    if "case_id" not in dataset.attrs:
        raise ConfigError(f"{file}: was not written by `orthocut run`: it has no case")
    save(draw(dataset), output)
    typer.echo(str(output))
