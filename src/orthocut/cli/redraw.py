"""``orthocut redraw``: figures and tables from collected datasets."""

from __future__ import annotations

from collections.abc import Collection
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
        Path,
        typer.Argument(
            metavar="FOLDER",
            help="Folder of datasets that carry the names of figures, whole or behind the folder's name.",
        ),
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

    found = {path: _figure(path, registry.FIGURES) for path in sorted(folder.glob("*.nc"))}
    datasets = {path: name for path, name in found.items() if name}
    if not datasets:
        raise ConfigError(f"{folder}: holds no dataset with the name of a figure ({', '.join(registry.FIGURES)})")
    output.mkdir(parents=True, exist_ok=True)
    written: list[Path] = []
    with progress_bar("drawing", quiet) as progress:
        for count, (path, name) in enumerate(datasets.items()):
            progress(count / len(datasets))
            dataset = read(path)
            written += save(registry.draw(name, dataset), output / f"{path.stem}.png")
            table = registry.tabulate(name, dataset)
            if table is not None:
                written += tables.write(table, output / path.stem)
    for path in written:
        typer.echo(str(path))


def _figure(path: Path, known: Collection[str]) -> str:
    """Figure that a dataset belongs to: its name, or the name of its folder and its own; empty if there is none."""
    names = (path.stem, f"{path.resolve().parent.name}_{path.stem}")
    return next((name for name in names if name in known), "")
