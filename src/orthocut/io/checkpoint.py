"""Checkpoints of long runs: the whole state, now and then by wall time, in a file that belongs to one result."""

from __future__ import annotations

import time
import warnings
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from orthocut.io.files import replacing

INTERVAL = 60.0
"""Wall time between checkpoints [s]."""


class Checkpoint:
    """File that holds the state of one run.

    Parameters
    ----------
    path : Path
        The file, ``.npz``.
    key : str
        Name of the result; a state of another result is not used.
    every : float
        Wall time between checkpoints [s].
    clock : callable
        Seconds that never jump.
    announce : callable
        Receives the run time so far when a run goes on from an earlier one [s].
    """

    def __init__(
        self,
        path: Path,
        key: str,
        every: float = INTERVAL,
        clock: Callable[[], float] = time.monotonic,
        announce: Callable[[float], None] = lambda seconds: None,
    ) -> None:
        self.path, self.key, self.every, self.clock, self.announce = Path(path), key, every, clock, announce
        self._begun = self._last = clock()
        self._earlier = 0.0
        self._warned = False

    @property
    def seconds(self) -> float:
        """Run time so far, with that of the runs before the last checkpoint [s]."""
        return self._earlier + self.clock() - self._begun

    def restore(self) -> dict[str, np.ndarray] | None:
        """State of the last checkpoint; None if there is none, or if it is broken or of another result."""
        try:
            with np.load(self.path) as file:
                state = dict(file)
        except FileNotFoundError:
            return None
        except (OSError, ValueError, EOFError, KeyError, zipfile.BadZipFile) as error:
            self._set_aside(f"{type(error).__name__}: {error}")
            return None
        if str(state.pop("key", "")) != self.key:
            self._set_aside("it belongs to another result")
            return None
        self._earlier = float(state.pop("seconds"))
        self.announce(self._earlier)
        return state

    def offer(self, make: Callable[[], Mapping[str, np.ndarray]]) -> bool:
        """Save the state that `make` returns if the last checkpoint is old enough; return whether it was saved."""
        if self.clock() - self._last < self.every:
            return False
        try:
            with replacing(self.path) as temporary, open(temporary, "wb") as file:
                np.savez(file, key=self.key, seconds=self.seconds, **make())
        except OSError as error:
            if not self._warned:
                warnings.warn(f"{self.path}: no checkpoint: {error.strerror}; the run goes on", stacklevel=2)
            self._warned = True
            return False
        finally:
            self._last = self.clock()
        return True

    def remove(self) -> None:
        """Remove the file when the result is there."""
        self.path.unlink(missing_ok=True)

    def _set_aside(self, why: str) -> None:
        moved = self.path.with_name(f"{self.path.name}.corrupt")
        try:
            self.path.replace(moved)
        except OSError:
            moved = self.path
        warnings.warn(f"{moved}: not used: {why}; the run starts anew", stacklevel=3)


def packed(prefix: str, arrays: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Arrays under names that begin with a prefix, to stand beside others in a checkpoint."""
    return {f"{prefix}/{name}": values for name, values in arrays.items()}


def unpacked(prefix: str, state: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Return what `packed` packed under a prefix."""
    return {name.removeprefix(f"{prefix}/"): state[name] for name in state if name.startswith(f"{prefix}/")}
