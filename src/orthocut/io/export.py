"""Export the snapshots of a run to files of other programs: ParaView and OVITO."""

from __future__ import annotations

from pathlib import Path

import xarray as xr

from orthocut.io.extended_xyz import write_xyz
from orthocut.io.paraview import write_pvd, write_vtp
from orthocut.io.particles import frames
from orthocut.params.block import ConfigError

FORMATS = {".pvd": "ParaView, all snapshots", ".vtp": "ParaView, one snapshot", ".xyz": "OVITO, all snapshots"}
"""Endings of files, and what they are for."""


def export(run: xr.Dataset, path: str | Path, snapshot: int | None = None, name: str = "run") -> list[Path]:
    """Write snapshots as particles with their fields, in SI.

    Parameters
    ----------
    run : xarray.Dataset
        One run with its snapshots.
    path : str or Path
        File to write; its ending, one of `FORMATS`, says how.
    snapshot : int, optional
        Number of the only snapshot to write, from 0; default all, for .vtp the last.
    name : str
        What messages call the run.

    Returns
    -------
    list of Path
        The files, the one to open first.

    Raises
    ------
    ConfigError
        If the ending is not known, the run failed or has no such snapshot, or vtk is needed and not installed.
    """
    path = Path(path)
    form = check_format(path)
    if "case" in run.dims:
        raise ConfigError(f"{name}: holds many runs (allowed: a file of one run)")
    if run.attrs.get("status") == "failed":
        raise ConfigError(f"{name}: has no snapshots, since the run failed: {run.attrs.get('failure', '')}")
    found = frames(run)
    if not found:
        raise ConfigError(
            f"{name}: has no snapshots (allowed: a file that `orthocut run` wrote, or KEY.snapshots.nc of a store)"
        )
    if snapshot is not None and not 0 <= snapshot < len(found):
        raise ConfigError(f"--snapshot {snapshot}: there is no such snapshot (allowed: 0 to {len(found) - 1})")
    chosen = found if snapshot is None else [found[snapshot]]
    if form == ".xyz":
        return [write_xyz(chosen, path)]
    try:
        return write_pvd(chosen, path) if form == ".pvd" else write_vtp(chosen[-1], path)
    except ImportError as error:
        raise ConfigError(
            f"{path}: needs vtk, which is not installed ({error}): pip install 'orthocut[export]', or write .xyz"
        ) from None


def check_format(path: Path) -> str:
    """Ending of a file to write, in small letters; `ConfigError` if it is not known."""
    form = path.suffix.lower()
    if form not in FORMATS:
        allowed = "; ".join(f"{ending}: {words}" for ending, words in FORMATS.items())
        raise ConfigError(f"--output {path}: unknown kind of file (allowed: {allowed})")
    return form
