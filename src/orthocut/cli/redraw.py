"""``orthocut redraw``: figures and tables from collected datasets."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from orthocut.cli.common import guarded, progress_bar
from orthocut.params.block import ConfigError

EXAMPLES = """Example:

orthocut redraw results/published/nairn2015 --output results/redrawn
"""


@guarded
def redraw(
    folder: Annotated[
        Path, typer.Argument(metavar="FOLDER", help="Folder of datasets that carry the names of figures, NAME.nc.")
    ],
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for pictures and tables; made if need be.")],
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No progress bar.")] = False,
) -> None:
    """Draw figures and tables anew from their datasets, without a simulation and without a store."""
    import matplotlib

    matplotlib.use("agg")
    from orthocut.figures import registry, tables
    from orthocut.figures.save import save
    from orthocut.io.netcdf import read

    datasets = [path for path in sorted(folder.glob("*.nc")) if path.stem in registry.FIGURES]
    if not datasets:
        raise ConfigError(f"{folder}: holds no dataset with the name of a figure ({', '.join(registry.FIGURES)})")
    output.mkdir(parents=True, exist_ok=True)
    written: list[Path] = []
    with progress_bar("drawing", quiet) as progress:
        for count, path in enumerate(datasets):
            progress(count / len(datasets))
            dataset = read(path)
            written += save(registry.draw(path.stem, dataset), output / f"{path.stem}.png")
            table = registry.tabulate(path.stem, dataset)
            if table is not None:
                written += tables.write(table, output / path.stem)
    for path in written:
        typer.echo(str(path))
