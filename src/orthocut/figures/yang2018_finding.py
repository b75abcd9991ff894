"""What rules find of the claims of Yang et al. (2018), and what several rules need."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import xarray as xr

from orthocut.figures.claims import NOT_REPRODUCED, REPRODUCED, UNDECIDED, Finding
from orthocut.figures.confidence import Interval, ratio
from orthocut.figures.yang2018_paper import Cut
from orthocut.figures.yang2018_runs import GlassRun, conditions, cuts_of, early, paired, runs_of

BAND = 0.10
"""Deviation from a number of the paper that counts as agreement [-]."""
VAGUE = 0.20
"""Half-width of a confidence interval over the mean above which a mean inside the band decides nothing [-]."""
REGULAR, GROOVED = False, True


class Glass(NamedTuple):
    """The runs that rules judge from."""

    cuts: list[GlassRun]
    """All cuts."""
    conditions: dict[Cut, list[GlassRun]]
    """The cuts of the paper, made as most are."""
    tension: list[GlassRun]
    compression: list[GlassRun]


Rule = Callable[[Glass], Finding | None]


def glass_of(dataset: xr.Dataset) -> Glass:
    """All finished runs of a dataset."""
    cuts = cuts_of(dataset)
    tension, compression = (runs_of(dataset, f"dem_{kind}", "strength_ultimate") for kind in ("tension", "compression"))
    return Glass(cuts, conditions(cuts), tension, compression)


def agrees(known: Interval, low: float, high: float | None = None) -> str:
    """Verdict on a number: inside the paper's value or range, widened by the band, or outside of it.

    A single run is outside or undecided, never inside.

    Parameters
    ----------
    known : Interval
        Ours.
    low, high : float
        The paper's value, or its range.
    """
    bottom, top = low * (1 - BAND), (low if high is None else high) * (1 + BAND)
    half = known.half if math.isfinite(known.half) else 0.0
    if known.mean + half < bottom or known.mean - half > top:
        return NOT_REPRODUCED
    if known.count > 1 and bottom <= known.mean <= top and known.half <= VAGUE * abs(known.mean):
        return REPRODUCED
    return UNDECIDED


def below(known: Interval, limit: float) -> str:
    """Verdict on being less than a limit, interval included; what is known well and is not less is not reproduced."""
    return _beyond(known, limit - known.mean, known.mean)


def above(known: Interval, limit: float) -> str:
    """Verdict on being more than a limit, interval included; what is known well and is not more is not reproduced."""
    return _beyond(known, known.mean - limit, known.mean)


def _beyond(known: Interval, margin: float, size: float) -> str:
    """Verdict on a margin that should be positive, of a number of some size."""
    if known.count < 2:
        return UNDECIDED
    if margin > known.half:
        return REPRODUCED
    known_well = known.half <= VAGUE * abs(size)
    return NOT_REPRODUCED if margin < -known.half or (margin <= 0 and known_well) else UNDECIDED


def worst(verdicts: Sequence[str]) -> str:
    """Verdict on a claim of which each part must hold."""
    for verdict in (NOT_REPRODUCED, UNDECIDED):
        if verdict in verdicts:
            return verdict
    return REPRODUCED


def over(first: Sequence[GlassRun], second: Sequence[GlassRun], name: str) -> Interval:
    """Ratio of the means of a number of two sets of cuts, by packings that both have."""
    return ratio(*([run[name] for run in runs] for runs in paired(first, second)))


def over_early(first: Sequence[GlassRun], second: Sequence[GlassRun], name: str) -> Interval:
    """The same of a force over the first three quarters of the travel, before chips pile up at the fixed side."""
    return ratio(*(early(runs, name) for runs in paired(first, second)))


def said(known: Interval, unit: str = "") -> str:
    """Mean and half-width of its interval in words."""
    half = f" ± {_digits(known.half, 2)}" if math.isfinite(known.half) else ""
    return f"{_digits(known.mean, 3)}{half}{f' {unit}' if unit else ''}"


def _digits(number: float, digits: int) -> str:
    """Number with some digits, never with an exponent where it is large."""
    return f"{number:.0f}" if abs(number) >= 10**digits else f"{number:.{digits}g}"


def deviation(ours: float, paper: float) -> float:
    """Deviation from the paper's value [%]."""
    return 100 * (ours / paper - 1)
