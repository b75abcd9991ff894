"""The finest run of each cut, and what its results tend to at zero particle size."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import xarray as xr

from orthocut.figures.extrapolation import extrapolate
from orthocut.io.collect import case_of, parameters

FIELD = "points_per_depth"
DIFFERS = "regime_differs"
"""Variable of `finest`: 1 where a coarser run is of the other regime, 0 where none is, NaN without a coarser run."""


def finest(dataset: xr.Dataset | None, *names: str) -> xr.Dataset | None:
    """Runs at the finest resolution among those that agree in all else, with their limits at zero particle size.

    A failed run stays if it is the finest: no coarser run stands in for it.

    Parameters
    ----------
    dataset : xarray.Dataset or None
        Collected runs, of any kinds; a single run is its own finest.
    names : str
        Variables whose limits are wanted.

    Returns
    -------
    xarray.Dataset or None
        The finest runs in their order, with `DIFFERS`, and for each name two variables in its unit: ``<name>_limit``,
        from a straight line over particle size through all runs that agree, and ``<name>_limit_error``, its standard
        error. Both are NaN without a coarser run, and where the runs are not all of one regime.
    """
    if dataset is None or "case" not in dataset.dims:
        return dataset
    points, groups = _families(dataset)
    chosen = sorted(max(members, key=points.__getitem__) for members in groups)
    family = {max(members, key=points.__getitem__): members for members in groups}
    result = dataset.isel(case=chosen)
    differs = [_differs(dataset, family[index], index) for index in chosen]
    result[DIFFERS] = ("case", np.array(differs, float))
    for name in names:
        known = [
            (math.nan, math.nan) if differ else _limit(dataset, family[index], points, name)
            for index, differ in zip(chosen, differs, strict=True)
        ]
        limits, errors = np.array(known, float).reshape(-1, 2).T
        result[f"{name}_limit"], result[f"{name}_limit_error"] = ("case", limits), ("case", errors)
    return result


def error_name(name: str) -> str:
    """Name of the standard error of a mean."""
    return name.replace("_mean", "_error")


def hangs_on_resolution(run: xr.Dataset) -> bool:
    """Whether a coarser run of the same cut is of the other regime."""
    return DIFFERS in run and float(run[DIFFERS]) == 1.0


def has_partners(dataset: xr.Dataset) -> bool:
    """Whether any run of what `finest` gives has a coarser partner."""
    return DIFFERS in dataset and bool(np.isfinite(dataset[DIFFERS].values).any())


def _families(dataset: xr.Dataset) -> tuple[list[int], list[list[int]]]:
    """Points through the depth of cut of each run, and the runs that differ in nothing else."""
    points: list[int] = []
    groups: dict[tuple, list[int]] = {}
    for index in range(dataset.sizes["case"]):
        fields = parameters(case_of(dataset.isel(case=index)))
        points.append(fields.pop(FIELD, 0))
        groups.setdefault(tuple(sorted(fields.items())), []).append(index)
    return points, list(groups.values())


def _differs(dataset: xr.Dataset, members: Sequence[int], index: int) -> float:
    """Value of `DIFFERS` of one run."""
    if "touching" not in dataset:
        return math.nan
    states = dataset["touching"].values
    others = [states[other] >= 0.5 for other in members if other != index and states[other] >= 0]
    if not others or not states[index] >= 0:
        return math.nan
    return float(any(other != (states[index] >= 0.5) for other in others))


def _limit(dataset: xr.Dataset, members: Sequence[int], points: Sequence[int], name: str) -> tuple[float, float]:
    """Value of a variable at zero particle size and its standard error; NaN where fewer than two runs tell it."""
    values = dataset[name].values if name in dataset else np.full(dataset.sizes["case"], math.nan)
    known = [index for index in members if np.isfinite(values[index])]
    if len(known) < 2:
        return math.nan, math.nan
    errors = dataset[error_name(name)].values if error_name(name) in dataset else np.full(len(values), math.nan)
    fit = extrapolate([1.0 / points[index] for index in known], values[known], errors[known])
    return fit.limit, fit.error
