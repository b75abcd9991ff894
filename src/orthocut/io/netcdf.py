"""Read and write netCDF files whole: a file is there complete, or not at all."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from orthocut.io import encoding
from orthocut.io.files import replacing
from orthocut.variables import VARIABLES


def write(dataset: xr.Dataset, path: str | Path) -> None:
    """Write a dataset, compressed, without loss; the file appears when it is complete and on disk."""
    kept = {
        name: encoding.chunked(variable) | declared(variable)
        for name, variable in dataset.variables.items()
        if variable.ndim and np.issubdtype(variable.dtype, np.number)
    }
    with replacing(path) as temporary:
        _with_typed_flags(dataset).to_netcdf(temporary, engine="netcdf4", encoding=kept)


def _with_typed_flags(dataset: xr.Dataset) -> xr.Dataset:
    """Copy whose flag values have the type of their variable, as CF wants."""
    result = dataset.copy()
    for variable in result.variables.values():
        if "flag_values" in variable.attrs:
            variable.attrs["flag_values"] = np.asarray(variable.attrs["flag_values"], variable.dtype)
    return result


def declared(variable: xr.Variable) -> dict[str, Any]:
    """Fill value that a variable declares."""
    return {key: value for key, value in variable.encoding.items() if key == "_FillValue"}


def fill(dataset: xr.Dataset, path: Path) -> None:
    """Write one part of a result, as `orthocut.io.datasets.split` makes it, to a file that nobody reads yet.

    Histories and fields lose digits that no figure shows, and long histories samples; see `orthocut.io.encoding`.
    """
    (encoding.write_small if encoding.is_small(dataset) else encoding.write_fields)(dataset, path)


def read(path: str | Path) -> xr.Dataset:
    """Read a whole dataset into memory and close the file; symbols that it left out come from the table."""
    with xr.open_dataset(path, engine="netcdf4") as dataset:
        dataset.load()
    for name, variable in dataset.variables.items():
        if name in VARIABLES:
            variable.attrs.setdefault("symbol", VARIABLES[name].symbol)
    return dataset
