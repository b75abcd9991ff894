"""Swept parameters as dimensions: a view of a collected dataset that is easier to slice."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

_IDENTITY = ("case_id", "kind", "case_json")


def unstacked(dataset: xr.Dataset, *names: str) -> xr.Dataset:
    """Dataset with parameters as dimensions in place of ``case``.

    Parameters
    ----------
    dataset : xarray.Dataset
        What `orthocut.io.collect.collect` makes, also after ``.sel`` or ``.isel`` along ``case``.
    names : str
        Parameters that become dimensions, in this order; default all that differ between cases.

    Returns
    -------
    xarray.Dataset
        Where no case has a combination of values, floats are NaN, integers -1, texts empty.

    Raises
    ------
    ValueError
        If a name is no parameter of all cases, or the names do not tell all cases apart.
    """
    known = [str(name) for name in dataset.coords if dataset[name].dims == ("case",) and name not in _IDENTITY]
    chosen = list(names) or [name for name in known if np.unique(dataset[name].values).size > 1]
    for name in chosen:
        if name not in known or dataset[name].isnull().any():
            raise ValueError(f"{name} is no parameter of all cases (allowed: {', '.join(known)})")
    rows = list(zip(*(dataset[name].values.tolist() for name in chosen), strict=True))
    if len(set(rows)) < dataset.sizes["case"]:
        rest = ", ".join(name for name in known if name not in chosen)
        raise ValueError(f"{', '.join(chosen) or 'nothing'} does not tell all cases apart (others: {rest})")

    flat = dataset.reset_coords(
        [name for name in dataset.coords if name not in chosen and "case" in dataset[name].dims]
    )
    if len(chosen) == 1:
        result = flat.set_index(case=chosen[0]).rename(case=chosen[0]).sortby(chosen[0])
    else:
        holes = {str(name): _hole(variable) for name, variable in flat.data_vars.items()}
        result = flat.set_index(case=chosen).unstack("case", fill_value=holes)
    for name in chosen:
        result[name].attrs = dataset[name].attrs
    return result


def _hole(variable: xr.DataArray) -> Any:
    """What stands where no case is."""
    return {"f": np.nan, "i": -1, "u": -1}.get(variable.dtype.kind, "")
