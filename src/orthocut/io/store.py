"""The store of results: one sealed netCDF file a case, under a name that says which case and which sources made it.

Beside ``<key>.nc`` with histories and results may stand ``<key>.snapshots.nc`` with fields, and, while the case runs,
``<key>.checkpoint.npz``. Files that turn out broken, and failed results that are to be tried again, move to ``aside/``.
Several processes on several machines may use a store at once: files appear whole, and whoever writes a file that is
there already writes the same numbers.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import xarray as xr

from orthocut.io import netcdf
from orthocut.io.datasets import split
from orthocut.io.files import replacing
from orthocut.io.seal import Broken, seal, unseal
from orthocut.params.block import Block
from orthocut.params.identity import result_key

SUFFIX, SNAPSHOTS, CHECKPOINT = ".nc", ".snapshots.nc", ".checkpoint.npz"
ASIDE = "aside"
IN_USE = "in-use"
"""File that workflows lock while they use a store."""


class Entry(NamedTuple):
    """What the seal of a result tells."""

    key: str
    status: str
    """``done`` or ``failed``."""
    reason: str
    """Why the case failed; empty if it did not."""
    seconds: float
    """Run time on one core [s]."""


class Store:
    """Results in a folder.

    Parameters
    ----------
    root : Path
        The folder; made when the first result is written.
    """

    def __init__(self, root: str | Path) -> None:
        self.root = Path(root)

    def path(self, key: str, suffix: str = SUFFIX) -> Path:
        """File of a result."""
        return self.root / f"{key}{suffix}"

    def names(self) -> list[str]:
        """Names of all results, sorted; none of them is checked."""
        if not self.root.is_dir():
            return []
        names = (entry.name for entry in os.scandir(self.root))
        return sorted(
            name.removesuffix(SUFFIX)
            for name in names
            if name.endswith(SUFFIX) and not name.endswith(SNAPSHOTS) and not name.startswith(".")
        )

    def entry(self, key: str) -> Entry | None:
        """Check a result; None if there is none, or if it was broken and has been set aside."""
        facts = self._check(self.path(key))
        return None if facts is None else Entry(key, *(facts[name] for name in Entry._fields[1:]))

    def snapshots(self, key: str) -> int:
        """Check the snapshots of a result and return how many there are, 0 if none."""
        facts = self._check(self.path(key, SNAPSHOTS))
        return 0 if facts is None else facts["snapshots"]

    def holds(self, key: str, snapshots: int = 0) -> bool:
        """Whether nothing needs to be computed: the case is done, with enough snapshots, or known to fail."""
        entry = self.entry(key)
        return entry is not None and (entry.status == "failed" or self.snapshots(key) >= snapshots)

    def put(self, case: Block, dataset: xr.Dataset, snapshots: int) -> Entry:
        """Write the result of a case.

        Parameters
        ----------
        case : Block
        dataset : xarray.Dataset
            As `orthocut.run.run_case` or `orthocut.io.datasets.failed` returns it.
        snapshots : int
            Number of snapshots that were asked for; 0 writes no file for them.

        Raises
        ------
        OSError
            If the disk is full or the store cannot be written to; then the file is not there.
        """
        key = result_key(case)
        small, fields = split(dataset)
        if snapshots and dataset.attrs["status"] == "done":
            self._write(fields, self.path(key, SNAPSHOTS), {"snapshots": snapshots})
        facts = {
            "status": dataset.attrs["status"],
            "reason": dataset.attrs.get("failure", ""),
            "seconds": float(dataset.attrs["wall_time_s"]),
        }
        self._write(small, self.path(key), facts)
        return Entry(key=key, **facts)

    def read(self, key: str, snapshots: bool = False) -> xr.Dataset:
        """Read a result that is there, with its snapshots if there are any and they are wanted."""
        result = netcdf.read(self.path(key))
        if not snapshots or not self.path(key, SNAPSHOTS).exists():
            return result
        fields = netcdf.read(self.path(key, SNAPSHOTS))
        return result.assign(fields.variables)

    def retry(self, key: str) -> bool:
        """Set a failed result aside, so that the case is simulated again; return whether there was one."""
        entry = self.entry(key)
        if entry is None or entry.status != "failed":
            return False
        self._set_aside(self.path(key), "failed")
        return True

    def attempts(self) -> dict[str, int]:
        """Key to the number of failed results that were set aside to be tried again."""
        counts: dict[str, int] = {}
        for path in (self.root / ASIDE).glob("*.failed-*"):
            key = path.name.partition(SUFFIX)[0]
            counts[key] = counts.get(key, 0) + 1
        return counts

    def remains(self) -> Iterator[Path]:
        """Files that killed processes left, checkpoints, snapshots without a result and what was set aside."""
        yield from sorted(self.root.glob("**/.*.part"))
        yield from sorted(self.root.glob(f"[!.]*{CHECKPOINT}*"))
        for folder in sorted(self.root.glob(".import-*")):
            yield from (*sorted(folder.glob("[!.]*")), folder)
        snapshots = sorted(self.root.glob(f"[!.]*{SNAPSHOTS}"))
        yield from (path for path in snapshots if not self.path(path.name.removesuffix(SNAPSHOTS)).exists())
        yield from sorted((self.root / ASIDE).glob("*"))

    def _write(self, dataset: xr.Dataset, path: Path, facts: dict[str, Any]) -> None:
        with replacing(path) as temporary:
            netcdf.fill(dataset, temporary)
            seal(temporary, facts)
            unseal(temporary)

    def _check(self, path: Path) -> dict[str, Any] | None:
        """What the seal of a file tells; None if there is no file or a broken one, which is named and set aside."""
        try:
            return unseal(path)
        except FileNotFoundError:
            return None
        except Broken as why:
            try:
                moved = f"moved to {self._set_aside(path, 'broken')}"
            except FileNotFoundError:  # another process was faster
                return None
            except OSError as error:
                moved = f"cannot be moved away: {error.strerror}"
            warnings.warn(f"{path}: {why}; {moved}; the case will be simulated again", stacklevel=3)
            return None

    def _set_aside(self, path: Path, why: str) -> Path:
        folder = self.root / ASIDE
        folder.mkdir(exist_ok=True)
        count = 1 + len(list(folder.glob(f"{path.name}.{why}-*")))
        target = folder / f"{path.name}.{why}-{count}"
        os.replace(path, target)
        return target
