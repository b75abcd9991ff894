"""Rules on cuts that touch the crack tip in Nairn (2015): forces and mode of failure."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from orthocut.figures.claims import Finding
from orthocut.figures.nairn2015_cuts import Cut, at_zero_size, hanging, select, usual
from orthocut.figures.nairn2015_finding import (
    fits,
    force_bending,
    force_touching,
    known,
    most_known,
    place_words,
    scheme_words,
    verdict,
)
from orthocut.theory.forces import thrust_ratio

MEAN, EACH = 0.10, 0.25
"""Deviation from the model that the mean of all cuts, and each of them, may have [-]."""


def touching_agrees_without_friction(cuts: Sequence[Cut]) -> Finding | None:
    """Touching cuts without friction: within 10 % of eq. (15) in the mean, 25 % each, and so at zero particle size."""
    found = _touching_agreement(cuts, lambda cut: cut.case.tool.friction == 0, "(15)", "nairn2015_fig08")
    words = "; ".join(
        f"{fit.limit / force_touching(group[-1]) - 1:+.0%} ± {fit.error / force_touching(group[-1]):.0%} "
        f"({scheme_words(group)})"
        for group, fit in fits(select(cuts, tangent=0))
        if all(cut.touching for cut in group)
    )
    if found is None or not words:
        return found
    return found._replace(evidence=f"{found.evidence}; from three sizes or more {words}")


def touching_agrees_with_friction(cuts: Sequence[Cut]) -> Finding | None:
    """Touching cuts with friction: within 10 % of eq. (14) in the mean, 25 % each, and so at zero particle size."""
    return _touching_agreement(cuts, lambda cut: cut.case.tool.friction > 0, "(14)", "nairn2015_fig11")


class _Agreement(NamedTuple):
    """Deviations of touching cuts from the model with their own rubbing forces."""

    mean: float
    error: float
    """Standard error of the mean, from those of the cuts [-]."""
    largest: float
    largest_error: float
    where: str
    scatter: float
    """Median of the standard errors of the cuts [-]."""
    holds: bool

    def words(self) -> str:
        """Mean and largest deviation with their standard errors."""
        return (
            f"mean {self.mean:+.1%} ± {self.error:.1%}, largest {self.largest:+.1%} ± {self.largest_error:.1%} "
            f"at {self.where}"
        )


def _agreement(cuts: Sequence[Cut]) -> _Agreement:
    models = np.array([force_touching(cut) for cut in cuts])
    deviations = np.array([cut.force for cut in cuts]) / models - 1
    errors = np.array([known(cut.error) for cut in cuts]) / models
    mean, error = float(deviations.mean()), float(np.sqrt((errors**2).sum()) / len(cuts))
    worst = int(np.abs(deviations).argmax())
    holds = abs(mean) <= MEAN and bool((np.abs(deviations) - 2 * errors <= EACH).all())
    return _Agreement(
        mean,
        error,
        float(deviations[worst]),
        float(errors[worst]),
        place_words(cuts[worst]),
        float(np.median(errors)),
        holds,
    )


def _touching_agreement(
    cuts: Sequence[Cut], wanted: Callable[[Cut], bool], equation: str, figure: str
) -> Finding | None:
    here, limits, moved = (
        [cut for cut in select(some, rake=None, friction=None) if cut.touching and wanted(cut)]
        for some in (usual(cuts), at_zero_size(cuts), hanging(cuts))
    )
    if not here:
        return None
    found = _agreement(here)
    judged, words = found, ""
    if limits:
        limit = _agreement(limits)
        judged = limit if most_known(limits, here) else found
        words = (
            f"; at zero particle size, {len(limits)} of them: {limit.words()}, median standard error of an "
            f"extrapolation {limit.scatter:.1%}"
        )
        words += f"; {len(moved)} of the touching cuts bend at another resolution" if moved else ""
    return Finding(
        f"mean {judged.mean:+.1%}, largest {judged.largest:+.1%}" + (" at zero size" if judged is not found else ""),
        100 * judged.mean,
        verdict(found.holds, not limits or limit.holds, judged is not found),
        f"{figure}; {len(here)} touching cuts at {here[0].points} points against eq. {equation} with their own rubbing "
        f"forces: {found.words()}{words}; holds within 10 % in the mean and, two standard errors aside, 25 % each, at "
        f"zero particle size where that is known of half of the cuts",
    )


def thin_cuts_touch_against_the_lower_force(cuts: Sequence[Cut]) -> Finding | None:
    """All touching cuts for which both models have a solution touch although the bending model needs less force."""
    chosen = [cut for cut in select(usual(cuts), rake=None, friction=None) if cut.touching]
    pairs = [(force_bending(cut), force_touching(cut)) for cut in chosen]
    pairs = [pair for pair in pairs if math.isfinite(pair[0])]
    if not pairs:
        return None
    lower = sum(bent < touched for bent, touched in pairs)
    return Finding(
        f"{lower} of {len(pairs)} touching cuts",
        math.nan,
        verdict(lower == len(pairs)),
        "nairn2015_fig08, nairn2015_fig11; they touch although the bending model needs less force; holds if all do",
    )


def touching_mode_falls_with_thrust_ratio(cuts: Sequence[Cut]) -> Finding | None:
    """Mode I of touching cuts and Z correlate with -0.7 or less; six cuts and three values of Z are needed."""
    chosen = [
        cut
        for cut in select(usual(cuts), rake=None, friction=None)
        if cut.touching and math.isfinite(cut.mode_one) and cut.mode_one > 0
    ]
    ratios = np.array([thrust_ratio(cut.case.tool.rake_angle, cut.case.tool.friction) for cut in chosen])
    if len(chosen) < 6 or np.unique(ratios.round(6)).size < 3:
        return None
    fractions = np.array([cut.mode_one for cut in chosen])
    spread = float(fractions.std())
    coefficient = float(np.corrcoef(ratios, fractions)[0, 1]) if spread else 0.0
    return Finding(
        f"correlation {coefficient:+.2f}",
        math.nan,
        verdict(coefficient <= -0.7),
        f"nairn2015_fig16; {len(chosen)} touching cuts; holds at -0.7 or below",
    )
