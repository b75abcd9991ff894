"""Packings kept on disk beside the results: cases with equal packings make it once.

A file holds positions and radii as they were computed, bit for bit, and a seal with the other numbers. Its name is a
hash of the parameters of the packing and of the sources that make packings: it is never out of date. Files appear
whole; processes that make the same packing at once write the same bits.
"""

from __future__ import annotations

import hashlib
import warnings
from pathlib import Path

import numpy as np

from orthocut.dem.packing import PackedDiscs, pack
from orthocut.io.checkpoint import Checkpoint
from orthocut.io.files import replacing
from orthocut.io.seal import Broken, seal, unseal
from orthocut.params.dem import Packing
from orthocut.params.identity import canonical, digest_numbers

FOLDER = "packings"
_ARRAYS = 3  # x, y, radius: the first fields of PackedDiscs


def packed_discs(packing: Packing, checkpoint: Checkpoint | None) -> PackedDiscs:
    """Take a packing from the shelf, or make it and leave it there.

    Parameters
    ----------
    packing : Packing
    checkpoint : Checkpoint, optional
        That of the run: the shelf is a folder beside it. There is none for the hidden checkpoint of a single run.
    """
    if checkpoint is None or checkpoint.path.name.startswith("."):
        return pack(packing)
    path = shelf_path(checkpoint.path.parent / FOLDER, packing)
    found = _take(path)
    if found is None:
        found = pack(packing)
        _leave(found, path)
    return found


def shelf_path(folder: Path, packing: Packing) -> Path:
    """File of a packing."""
    words = f"{canonical(packing)}\0{digest_numbers('packing')}"
    return folder / f"packing-{hashlib.sha256(words.encode()).hexdigest()[:20]}.npy"


def _take(path: Path) -> PackedDiscs | None:
    """Packing of a file; None if there is none or if it is broken, which is said."""
    try:
        facts = unseal(path)
        discs = np.load(path)
    except FileNotFoundError:
        return None
    except (Broken, OSError, ValueError) as why:
        warnings.warn(f"{path}: not used: {why}; the packing is made anew", stacklevel=3)
        return None
    return PackedDiscs(*discs, **facts)


def _leave(discs: PackedDiscs, path: Path) -> None:
    """Write a packing; a disk that is full or read-only costs the next case its time, no more."""
    numbers = {name: getattr(discs, name) for name in PackedDiscs._fields[_ARRAYS:]}
    try:
        with replacing(path) as temporary:
            with open(temporary, "wb") as file:
                np.save(file, np.stack(discs[:_ARRAYS]))
            seal(temporary, numbers)
    except OSError as error:
        warnings.warn(f"{path}: packing not kept: {error.strerror}; the run goes on", stacklevel=3)
