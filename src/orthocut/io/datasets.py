"""Datasets: variables with units, names and symbols; the whole case and its provenance as attributes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from orthocut.io.provenance import provenance
from orthocut.params.block import Block
from orthocut.variables import attributes

Data = Mapping[str, tuple[tuple[str, ...], Any]]


def build(case: Block, title: str, data: Data, coords: Data | None = None) -> xr.Dataset:
    """Dataset of one run.

    Parameters
    ----------
    case : Block
        The case that was run; stored whole.
    title : str
        One line for people.
    data, coords : mapping of str to (dims, values)
        Values in SI; every name must stand in the table of variables.

    Returns
    -------
    xarray.Dataset
    """
    dataset = xr.Dataset(
        {name: (dims, np.asarray(values), attributes(name)) for name, (dims, values) in data.items()},
        coords={name: (dims, np.asarray(values), attributes(name)) for name, (dims, values) in (coords or {}).items()},
    )
    dataset.attrs = {"title": title, "status": "done", **provenance(case)}
    return dataset


def failed(case: Block, reason: str, seconds: float) -> xr.Dataset:
    """Result of a case that fails by its own numbers: no values, but the whole case and why it failed.

    Parameters
    ----------
    case : Block
    reason : str
        Diagnosis, one line.
    seconds : float
        Run time until it failed [s].
    """
    facts = {"title": "Failed", "status": "failed", "failure": reason, "wall_time_s": seconds}
    return xr.Dataset(attrs=facts | provenance(case))


def split(dataset: xr.Dataset) -> tuple[xr.Dataset, xr.Dataset]:
    """Part a result: single numbers and histories, and all that belongs to snapshots; both keep the attributes."""
    fields = [name for name, variable in dataset.variables.items() if set(variable.dims) - {"sample"}]
    return dataset.drop_vars(fields), dataset[fields].drop_vars(set(dataset.coords) - set(fields), errors="ignore")
