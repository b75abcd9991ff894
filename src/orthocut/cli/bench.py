"""``orthocut bench``: the cost of a whole step at the papers' resolution, on one thread."""

from __future__ import annotations

import importlib
from typing import Annotated

import typer

from orthocut.cli.common import Json, guarded, print_json
from orthocut.io import machine
from orthocut.params.block import ConfigError

EXAMPLES = """Example:

orthocut bench mpm --json
"""
METHODS = ("mpm", "dem")


@guarded
def bench(
    method: Annotated[str, typer.Argument(metavar="mpm|dem", help="Method to measure.")], as_json: Json = False
) -> None:
    """Measure the cost of a step: ns_per_point_step (mpm) or ns_per_bond_step (dem).

    What it is over the cost model is kept for this machine, and predicted run times follow it.
    """
    if method not in METHODS:
        raise ConfigError(f"method = {method!r}: must be one of {', '.join(METHODS)}")
    module = importlib.import_module(f"orthocut.experiments.speed_{method}")
    numbers = getattr(module, f"bench_{method}")()
    machine.remember(method, numbers["over_cost_model"])
    if as_json:
        print_json(numbers)
        return
    for name, value in numbers.items():
        typer.echo(f"{name:<24} {value:.4g}" if isinstance(value, float) else f"{name:<24} {value}")
