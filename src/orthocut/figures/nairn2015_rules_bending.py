"""Rules on cuts whose chip bends in Nairn (2015): forces, rubbing, strains."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from orthocut.figures.claims import Finding
from orthocut.figures.nairn2015_cuts import Cut, at_zero_size, select, usual
from orthocut.figures.nairn2015_finding import fits, force_bending, known, most_known, place_words, verdict


def forces_exceed_bending_by_10_to_90_percent(cuts: Sequence[Cut]) -> Finding | None:
    """At least 80 % of the cuts at 100 MPa lie 10-90 % above the printed model, and so at zero particle size."""
    chosen = select(usual(cuts), rake=None, tangent=100)
    here = _excess(chosen)
    if not here.size:
        return None
    at_zero = select(at_zero_size(cuts), rake=None, tangent=100)
    there = _excess(at_zero)
    alone = most_known(at_zero, chosen) and bool(there.size)
    judged = there if alone else here
    median = float(np.median(judged))
    plain = np.array([cut.force / force_bending(cut) - 1 for cut in chosen])
    limits = [
        (fit.limit / force_bending(group[-1]) - 1, fit.error / force_bending(group[-1]))
        for group, fit in fits(select(cuts, tangent=100))
    ]
    shown = ", ".join(f"{limit:+.0%} ± {error:.0%}" for limit, error in limits)
    return Finding(
        _excess_words(judged) + (" at zero size" if alone else ""),
        100 * max(0.1 - median, median - 0.9, 0.0),
        verdict(
            _inside(here) >= 0.8,
            (not there.size or _inside(there) >= 0.8) and (not limits or max(limit for limit, _ in limits) > 0.05),
            alone,
        ),
        f"nairn2015_fig13; {_inside(here):.0%} of {here.size} cuts at {chosen[0].points} points lie 10-90 % above the "
        f"printed model, {_excess_words(here)}; 80 % are needed, at zero particle size where that is known of half of "
        f"them, and there 5 % above the consistent one where three sizes are; above that {np.nanmin(plain):+.0%} to "
        f"{np.nanmax(plain):+.0%}"
        + (
            f"; at zero particle size {_inside(there):.0%} of {there.size}, {_excess_words(there)}, median standard "
            f"error of an extrapolation {_scatter(at_zero):.1%}"
            if there.size
            else ""
        )
        + (f"; from three sizes or more (0.9 mm) above the consistent one {shown}" if limits else ""),
    )


def _excess(cuts: Sequence[Cut]) -> np.ndarray:
    """Force over that of the printed model, less one, of the cuts for which it has a solution [-]."""
    excess = np.array([cut.force / force_bending(cut, form="paper") - 1 for cut in cuts])
    return excess[np.isfinite(excess)]


def _inside(excess: np.ndarray) -> float:
    """Share of the cuts that lie 10-90 % above the model [-]."""
    return float(((excess >= 0.1) & (excess <= 0.9)).mean())


def _excess_words(excess: np.ndarray) -> str:
    return f"{excess.min():+.0%} to {excess.max():+.0%}, median {np.median(excess):+.0%}"


def _scatter(cuts: Sequence[Cut]) -> float:
    """Median of the standard errors of forces, over the forces [-]."""
    return float(np.median([known(cut.error) / cut.force for cut in cuts]))


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
