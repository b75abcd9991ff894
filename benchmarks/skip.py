"""A piece of work that is skipped where a scene does not need it."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple


class Skip(NamedTuple):
    """What is skipped, and how to measure what that saves and changes."""

    solver: str
    what: str
    without: Callable[[], float]
    """Cost when it is not skipped; any unit, the same for both."""
    skipping: Callable[[], float]
    """Cost when it is skipped."""
    change: Callable[[], float]
    """Relative change of the answer; 0 is bitwise equality, NaN that there is nothing to compare."""
