"""Rules on cuts that touch the crack tip in Nairn (2015): forces and mode of failure."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from orthocut.figures.nairn2015_cuts import Cut, select, usual
from orthocut.figures.nairn2015_finding import (
    REPRODUCED,
    Finding,
    fits,
    force_bending,
    force_touching,
    place_words,
    scheme_words,
    verdict,
)
from orthocut.theory.forces import thrust_ratio


def touching_agrees_without_friction(cuts: Sequence[Cut]) -> Finding | None:
    """Touching cuts without friction: within 10 % of eq. (15) in the mean, 25 % each, and so at zero particle size."""
    limits = {
        scheme_words(group): fit.limit / force_touching(group[-1]) - 1
        for group, fit in fits(select(cuts, tangent=0))
        if all(cut.touching for cut in group)
    }
    found = _touching_agreement([cut for cut in usual(cuts) if cut.case.tool.friction == 0], "(15)", "nairn2015_fig08")
    if found is None or not limits:
        return found
    worst = max(limits.values(), key=abs)
    holds = found.verdict == REPRODUCED
    words = "; ".join(f"{limit:+.0%} ({scheme})" for scheme, limit in limits.items())
    return found._replace(
        verdict=verdict(holds, abs(worst) <= 0.25), evidence=f"{found.evidence}; at zero particle size {words}"
    )


def touching_agrees_with_friction(cuts: Sequence[Cut]) -> Finding | None:
    """Touching cuts with friction: within 10 % of eq. (14) in the mean, 25 % each."""
    return _touching_agreement([cut for cut in usual(cuts) if cut.case.tool.friction > 0], "(14)", "nairn2015_fig11")


def _touching_agreement(cuts: Sequence[Cut], equation: str, figure: str) -> Finding | None:
    chosen = [cut for cut in select(cuts, rake=None, friction=None) if cut.touching]
    if not chosen:
        return None
    deviations = np.array([cut.force / force_touching(cut) - 1 for cut in chosen])
    mean, largest = float(deviations.mean()), float(deviations[np.abs(deviations).argmax()])
    worst = chosen[int(np.abs(deviations).argmax())]
    return Finding(
        f"mean {mean:+.1%}, largest {largest:+.1%}",
        100 * mean,
        verdict(abs(mean) <= 0.10 and abs(largest) <= 0.25),
        f"{figure}; {len(chosen)} touching cuts against eq. {equation} with their own rubbing forces; holds within "
        f"10 % in the mean and 25 % each; largest at {place_words(worst)}",
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
