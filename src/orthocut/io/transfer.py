"""Carry sealed results from one store to another, as a folder or as a tar archive."""

from __future__ import annotations

import shutil
import tarfile
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from orthocut.io.files import replacing
from orthocut.io.seal import Broken, unseal
from orthocut.io.store import SNAPSHOTS, SUFFIX, Store

ARCHIVES = (".tar", ".tar.gz", ".tgz")


class Transfer(NamedTuple):
    """What became of the files."""

    copied: list[str]
    present: list[str]
    broken: list[str]


def is_archive(path: Path) -> bool:
    """Whether a name is that of a tar archive."""
    return path.name.endswith(ARCHIVES)


def export_results(store: Store, keys: Iterable[str], target: Path, snapshots: bool = True) -> Transfer:
    """Copy results, checked, to a folder or into a new archive.

    Parameters
    ----------
    store : Store
    keys : iterable of str
    target : Path
        Folder, made if needed, or archive that ends in .tar, .tar.gz or .tgz; an archive is replaced.
    snapshots : bool
        Also copy snapshots.
    """
    suffixes = (SUFFIX, SNAPSHOTS) if snapshots else (SUFFIX,)
    paths = [store.path(key, suffix) for key in keys for suffix in suffixes if store.path(key, suffix).exists()]
    if not is_archive(target):
        return _copy(paths, target)

    with replacing(target) as temporary, tempfile.TemporaryDirectory(dir=target.parent) as folder:
        done = _copy(paths, Path(folder))
        mode = "w" if target.suffix == ".tar" else "w:gz"
        with tarfile.open(temporary, mode) as archive:
            for name in done.copied:
                archive.add(Path(folder, name), arcname=name)
    return done


def import_results(source: Path, store: Store) -> Transfer:
    """Copy results, checked, from a folder or an archive into a store; results that are there stay.

    Raises
    ------
    tarfile.TarError, EOFError, zlib.error
        If the archive is damaged or holds names that are not those of plain files.
    """
    if not is_archive(source):
        return _copy(sorted(source.glob(f"*{SUFFIX}")), store.root)
    store.root.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=store.root, prefix=".import-") as folder, tarfile.open(source) as archive:
        archive.extractall(folder, filter="data")
        return _copy(sorted(Path(folder).glob(f"*{SUFFIX}")), store.root)


def _copy(paths: Iterable[Path], folder: Path) -> Transfer:
    """Copy sealed files that are whole, unless the same is there already, whole."""
    done = Transfer([], [], [])
    for path in paths:
        target = folder / path.name
        if not _whole(path):
            done.broken.append(path.name)
        elif _whole(target):
            done.present.append(path.name)
        else:
            with replacing(target) as temporary:
                shutil.copyfile(path, temporary)
            done.copied.append(path.name)
    return done


def _whole(path: Path) -> bool:
    """Whether a file is there and its seal holds."""
    try:
        unseal(path)
    except (FileNotFoundError, Broken):
        return False
    return True
