"""Read and write netCDF files whole: a file is there complete, or not at all."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import xarray as xr


def write(dataset: xr.Dataset, path: str | Path) -> None:
    """Write a dataset under a temporary name in the same folder, flush it to disk, then rename it."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{os.getpid()}.part")
    encoding = {
        name: {"zlib": True, "complevel": 4}
        for name, variable in dataset.variables.items()
        if variable.ndim and np.issubdtype(variable.dtype, np.number)
    }
    try:
        dataset.to_netcdf(temporary, engine="netcdf4", encoding=encoding)
        with open(temporary, "rb+") as file:
            os.fsync(file.fileno())
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def read(path: str | Path) -> xr.Dataset:
    """Read a whole dataset into memory and close the file."""
    with xr.open_dataset(path, engine="netcdf4") as dataset:
        return dataset.load()
