"""``orthocut calibrate``: joint parameters for a material."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orthocut.cli.common import FAILED, Json, fail, guarded, print_json
from orthocut.params.block import ConfigError

if TYPE_CHECKING:
    from orthocut.calibration.trial import Trial

EXAMPLES = """Examples:

orthocut calibrate --output results/calibration

orthocut calibrate results/calibration/joint.yaml --set packing.radius_min="7.5 um" --output results/finer

orthocut calibrate --set joint.fraction_slit=0.1 --set joint.stiffness_ratio=4 --output slit --workers 2
"""


@guarded
def calibrate(
    file: Annotated[
        Path | None, typer.Argument(metavar="[FILE]", help="A YAML file with what differs from the defaults.")
    ] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="FIELD=VALUE", help="Override a field by its dotted name. Repeatable."),
    ] = None,
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder of the outcome; made if need be.")] = Path(
        "results/calibration"
    ),
    store: Annotated[Path, typer.Option("--store", help="Folder of the results of all tests.")] = Path("results/store"),
    workers: Annotated[int, typer.Option("--workers", "-w", min=1, max=4096, help="Processes, a core each.")] = 1,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No progress.")] = False,
    as_json: Json = False,
) -> None:
    """Fit the joints of bonded discs to Young's modulus, Poisson's ratio, tensile and compressive strength.

    Every test is a case in the store: a calibration that is interrupted goes on where it was, and one that is repeated
    takes seconds.
    """
    from orthocut.params.calibration import load_calibration

    calibration = load_calibration(file, _values(settings or []))

    from orthocut.calibration.fit import deviations, fit
    from orthocut.calibration.laboratory import laboratory
    from orthocut.calibration.outcome import properties, save
    from orthocut.calibration.trial import FITTED, REACHED, goal_of
    from orthocut.io.files import held
    from orthocut.io.store import IN_USE, Store

    output.mkdir(parents=True, exist_ok=True)
    goal = goal_of(calibration)
    count = 0

    def report(trial: Trial) -> None:
        nonlocal count
        count += 1
        if not quiet:
            off = max(abs(deviations(trial, goal)))
            words = " ".join(f"{value:.4g}" for value in [*trial.parameters, *trial.properties.mean(axis=0)])
            typer.echo(f"{trial.purpose} {count}: {words}: {100 * off:.1f} % off", err=True)

    if not quiet:
        typer.echo(f"evaluation: {' '.join((*FITTED, *REACHED))}", err=True)
    with (
        held(store / IN_USE, shared=True),
        laboratory(Store(store), output / "progress.jsonl", workers) as simulate,
    ):
        found = fit(calibration, simulate, report)
    paths = save(calibration, found, output)
    best = found.trials[found.best]
    if as_json:
        print_json(
            {
                "converged": found.converged,
                "evaluations": len(found.trials),
                "parameters": dict(zip(FITTED, best.parameters.tolist(), strict=True)),
                "errors": dict(zip(FITTED, found.error.tolist(), strict=True)),
                "properties": dict(zip(REACHED, best.properties.mean(axis=0).tolist(), strict=True)),
                "goals": dict(zip(REACHED, goal.tolist(), strict=True)),
                "output": str(output),
            }
        )
    else:
        typer.echo(properties(calibration, found).markdown(), nl=False)
        for path in paths:
            typer.echo(str(path))
    if not found.converged:
        off, worst = max(zip(abs(deviations(best, goal)).tolist(), REACHED, strict=True))
        fail(
            f"{worst} is {100 * off:.2g} % off its goal (allowed: tolerance = {100 * calibration.tolerance:.2g} %); "
            "more evaluations, or other values",
            FAILED,
        )


def _values(settings: list[str]) -> dict[str, object]:
    """Fields and values of ``--set``."""
    from orthocut.params.text import parse_yaml

    values: dict[str, object] = {}
    for text in settings:
        name, equals, value = text.partition("=")
        name = name.strip()
        if not equals or not name or name in values:
            raise ConfigError(f"--set {text!r}: must read field=value, each field once")
        values[name] = parse_yaml(value, f"--set {name}")
    return values
