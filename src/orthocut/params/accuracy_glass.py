"""Speed of the tool and number of packings of cuts of glass by the error that they promise of the mean main force."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from orthocut.params.accuracy import Promise, evidence, outside
from orthocut.params.dem import DemCutting
from orthocut.params.quantity import convert

MOST = 400
"""Most packings that a tolerance takes."""


class Choice(NamedTuple):
    """What a preset or a tolerance sets."""

    cut_speed: str
    packings: int
    """Packings whose mean the promise is about."""

    @property
    def work(self) -> float:
        """Cost over that of another choice for the same cut: packings times steps [-]."""
        return self.packings / convert(self.cut_speed, "m/s")

    def fields(self) -> dict[str, Any]:
        """Raw fields of a case."""
        return {**_evidence()["common"], "cut_speed": self.cut_speed}


def _evidence() -> dict[str, Any]:
    return evidence()["glass"]


def presets() -> dict[str, Choice]:
    """Preset to what it sets."""
    return {name: Choice(**values) for name, values in _evidence()["presets"].items()}


def row_of(speed: float) -> dict[str, Any] | None:
    """What is known of a speed of the tool [m/s]; None if it is too fast."""
    return next((row for row in _evidence()["speed"] if speed <= convert(row["cut_speed"], "m/s")), None)


def promise(case: DemCutting, choice: Choice) -> Promise | None:
    """Error of a choice for a cut against the mean of slow cuts; None where the evidence does not reach."""
    row = row_of(convert(choice.cut_speed, "m/s"))
    if row is None or any(outside(case, _evidence()["domain"])):
        return None
    noise = row["scatter"] / math.sqrt(choice.packings)
    return Promise(*(_kept(share, row[name], noise) for name, share in (("bound", 0.9), ("typical", 0.5))))


def _kept(share: float, added: float, noise: float) -> float:
    """Size that a share of the errors keeps to, if all forces are too large by one number and scatter about that.

    Parameters
    ----------
    share : float
    added : float
        What the speed adds, over the force of slow cuts [-].
    noise : float
        Standard error of the mean over the mean [-].
    """
    from scipy.special import chndtrix  # slow to import, and most cases do without

    noise *= 1 + added
    return noise * math.sqrt(float(chndtrix(share, 1, (added / noise) ** 2)))


def cheapest(case: DemCutting, tolerance: float, packings: int | None = None) -> Choice | None:
    """Cheapest choice whose bound meets a tolerance [-]; None if there is none.

    Parameters
    ----------
    packings : int, optional
        Number of packings, if it is given.
    """
    return min(_able(case, tolerance, packings), key=lambda choice: choice.work, default=None)


def _able(case: DemCutting, tolerance: float, packings: int | None) -> Iterator[Choice]:
    """For each speed the fewest packings that meet a tolerance."""
    for row in _evidence()["speed"]:
        for count in [packings] if packings else range(1, MOST + 1):
            choice = Choice(row["cut_speed"], count)
            found = promise(case, choice)
            if found and found.bound <= tolerance:
                yield choice
                break


def why_not(case: DemCutting, packings: int | None = None) -> str:
    """Why no setting meets a tolerance, and what could be asked for."""
    beyond = list(outside(case, _evidence()["domain"]))
    if beyond:
        return f"errors are not known outside of {', '.join(beyond)}; take a preset"
    least = min(promise(case, Choice(row["cut_speed"], packings or MOST)).bound for row in _evidence()["speed"])
    allowed = f"allowed: {math.ceil(100 * least)} % or more" if least < 1 else "allowed: in sweeps"
    if not packings:
        return f"no setting is known to be as good ({allowed})"
    words = "one packing" if packings == 1 else f"the mean of {packings} packings"
    return f"{words} is not known to be as good ({allowed}); a sweep without replicates takes as many as it needs"
