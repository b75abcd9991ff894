"""Rules on the cohesive zone in Nairn (2015): mode of failure, stress and shape of the law."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from orthocut.figures.nairn2015_cuts import Cut, select, usual
from orthocut.figures.nairn2015_finding import Finding, force_bending, verdict


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
    means = []
    for strength in (40, 10):
        chosen = [cut for cut in select(usual(cuts), friction=None, strength=strength) if not cut.touching]
        excess = np.array([abs(cut.force / force_bending(cut, form="paper") - 1) for cut in chosen])
        means.append(float(excess[np.isfinite(excess)].mean()) if np.isfinite(excess).any() else math.nan)
    if not all(map(math.isfinite, means)):
        return None
    return Finding(
        f"mean deviation {means[1]:.0%}, {means[0]:.0%} at 40 MPa",
        math.nan,
        verdict(means[1] < means[0]),
        "nairn2015_fig11, nairn2015_fig15; bending cuts against the printed model with their own rubbing forces; holds "
        "if the mean deviation is smaller at 10 MPa",
    )


def law_changes_the_force(cuts: Sequence[Cut]) -> Finding | None:
    """Forces at 100 MPa with another cohesive law of the same stress and toughness differ by more than 5 %."""
    laws = {cut.case.interface.law for cut in cuts} - {"cubic"}
    cubic = {cut.depth: cut for cut in select(usual(cuts), tangent=100)}
    ratios = [
        cut.force / cubic[cut.depth].force - 1
        for law in laws
        for cut in select(usual(cuts), tangent=100, law=law)
        if cut.depth in cubic
    ]
    if not ratios:
        return None
    return Finding(
        f"{min(ratios):+.0%} to {max(ratios):+.0%}",
        math.nan,
        verdict(max(map(abs, ratios)) > 0.05),
        f"nairn2015_fig14; {len(ratios)} pairs of the same depth of cut; holds if one differs by more than 5 %",
    )
