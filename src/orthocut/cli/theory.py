"""``orthocut theory``: closed-form models of cutting."""

from __future__ import annotations

import math
from typing import Annotated, Any

import typer

from orthocut.cli.common import FAILED, Json, fail, guarded, parse_settings, print_json
from orthocut.params.block import ConfigError

app = typer.Typer(
    help="Closed-form models of a ductile cut (Nairn 2015, eqs 11-22).",
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)

_TOUCHING = """Example:

orthocut theory touching --rake-angle "30 deg" --cut-depth "0.9 mm" --json
"""
_BENDING = """Example:

orthocut theory bending --rake-angle "30 deg" --cut-depth "0.9 mm" --modulus-tangent "100 MPa" --json
"""

RakeAngle = Annotated[str, typer.Option(help="Rake angle.", metavar="ANGLE")]
CutDepth = Annotated[str, typer.Option(help="Depth of cut.", metavar="LENGTH")]
Friction = Annotated[float, typer.Option(help="Coulomb coefficient of the tool.")]
ForceRubbing = Annotated[str, typer.Option(help="Normal force of rubbing for unit width.", metavar="FORCE")]
Settings = Annotated[
    list[str] | None,
    typer.Option(
        "--set", metavar="FIELD=VALUE", help="Any other field of an MPM case, such as stress_yield or toughness."
    ),
]
_UNITS = {
    "force_cutting": "N/m",
    "force_thrust": "N/m",
    "force_over_toughness": "1",
    "thrust_over_toughness": "1",
    "depth_dimensionless": "1",
    "angle_shear": "rad",
    "curvature_ratio": "1",
}
_WORDS = {
    "force_over_toughness": "cutting force over toughness",
    "thrust_over_toughness": "thrust force over toughness",
    "depth_dimensionless": "dimensionless depth of cut",
    "angle_shear": "angle of the shear plane",
    "curvature_ratio": "curvature over curvature at first yield",
}


@app.command("touching", epilog=_TOUCHING)
@guarded
def touching(
    rake_angle: RakeAngle = "30 deg",
    cut_depth: CutDepth = "0.9 mm",
    friction: Friction = 0.0,
    force_rubbing: ForceRubbing = "0 N/m",
    settings: Settings = None,
    as_json: Json = False,
) -> None:
    """Tool at the crack tip: the chip yields along one shear plane, without hardening."""
    values = {"tool.rake_angle": rake_angle, "cut_depth": cut_depth, "tool.friction": friction}
    case, rubbing = _inputs(values, force_rubbing, settings)

    from orthocut.theory.touching import solve

    _print("touching", solve(case.material, case.interface, case.tool, case.cut_depth, rubbing), as_json)


@app.command("bending", epilog=_BENDING)
@guarded
def bending(
    rake_angle: RakeAngle = "30 deg",
    cut_depth: CutDepth = "0.9 mm",
    friction: Friction = 0.0,
    force_rubbing: ForceRubbing = "0 N/m",
    modulus_tangent: Annotated[
        str, typer.Option(help="Slope of the stress-strain curve after yielding.", metavar="STRESS")
    ] = "0 MPa",
    form: Annotated[
        str,
        typer.Option(
            help="consistent: rubbing does not load the chip; paper: as printed. Same without rubbing.",
            metavar="consistent|paper",
        ),
    ] = "consistent",
    settings: Settings = None,
    as_json: Json = False,
) -> None:
    """Gap between the tool and the crack tip: the chip bends off."""
    if form not in ("consistent", "paper"):
        raise ConfigError(f"--form = {form!r}: must be one of consistent, paper")
    values = {
        "tool.rake_angle": rake_angle,
        "cut_depth": cut_depth,
        "tool.friction": friction,
        "material.modulus_tangent": modulus_tangent,
    }
    case, rubbing = _inputs(values, force_rubbing, settings)

    from orthocut.theory.bending import solve

    solution = solve(case.material, case.interface, case.tool, case.cut_depth, rubbing, form=form)
    _print("bending", solution, as_json, form=form)


def _inputs(values: dict[str, Any], force_rubbing: str, settings: list[str] | None) -> tuple[Any, float]:
    """Case that holds the inputs, and the rubbing force [N/m]; everything is checked as in a case."""
    from pydantic_core import PydanticCustomError

    from orthocut.params.case import override, validate
    from orthocut.params.quantity import Quantity

    extra = parse_settings(settings or [], "mpm_cutting")
    for name in extra.keys() & values.keys():
        raise ConfigError(f"--set {name}: has an option of its own, --{name.rsplit('.', 1)[-1].replace('_', '-')}")
    try:
        rubbing = Quantity("N/m", "0 N/m", "1 MN/m").validate(force_rubbing)
    except PydanticCustomError as error:
        raise ConfigError(f"theory: --force-rubbing = {force_rubbing!r}: {error.message()}") from None
    data = override({"kind": "mpm_cutting"}, {**values, **extra}, "theory")
    return validate(data, "theory"), rubbing


def _print(model: str, solution: Any, as_json: bool, **more: str) -> None:
    numbers = {name: getattr(solution, name) for name in _UNITS if hasattr(solution, name)}
    if as_json:
        units = {name: _UNITS[name] for name in numbers}
        print_json({"model": model, **more, **numbers, "reason": solution.reason, "units": units})
    elif not solution.reason:
        from orthocut.cli.report import print_rows, shown

        rows = []
        for name, value in numbers.items():
            if name == "angle_shear":
                rows.append((_WORDS[name], f"{math.degrees(value):.6g}", "deg"))
            elif name in _WORDS:
                rows.append((_WORDS[name], f"{value:.6g}", ""))
            else:
                rows.append(shown(name, value, _UNITS[name]))
        print_rows(f"{model} model", rows)
    if solution.reason:
        fail(f"the {model} model has no solution: {solution.reason}", FAILED)
