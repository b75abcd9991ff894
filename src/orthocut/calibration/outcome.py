"""A finished calibration as a dataset, as tables and as a block of parameters for studies."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import xarray as xr
import yaml

from orthocut.calibration.fit import Fit, deviations
from orthocut.calibration.trial import FITTED, REACHED, goal_of, joint_of, start_of
from orthocut.figures.tables import Table
from orthocut.figures.tables import write as write_table
from orthocut.io.datasets import build
from orthocut.io.files import write_text
from orthocut.io.netcdf import write
from orthocut.params.calibration import DemCalibration
from orthocut.params.dem import FlatJoint
from orthocut.params.identity import digest_numbers
from orthocut.params.schema import shown
from orthocut.variables import VARIABLES

PURPOSES = ("search", "slope")


def save(calibration: DemCalibration, found: Fit, folder: Path) -> list[Path]:
    """Write ``calibration.nc``, ``joint.yaml``, and the tables ``parameters``, ``properties`` and ``evaluations``."""
    paths = [folder / "calibration.nc", folder / "joint.yaml"]
    write(dataset(calibration, found), paths[0])
    write_text(joint_yaml(calibration, found), paths[1])
    tables = {"parameters": parameters, "properties": properties, "evaluations": evaluations}
    return paths + [
        path for name, make in tables.items() for path in write_table(make(calibration, found), folder / name)
    ]


def dataset(calibration: DemCalibration, found: Fit) -> xr.Dataset:
    """All evaluations and the uncertainty of the fit."""
    tried = np.array([trial.parameters for trial in found.trials])
    measured = np.array([trial.properties for trial in found.trials])
    data = {f"joint_{name}": (("evaluation",), tried[:, k]) for k, name in enumerate(FITTED)}
    data |= {name: (("evaluation", "packing"), measured[:, :, k]) for k, name in enumerate(REACHED)}
    data |= {
        "trial_purpose": (("evaluation",), np.array([PURPOSES.index(trial.purpose) for trial in found.trials], "i1")),
        "fit_evaluation": ((), found.best),
        "fit_converged": ((), int(found.converged)),
        "fit_slope": (("property", "parameter"), found.slopes),
        "fit_spread": (("parameter",), found.spread),
        "fit_error": (("parameter",), found.error),
    }
    result = build(calibration, "Calibration of flat joints", data)
    result.attrs["source_digest"] = f"{digest_numbers('dem_tension')} {digest_numbers('dem_compression')}"
    return result


def joint_yaml(calibration: DemCalibration, found: Fit) -> str:
    """Fitted joint as studies take it: what differs from the defaults."""
    joint, default = (
        shown(block) for block in (joint_of(calibration, found.trials[found.best].parameters), FlatJoint())
    )
    changed = {name: value for name, value in joint.items() if value != default[name]}
    return yaml.safe_dump({"joint": changed}, sort_keys=False, allow_unicode=True)


def parameters(calibration: DemCalibration, found: Fit) -> Table:
    """Fitted parameters and their uncertainty."""
    best, start = found.trials[found.best], start_of(calibration)
    rows = [
        [
            *_named(f"joint_{name}"),
            *(float(VARIABLES[f"joint_{name}"].scale * value) for value in (start[k], best.parameters[k])),
            float(100 * found.error[k]),
            float(100 * found.spread[k]),
        ]
        for k, name in enumerate(FITTED)
    ]
    header = ["parameter", "unit", "start", "fitted", "standard error [%]", "spread over packings [%]"]
    return Table("Fitted parameters of the joints", header, rows, [_verdict(calibration, found)])


def properties(calibration: DemCalibration, found: Fit) -> Table:
    """Properties of the fitted packings beside those to reach, and what moves them."""
    best, goal = found.trials[found.best], goal_of(calibration)
    mean = best.properties.mean(axis=0)
    spread = best.properties.std(axis=0, ddof=1) / mean
    rows = [
        [
            *_named(name),
            *(float(VARIABLES[name].scale * value) for value in (goal[k], mean[k])),
            float(100 * (mean[k] / goal[k] - 1)),
            float(100 * spread[k] / calibration.replicates**0.5),
            *(float(slope) for slope in found.slopes[k]),
        ]
        for k, name in enumerate(REACHED)
    ]
    header = ["property", "unit", "goal", "reached", "deviation [%]", "standard error [%]"]
    header += [f"% per % of {VARIABLES[f'joint_{name}'].long_name}" for name in FITTED]
    return Table("Properties of the fitted packings", header, rows, [_verdict(calibration, found)])


def evaluations(calibration: DemCalibration, found: Fit) -> Table:
    """Every evaluation: parameters, means over the packings and the largest deviation."""
    goal = goal_of(calibration)
    names = [f"joint_{name}" for name in FITTED] + list(REACHED)
    scales = np.array([VARIABLES[name].scale for name in names])
    rows = []
    for index, trial in enumerate(found.trials):
        numbers = scales * np.concatenate([trial.parameters, trial.properties.mean(axis=0)])
        off = 100 * float(np.max(np.abs(np.expm1(deviations(trial, goal)))))
        rows.append([index, trial.purpose, *(float(number) for number in numbers), off])
    header = ["evaluation", "purpose", *(" ".join(_bracketed(name)) for name in names), "largest deviation [%]"]
    return Table("Evaluations of the calibration", header, rows)


def _verdict(calibration: DemCalibration, found: Fit) -> str:
    searched = sum(trial.purpose == "search" for trial in found.trials)
    state = "within" if found.converged else "not within"
    return (
        f"{state.capitalize()} the tolerance of {calibration.tolerance:.3g}; evaluations: {searched}, with "
        f"{calibration.replicates} packings each."
    )


def _named(name: str) -> tuple[str, str]:
    row = VARIABLES[name]
    return row.long_name, row.display or row.unit


def _bracketed(name: str) -> tuple[str, str]:
    words, unit = _named(name)
    return words, f"[{unit}]"
