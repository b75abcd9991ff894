"""How results are stored: small files without waste, fields that can be read piece by piece.

Histories go into classic netCDF as 16-bit integers with a scale and an offset each, because HDF5 spends 2 to 3 kB on
every variable, compressed or not, more than its numbers need. Single numbers stay as they are. Fields go into
compressed HDF5, one chunk a snapshot.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

STEPS = 65_000
"""Steps into which the range of a history is divided: it is stored to within 1 / (2 STEPS) of its range."""
SMALL_BYTES = 19_700
"""Largest small file; with its seal it stays below 20 kB."""
ROOMS = (12_000, 9_000, 6_000, 3_000)
"""Bytes for the histories of a small file, tried in turn until it is small enough; samples are joined to fit."""
DIGITS = 4
"""Significant digits of fields other than positions, which keep all that single precision holds."""
FILL = np.int16(-32768)

_MEANS = ("force_", "reaction_", "stress_")
"""First words of histories that are means over the interval before a sample; the others are values at its end."""
_ROUNDED = ("point_stress", "point_strain_plastic", "point_deformation", "bond_intact", "crack_normal")


def is_small(dataset: xr.Dataset) -> bool:
    """Whether a dataset holds nothing but single numbers and histories."""
    return set(dataset.dims) <= {"sample"}


def write_small(dataset: xr.Dataset, path: Path) -> None:
    """Write single numbers and histories; every double that is not a history is kept exactly."""
    for room in ROOMS:
        _write_classic(thin(dataset, room), path)
        if path.stat().st_size <= SMALL_BYTES:
            return


def _write_classic(stored: xr.Dataset, path: Path) -> None:
    for name, variable in stored.variables.items():
        known = {key: value for key, value in variable.attrs.items() if key != "symbol"}
        values, packing = pack(variable.values) if variable.ndim else (variable.values, {})
        stored = stored.assign({name: (variable.dims, values, known | packing)})
    unfilled = {name: {"_FillValue": None} for name in stored.variables if "_FillValue" not in stored[name].attrs}
    stored.to_netcdf(path, engine="netcdf4", format="NETCDF3_CLASSIC", encoding=unfilled)


def write_fields(dataset: xr.Dataset, path: Path) -> None:
    """Write snapshots: single precision, compressed, one chunk a snapshot."""
    encoding: dict[str, dict[str, Any]] = {}
    for name, variable in dataset.variables.items():
        if not variable.ndim or not np.issubdtype(variable.dtype, np.number):
            continue
        entry = chunked(variable)
        if variable.dtype == np.float64 and variable.dims != ("snapshot",):
            entry |= {"dtype": "float32"}
            if name in _ROUNDED:
                entry |= {"significant_digits": DIGITS, "quantize_mode": "GranularBitRound"}
        elif np.issubdtype(variable.dtype, np.integer) and variable.size:
            entry |= {"dtype": smallest(variable.values)}
        encoding[name] = entry
    dataset.to_netcdf(path, engine="netcdf4", encoding=encoding)


def chunked(variable: xr.Variable) -> dict[str, Any]:
    """Compression, and chunks of one case and one snapshot."""
    sizes = tuple(
        1 if dim in ("case", "snapshot") and variable.ndim > 1 else max(size, 1)
        for dim, size in zip(variable.dims, variable.shape, strict=True)
    )
    return {"zlib": True, "complevel": 4, "shuffle": True, "chunksizes": sizes} if variable.size else {}


def smallest(values: np.ndarray) -> str:
    """Name of the shortest signed integer type that holds all values."""
    return next(
        name
        for name in ("int8", "int16", "int32", "int64")
        if np.iinfo(name).min <= values.min() and values.max() <= np.iinfo(name).max
    )


def thin(dataset: xr.Dataset, room: int) -> xr.Dataset:
    """Join neighbouring samples until the histories fit into some bytes: means of means, the last of other values.

    Returns
    -------
    xarray.Dataset
        With the same results as if the run had had the fewer samples; a copy.
    """
    count = sum("sample" in variable.dims for variable in dataset.variables.values())
    size = dataset.sizes.get("sample", 0)
    factor = -(-2 * size * count // room)
    if factor < 2:
        return dataset.copy()
    groups = dataset.isel(sample=slice(size % factor, None)).coarsen(sample=factor)
    means, ends = groups.mean(), dataset.isel(sample=slice(size % factor + factor - 1, None, factor))
    kept = {name: means[name] for name in dataset.data_vars if name.startswith(_MEANS) and dataset[name].ndim}
    return ends.assign({name: (("sample",), mean.values, dataset[name].attrs) for name, mean in kept.items()})


def pack(values: np.ndarray) -> tuple[np.ndarray, dict[str, Any]]:
    """History as 16-bit integers, and the attributes by which readers restore it.

    Parameters
    ----------
    values : array, shape (n_samples,)
        Counts are kept exactly, and so are values that are all the same, and NaN; with infinite values nothing is done.
    """
    good = ~np.isnan(values)
    known = values[good].astype(float)
    if not np.isfinite(known).all():
        return values, {}
    low, high = (known.min(), known.max()) if known.size else (0.0, 0.0)
    whole = high - low <= STEPS and np.array_equal(known, np.round(known))
    scale = 1.0 if whole or high == low else (high - low) / STEPS
    offset = low + 0.5 * STEPS * scale if high > low else low
    packed = np.full(values.shape, FILL)
    packed[good] = np.round((known - offset) / scale)
    attributes = {"scale_factor": float(scale), "add_offset": float(offset)}
    return packed, attributes if good.all() else attributes | {"_FillValue": FILL}
