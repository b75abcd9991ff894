"""Read and write netCDF files whole: a file is there complete, or not at all."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import xarray as xr

from orthocut.io.files import replacing


def write(dataset: xr.Dataset, path: str | Path) -> None:
    """Write a dataset, compressed; the file appears when it is complete and on disk."""
    with replacing(path) as temporary:
        fill(dataset, temporary)


def fill(dataset: xr.Dataset, path: Path) -> None:
    """Write a dataset to a file that nobody reads yet."""
    encoding = {
        name: {"zlib": True, "complevel": 4}
        for name, variable in dataset.variables.items()
        if variable.ndim and np.issubdtype(variable.dtype, np.number)
    }
    dataset.to_netcdf(path, engine="netcdf4", encoding=encoding)


def read(path: str | Path) -> xr.Dataset:
    """Read a whole dataset into memory and close the file."""
    with xr.open_dataset(path, engine="netcdf4") as dataset:
        return dataset.load()
