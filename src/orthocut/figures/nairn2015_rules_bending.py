"""Rules on cuts whose chip bends in Nairn (2015): forces, rubbing, strains."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from orthocut.figures.nairn2015_cuts import Cut, select, usual
from orthocut.figures.nairn2015_finding import Finding, fits, force_bending, known, place_words, verdict


def forces_exceed_bending_by_10_to_90_percent(cuts: Sequence[Cut]) -> Finding | None:
    """At least 80 % of the cuts at 100 MPa lie 10-90 % above the printed model, and the limits more than 5 %."""
    chosen = select(usual(cuts), rake=None, tangent=100)
    excess = np.array([cut.force / force_bending(cut, form="paper") - 1 for cut in chosen])
    excess = excess[np.isfinite(excess)]
    if not excess.size:
        return None
    median = float(np.median(excess))
    inside = float(((excess >= 0.1) & (excess <= 0.9)).mean())
    plain = np.array([cut.force / force_bending(cut) - 1 for cut in chosen])
    limits = [
        (fit.limit / force_bending(group[-1]) - 1, fit.error / force_bending(group[-1]))
        for group, fit in fits(select(cuts, tangent=100))
    ]
    shown = ", ".join(f"{limit:+.0%} ± {error:.0%}" for limit, error in limits)
    return Finding(
        f"{excess.min():+.0%} to {excess.max():+.0%}, median {median:+.0%}",
        100 * max(0.1 - median, median - 0.9, 0.0),
        verdict(inside >= 0.8, not limits or max(limit for limit, _ in limits) > 0.05),
        f"nairn2015_fig13; {inside:.0%} of {excess.size} cuts lie 10-90 % above the printed model, 80 % are needed; "
        f"above the consistent one {np.nanmin(plain):+.0%} to {np.nanmax(plain):+.0%}"
        + (f"; at zero particle size (0.9 mm) {shown}" if limits else ""),
    )


def deep_cuts_have_no_peak(cuts: Sequence[Cut]) -> Finding | None:
    """At each rake angle and 100 MPa, the deepest cut (5 mm or more) takes 97 % of the largest force or more."""
    groups: dict[float, list[Cut]] = {}
    for cut in select(usual(cuts), rake=None, tangent=100):
        groups.setdefault(cut.case.tool.rake_angle, []).append(cut)
    deep = {rake: group for rake, group in groups.items() if group[-1].depth >= 5e-3 and len(group) > 2}
    if not deep:
        return None
    shares = {rake: group[-1].force / max(cut.force for cut in group) for rake, group in deep.items()}
    drift = max(abs(known(group[-1].drift)) for group in deep.values())
    peaks = [f"{math.degrees(rake):.3g}°: {share:.0%}" for rake, share in sorted(shares.items())]
    return Finding(
        "deepest over largest force, " + ", ".join(peaks),
        100 * (min(shares.values()) - 1),
        verdict(min(shares.values()) >= 0.97),
        f"nairn2015_fig13; holds if the deepest cut of each rake angle reaches 97 % of the largest force; the deepest "
        f"drift by up to {drift:.0%} over the window",
    )


def rubbing_grows_with_rake_and_depth(cuts: Sequence[Cut]) -> Finding | None:
    """Straight lines through rubbing forces beyond 2 mm rise at each rake angle, and more so at larger rake angles."""
    groups: dict[float, list[Cut]] = {}
    for cut in select(usual(cuts), rake=None):
        if not cut.touching and cut.depth >= 2e-3:
            groups.setdefault(round(math.degrees(cut.case.tool.rake_angle), 6), []).append(cut)
    slopes = {
        rake: float(np.polyfit([1e3 * cut.depth for cut in group], [cut.rubbing for cut in group], 1)[0])
        for rake, group in sorted(groups.items())
        if len(group) > 2
    }
    if len(slopes) < 2:
        return None
    trend = float(np.polyfit(list(slopes), list(slopes.values()), 1)[0])
    return Finding(
        "slopes " + ", ".join(f"{rake:.3g}°: {slope:.2f}/mm" for rake, slope in slopes.items()),
        math.nan,
        verdict(min(slopes.values()) > 0 and trend > 0),
        "nairn2015_fig10; rubbing force over toughness of bending cuts of 2 mm and more; holds if all slopes are "
        "positive and grow with the rake angle",
    )


def shear_strain_reaches_80_percent(cuts: Sequence[Cut]) -> Finding | None:
    """The largest shear strain of the cuts with snapshots and 100 MPa is between 60 % and 100 %."""
    chosen = [cut for cut in select(cuts, rake=None, tangent=100) if math.isfinite(cut.strain)]
    if not chosen:
        return None
    largest = max(chosen, key=lambda cut: cut.strain)
    return Finding(
        f"{largest.strain:.0%}",
        100 * (largest.strain / 0.8 - 1),
        verdict(0.6 <= largest.strain <= 1.0),
        f"nairn2015_fig05; difference of the principal stretches that 0.1 % of the points exceed, {len(chosen)} cuts, "
        f"largest at {place_words(largest)}; holds at 60-100 %",
    )
