"""Files appear whole or not at all: written under a hidden name, flushed to disk, renamed."""

from __future__ import annotations

import errno
import fcntl
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

_ROOM = 1 << 16  # bytes that a disk with room for a result has left


@contextmanager
def replacing(path: str | Path) -> Iterator[Path]:
    """Give a temporary name beside a file; what was written there takes the file's place when the block ends well.

    Parameters
    ----------
    path : str or Path
        File to make or replace; its folder is made.

    Yields
    ------
    Path
        Hidden name in the same folder, unique to this process; nothing is left of it if the block raises.

    Raises
    ------
    OSError
        If the disk is full or the folder cannot be written to; the old file, if any, is as it was.
    """
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        yield temporary
        _flush(temporary, os.O_RDWR)
        os.replace(temporary, path)
        with suppress(OSError):  # some file systems cannot flush a folder
            _flush(path.parent, os.O_RDONLY)
    except (RuntimeError, OSError) as error:  # netCDF's own words for a full disk are "HDF error"
        if shutil.disk_usage(path.parent).free < _ROOM:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path)) from error
        raise
    finally:
        temporary.unlink(missing_ok=True)


_held: list[IO[str]] = []
"""Files that this process has locked: a lock ends when its file is closed."""


def hold(path: str | Path, shared: bool = False) -> None:
    """Lock a file for as long as this process lives, however it ends.

    Parameters
    ----------
    path : str or Path
        File that stands for what is locked; it is made, and stays.
    shared : bool
        Whether others may hold it at the same time, if they share it too.

    Raises
    ------
    BlockingIOError
        If another process holds the lock; the message says which.
    """
    _held.append(_lock(Path(path), shared))


@contextmanager
def held(path: str | Path, shared: bool = False) -> Iterator[None]:
    """Lock a file as `hold` does, for as long as the context lasts."""
    with _lock(Path(path), shared):
        yield


def _lock(path: Path, shared: bool) -> IO[str]:
    path.parent.mkdir(parents=True, exist_ok=True)
    file = open(path, "a+", encoding="utf-8")  # noqa: SIM115
    try:
        fcntl.flock(file, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
    except BlockingIOError:
        file.seek(0)
        holder = file.read().strip()
        file.close()
        raise BlockingIOError(errno.EAGAIN, f"in use by {holder or 'another process'}", str(path)) from None
    file.truncate(0)
    file.write(f"process {os.getpid()} on {os.uname().nodename}\n")
    file.flush()
    return file


def write_text(text: str, path: str | Path) -> Path:
    """Write a text file whole or not at all."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return Path(path)


def _flush(path: Path, flags: int) -> None:
    """Ask the system to put a file or a folder on disk."""
    handle = os.open(path, flags)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
