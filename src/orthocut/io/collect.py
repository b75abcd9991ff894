"""Join many runs, of one kind or of several, into one dataset: what a figure draws."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable, Mapping
from importlib.metadata import version
from typing import Any

import numpy as np
import xarray as xr

from orthocut.params.block import Block
from orthocut.params.case import validate
from orthocut.variables import VARIABLES, attributes

ALWAYS = (
    "cut_depth",
    "cut_speed",
    "rake_angle",
    "friction",
    "modulus_tangent",
    "strength",
    "points_per_depth",
    "seed",
    "grooved",
)
"""Parameters that become coordinates whenever a case has them, swept or not."""

_PREFIXES = {"joint": "joint_", "packing": "packing_", "grooves": "groove_"}
_SHARED = ("versions", "source_digest", "git_commit", "references")


def parameters(case: Block) -> dict[str, Any]:
    """Every value of a case under its name in the table of variables.

    Fields of the packing, the joints and the grooves carry the name of their block, since other blocks have fields of
    the same name; ``seed`` does not. ``grooved`` is 1 or 0 for cuts of bonded discs.
    """
    values: dict[str, Any] = {}
    for name, value in case:
        if isinstance(value, Block):
            prefix = _PREFIXES.get(name, "")
            values |= {("seed" if leaf == "seed" else prefix + leaf): item for leaf, item in value}
        elif name != "grooves":
            values[name] = value
    if hasattr(case, "grooves"):
        values["grooved"] = int(case.grooves is not None)
    return values


def collect(datasets: Iterable[xr.Dataset], title: str = "", dims: Collection[str] | None = None) -> xr.Dataset:
    """Dataset of many runs, along the dimension ``case``.

    Parameters
    ----------
    datasets : iterable of xarray.Dataset
        Runs as `orthocut.io.datasets.build` makes them; a case that comes twice is taken once.
    title : str
        One line for people.
    dims : collection of str, optional
        Dimensions of runs to keep, beside single numbers; default all. Histories and snapshots that a figure does not
        draw would only make its dataset large.

    Returns
    -------
    xarray.Dataset
        Coordinates ``case_id``, ``kind`` and the parameters that were swept (always those in `ALWAYS`). Where runs
        differ in length, or lack a variable or parameter, floats are padded with NaN, integers with -1, texts with "";
        files declare -1 as their fill value. ``status`` and ``failure`` tell which cases failed, and why; these have no
        other values. ``case_json`` holds each whole case.

    Raises
    ------
    ValueError
        If runs disagree on the dimensions of a variable, or a swept parameter is not in the table of variables.
    """
    runs = list({run.attrs["case_id"]: _reduce(run, dims) for run in datasets}.values())
    lengths = _lengths(runs)
    result = xr.Dataset(_join(runs, lengths), coords=_coordinates(runs) | _labels(runs))
    result["case_json"] = ("case", np.array([run.attrs["case"] for run in runs], object), attributes("case_json"))
    times = [float(run.attrs.get("wall_time_s", np.nan)) for run in runs]
    states = [int(run.attrs.get("status") == "failed") for run in runs]
    result["status"] = ("case", np.array(states, np.int8), attributes("status"))
    reasons = [run.attrs.get("failure", "") for run in runs]
    result["failure"] = ("case", np.array(reasons, object), attributes("failure"))
    result["wall_time"] = ("case", np.array(times), attributes("wall_time"))
    result.attrs = {
        "Conventions": "CF-1.11",
        "title": title,
        "history": f"collected from {len(runs)} results by orthocut {version('orthocut')}",
        "case_ids": ", ".join(run.attrs["case_id"] for run in runs),
    }
    for name in _SHARED:
        result.attrs[name] = "; ".join(dict.fromkeys(str(run.attrs[name]) for run in runs if name in run.attrs))
    return result


def case_of(run: xr.Dataset) -> Block:
    """Case of one run, alone or taken out of a collected dataset; checked anew."""
    text = run["case_json"].item() if "case_json" in run.variables else run.attrs["case"]
    return validate(json.loads(text))


def _reduce(run: xr.Dataset, dims: Collection[str] | None) -> xr.Dataset:
    """Run without the dimensions that are not wanted."""
    return run if dims is None else run.drop_dims([dim for dim in run.dims if dim not in dims])


def _lengths(runs: list[xr.Dataset]) -> dict[str, int]:
    lengths: dict[str, int] = {}
    for run in runs:
        for dim, length in run.sizes.items():
            lengths[dim] = max(length, lengths.get(dim, 0))
    return lengths


def _fill(dtype: np.dtype) -> tuple[np.dtype, Any]:
    """Type and value of the padding."""
    if dtype.kind == "f":
        return dtype, np.nan
    if dtype.kind == "b":
        return np.dtype(np.int8), -1
    if dtype.kind in "iu":
        return np.dtype(np.int64), -1
    return np.dtype(object), ""


def _join(runs: list[xr.Dataset], lengths: Mapping[str, int]) -> dict[str, Any]:
    """Pad and stack all variables but those that label a dimension."""
    joined: dict[str, Any] = {}
    for name in dict.fromkeys(name for run in runs for name in run.variables if name not in run.dims):
        holders = {index: run[name] for index, run in enumerate(runs) if name in run.variables}
        dims = next(iter(holders.values())).dims
        for index, variable in holders.items():
            if variable.dims != dims:
                raise ValueError(f"{name} has dimensions {variable.dims} in {runs[index].attrs['case_id']}, not {dims}")
        dtype, fill = _fill(np.result_type(*(variable.dtype for variable in holders.values())))
        values = np.full((len(runs), *(lengths[dim] for dim in dims)), fill, dtype)
        for index, variable in holders.items():
            values[(index, *(slice(length) for length in variable.shape))] = variable.values
        known = attributes(name) if name in VARIABLES else dict(next(iter(holders.values())).attrs)
        padded = len(holders) < len(runs) or any(variable.shape != values.shape[1:] for variable in holders.values())
        joined[name] = (("case", *dims), values, known, {"_FillValue": fill} if padded and fill == -1 else {})
    return joined


def _labels(runs: list[xr.Dataset]) -> dict[str, Any]:
    """Labels of dimensions, such as the components of a tensor, where all runs that have them agree."""
    labels: dict[str, Any] = {}
    for name in dict.fromkeys(name for run in runs for name in run.variables if name in run.dims):
        first, *others = (run[name] for run in runs if name in run.variables)
        if all(first.equals(other) for other in others):
            labels[name] = first
    if any("component" in run.dims for run in runs):
        labels["component"] = ("component", ["xx", "xy", "yx", "yy"], attributes("component"))
    return labels


def _coordinates(runs: list[xr.Dataset]) -> dict[str, Any]:
    """Case names, kinds and swept parameters."""
    cases = [validate(json.loads(run.attrs["case"]), run.attrs["case_id"]) for run in runs]
    values = [parameters(case) for case in cases]
    coordinates: dict[str, Any] = {
        "case_id": ("case", np.array([run.attrs["case_id"] for run in runs], object), attributes("case_id")),
        "kind": ("case", np.array([case.kind for case in cases], object), attributes("kind")),
    }
    for name in dict.fromkeys(name for row in values for name in row if name != "kind"):
        column = [row[name] for row in values if name in row]
        if name not in ALWAYS and all(value == column[0] for value in column):
            continue
        if name not in VARIABLES:
            raise ValueError(f"swept parameter {name} is not in the table of variables")
        if any(isinstance(value, str) for value in column):
            array: np.ndarray = np.array([row.get(name, "") for row in values], object)
        else:
            array = np.array([row.get(name, np.nan) for row in values], float)
        coordinates[name] = ("case", array, attributes(name))
    return coordinates
