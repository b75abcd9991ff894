"""The command line: ``orthocut VERB``. Results go to stdout, everything else to stderr."""

from __future__ import annotations

from typing import Annotated

import typer

from orthocut.cli import bench, calibrate, export, redraw, run, show, store, study, theory

app = typer.Typer(
    name="orthocut",
    help="Simulate orthogonal cutting with bonded discs (DEM) and material points (MPM).",
    epilog="Exit codes: 0 done, 1 the simulation or the model failed, 2 bad input, 130 interrupted.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command("run", epilog=run.EXAMPLES)(run.run)
app.command("show", epilog=show.EXAMPLES)(show.show)
app.command("export", epilog=export.EXAMPLES)(export.export)
app.command("redraw", epilog=redraw.EXAMPLES)(redraw.redraw)
app.add_typer(study.app, name="study")
app.add_typer(store.app, name="store")
app.add_typer(theory.app, name="theory")
app.command("calibrate", epilog=calibrate.EXAMPLES)(calibrate.calibrate)
app.command("bench", epilog=bench.EXAMPLES)(bench.bench)


def _version(wanted: bool) -> None:
    if wanted:
        from orthocut import __version__

        typer.echo(f"orthocut {__version__}")
        raise typer.Exit


@app.callback()
def main(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version and stop.", callback=_version, is_eager=True)
    ] = False,
) -> None:
    """Simulate orthogonal cutting with bonded discs (DEM) and material points (MPM)."""
