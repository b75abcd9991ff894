"""Rules on the cohesive zone in Nairn (2015): mode of failure, stress and shape of the law."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from orthocut.figures.claims import UNDECIDED, Finding
from orthocut.figures.nairn2015_cuts import Cut, at_zero_size, select, usual
from orthocut.figures.nairn2015_finding import force_bending, known, most_known, verdict


def bending_is_mode_one(cuts: Sequence[Cut]) -> Finding | None:
    """Every perfectly plastic cut that bends fails with more than 90 % of mode I."""
    chosen = [cut for cut in select(usual(cuts), rake=None, friction=None) if not cut.touching]
    fractions = [cut.mode_one for cut in chosen if math.isfinite(cut.mode_one)]
    if not fractions:
        return None
    above = sum(fraction > 0.9 for fraction in fractions)
    return Finding(
        f"{min(fractions):.0%} to {max(fractions):.0%}",
        100 * min(min(fractions) / 0.9 - 1, 0.0),
        verdict(above == len(fractions)),
        f"nairn2015_fig16; {above} of {len(fractions)} bending cuts are above 90 %; holds if all are",
    )


def weak_bending_is_75_percent_mode_one(cuts: Sequence[Cut]) -> Finding | None:
    """Cuts at 10 MPa that bend fail with 75 % of mode I in the mean, within 5 %."""
    chosen = [cut for cut in select(usual(cuts), rake=None, friction=None, strength=10) if not cut.touching]
    fractions = [cut.mode_one for cut in chosen if math.isfinite(cut.mode_one)]
    if not fractions:
        return None
    mean = float(np.mean(fractions))
    return Finding(
        f"mean {mean:.0%} ({min(fractions):.0%} to {max(fractions):.0%})",
        100 * (mean / 0.75 - 1),
        verdict(abs(mean - 0.75) <= 0.05),
        f"nairn2015_fig15; {len(fractions)} bending cuts; holds if the mean is 70-80 %",
    )


def weak_interface_fits_bending_better(cuts: Sequence[Cut]) -> Finding | None:
    """Bending cuts at 10 MPa deviate less from the printed model, in the mean, than those at 40 MPa."""
    here, limits = _mean_deviations(usual(cuts)), _mean_deviations(at_zero_size(cuts))
    if here is None:
        return None
    alone = limits is not None and most_known(at_zero_size(cuts), usual(cuts))
    strong, weak = limits if alone else here
    words = f"; at zero particle size {limits[1]:.0%}, {limits[0]:.0%} at 40 MPa" if limits else ""
    return Finding(
        f"mean deviation {weak:.0%}, {strong:.0%} at 40 MPa" + (" at zero size" if alone else ""),
        math.nan,
        verdict(here[1] < here[0], limits is None or limits[1] < limits[0], alone),
        f"nairn2015_fig11, nairn2015_fig15; bending cuts at {usual(cuts)[0].points} points against the printed model "
        f"with their own rubbing forces {here[1]:.0%}, {here[0]:.0%} at 40 MPa{words}; holds if the mean deviation is "
        "smaller at 10 MPa",
    )


def _mean_deviations(cuts: Sequence[Cut]) -> tuple[float, float] | None:
    """Mean deviation of bending cuts from the printed model at 40 and at 10 MPa [-]; None without either."""
    means = []
    for strength in (40, 10):
        chosen = [cut for cut in select(cuts, friction=None, strength=strength) if not cut.touching]
        excess = np.array([abs(cut.force / force_bending(cut, form="paper") - 1) for cut in chosen])
        if not np.isfinite(excess).any():
            return None
        means.append(float(excess[np.isfinite(excess)].mean()))
    return means[0], means[1]


def law_changes_the_force(cuts: Sequence[Cut]) -> Finding | None:
    """Forces at 100 MPa with another cohesive law of the same stress and toughness differ by more than 5 %."""
    here, limits = _law_changes(usual(cuts)), _law_changes(at_zero_size(cuts))
    if not here:
        return None
    alone = 2 * len(limits) >= len(here)
    errors = [error for _, error in limits]
    ratios = [ratio for ratio, _ in (limits if alone else here)]
    words = f"; at zero particle size {_range(limits)}, standard errors up to {max(errors):.0%}" if limits else ""
    return Finding(
        f"{min(ratios):+.0%} to {max(ratios):+.0%}" + (" at zero size" if alone else ""),
        math.nan,
        _law_verdict(here, limits, alone),
        f"nairn2015_fig14; {len(here)} pairs of the same depth of cut at {usual(cuts)[0].points} points "
        f"{_range(here)}{words}; holds if one differs by more than 5 %, two standard errors "
        f"aside, fails if none can",
    )


def _law_verdict(here: list[tuple[float, float]], limits: list[tuple[float, float]], alone: bool) -> str:
    """Undecided where errors are too large to tell whether a limit differs."""
    if limits and not _differs(limits) and any(abs(change) + 2 * error > 0.05 for change, error in limits):
        return UNDECIDED
    return verdict(_differs(here), not limits or _differs(limits), alone)


def _law_changes(cuts: Sequence[Cut]) -> list[tuple[float, float]]:
    """Relative change of the force at 100 MPa with another cohesive law, and its standard error, of each pair [-]."""
    cubic = {cut.depth: cut for cut in select(cuts, tangent=100)}
    return [
        (cut.force / other.force - 1, math.hypot(known(cut.error), known(other.error)) / other.force)
        for law in sorted({cut.case.interface.law for cut in cuts} - {"cubic"})
        for cut in select(cuts, tangent=100, law=law)
        if (other := cubic.get(cut.depth)) is not None
    ]


def _differs(changes: list[tuple[float, float]]) -> bool:
    return any(abs(change) - 2 * error > 0.05 for change, error in changes)


def _range(changes: list[tuple[float, float]]) -> str:
    return f"{min(change for change, _ in changes):+.0%} to {max(change for change, _ in changes):+.0%}"
