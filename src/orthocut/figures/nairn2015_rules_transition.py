"""Rules on the transition from touching to bending in Nairn (2015)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

from orthocut.figures.claims import Finding
from orthocut.figures.extrapolation import Fit, extrapolate
from orthocut.figures.nairn2015_cuts import Cut, alike, change_of, select, usual
from orthocut.figures.nairn2015_finding import place_words, verdict
from orthocut.figures.regimes import NOTCH_LONG, Transition

PAPER_TRANSITION = (2.0, 2.1)
"""Deepest touching and shallowest bending cut of the paper at a rake angle of 30 degrees [mm]."""
CERTAIN = 0.15
"""Standard error of the depth of transition at zero particle size up to which that depth is judged, over it [-]."""


def transition_at_thirty_degrees(cuts: Sequence[Cut]) -> Finding | None:
    """The depth at zero particle size, within its standard error, meets the paper's interval, 2.0-2.1 mm.

    A limit whose standard error exceeds 15 % of it would meet too much to say anything; without a better one, the
    interval of the usual resolution must come within 10 % of the paper's middle.
    """
    change = change_of(select(usual(cuts)))
    if not change.found:
        return None
    low, high = PAPER_TRANSITION
    paper = 0.5 * (low + high)
    middle, half = 1e3 * change.middle, 1e3 * change.half_width
    holds = abs(middle - paper) <= 0.1 * paper + half
    fit, words = _transition_fit(cuts)
    certain = fit is not None and 0 < fit.error <= CERTAIN * fit.limit
    meets = certain and fit.limit - fit.error <= high and fit.limit + fit.error >= low
    ours = f"{1e3 * change.low:g}-{1e3 * change.high:g} mm at {usual(cuts)[0].points} points"
    rule = f"holds if the interval is within 10 % of {paper} mm, as no limit at zero particle size is known to 15 %"
    if certain:
        middle = fit.limit
        ours = f"{fit.limit:.2f} ± {fit.error:.2f} mm at zero size, {ours}"
        rule = f"holds if the limit at zero particle size meets {low}-{high} mm within its standard error"
    extra = (
        f"; at zero particle size {fit.limit:.2f} ± {fit.error:.2f} mm, chi2/freedom {fit.misfit:.1f}" if fit else ""
    )
    bent = change_of(_with_bent_chip(cuts, usual(cuts)[0].points))
    extra += f"; from a long notch {_interval(bent)}" if bent.found else ""
    return Finding(
        ours,
        100 * (middle / paper - 1),
        verdict(holds, meets or not certain, certain),
        f"nairn2015_fig08, nairn2015_fig09, nairn2015_transition, nairn2015_regimes; {rule}; {words}{extra}",
    )


def _with_bent_chip(cuts: Sequence[Cut], points: int) -> list[Cut]:
    """Cuts at 30 degrees and a resolution that start from a long notch."""
    return [cut for cut in select(cuts) if cut.case.workpiece.notch_ratio >= NOTCH_LONG and cut.points == points]


def _transition_fit(cuts: Sequence[Cut]) -> tuple[Fit | None, str]:
    """Transition at 30 degrees over particle size [mm], and words for the transition at each size."""
    sizes: dict[int, list[Cut]] = {}
    for cut in select(alike(cuts)):
        sizes.setdefault(cut.points, []).append(cut)
    found = {points: change_of(group) for points, group in sorted(sizes.items()) if len(group) > 2}
    known = {points: change for points, change in found.items() if change.found}
    words = ", ".join(f"{_interval(change)} at {points} points" for points, change in known.items())
    if len(known) < 3:
        return None, words
    fit = extrapolate(
        [1 / points for points in known],
        [1e3 * change.middle for change in known.values()],
        [1e3 * change.standard_error for change in known.values()],
    )
    return fit, words


def friction_moves_the_transition_deeper(cuts: Sequence[Cut]) -> Finding | None:
    """The depth of transition at 30 degrees does not fall with friction anywhere, and rises in all."""
    return _moves(cuts, lambda cut: cut.case.tool.friction, {"friction": None}, +1, "nairn2015_fig11", "μ = {:g}")


def hardening_moves_the_transition_thinner(cuts: Sequence[Cut]) -> Finding | None:
    """The depth of transition at 30 degrees does not rise with the tangent modulus anywhere, and falls in all."""
    return _moves(
        cuts,
        lambda cut: 1e-6 * cut.case.material.modulus_tangent,
        {"tangent": None},
        -1,
        "nairn2015_fig12",
        "E_T = {:g} MPa",
    )


def weak_interface_moves_the_transition_thinner(cuts: Sequence[Cut]) -> Finding | None:
    """The depth of transition at 30 degrees is smaller at a cohesive stress of 10 MPa than at 40 MPa."""
    return _moves(
        cuts,
        lambda cut: 1e-6 * cut.case.interface.strength,
        {"strength": None},
        +1,
        "nairn2015_fig15",
        "σc = {:g} MPa",
    )


def _moves(
    cuts: Sequence[Cut], value: Callable[[Cut], float], free: dict, sign: int, figure: str, words: str
) -> Finding | None:
    """Whether the transition moves one way with a parameter; a series of one regime counts as it bounds it."""
    groups: dict[float, list[Cut]] = {}
    for cut in select(usual(cuts), **free):
        groups.setdefault(round(value(cut), 9), []).append(cut)
    changes = {key: change_of(group) for key, group in sorted(groups.items()) if len(group) > 2}
    if len(changes) < 2:
        return None
    ordered = list(changes.values())[::sign]
    falls = any(later.high < earlier.low for earlier, later in pairwise(ordered))
    rises = ordered[-1].low >= ordered[0].high
    shown = ", ".join(f"{words.format(key)}: {_interval(change)}" for key, change in changes.items())
    return Finding(
        shown,
        math.nan,
        verdict(rises and not falls),
        f"{figure}; depths of transition at a rake angle of 30°; holds if the interval of the last lies beyond that of "
        "the first and none lies behind the one before it",
    )


def _interval(change: Transition) -> str:
    if not change.found:
        return f"above {1e3 * change.low:g} mm" if change.low else f"below {1e3 * change.high:g} mm"
    return f"{1e3 * change.low:g}-{1e3 * change.high:g} mm"


def drop_vanishes_at_25_mpa(cuts: Sequence[Cut]) -> Finding | None:
    """The largest drop from one depth to the next at 25 MPa is below a quarter of that without hardening."""
    plastic, harder = select(usual(cuts)), select(usual(cuts), tangent=25)
    if len(plastic) < 3 or len(harder) < 3:
        return None
    first, second = _drop(plastic), _drop(harder)
    return Finding(
        f"drop of {second:.0%}, {first:.0%} without hardening",
        math.nan,
        verdict(first >= 0.2 and second <= 0.25 * first),
        "nairn2015_fig12; largest fall of the force from one depth of cut to the next at a rake angle of 30°; holds if "
        "it is 20 % or more without hardening and below a quarter of that at 25 MPa",
    )


def _drop(cuts: Sequence[Cut]) -> float:
    forces = [cut.force for cut in cuts]
    return max(0.0, *(1 - after / before for before, after in pairwise(forces)))


def hard_cuts_always_bend(cuts: Sequence[Cut]) -> Finding | None:
    """No cut with a tangent modulus of 100 MPa touches."""
    chosen = select(usual(cuts), rake=None, tangent=100)
    if not chosen:
        return None
    touched = [cut for cut in chosen if cut.touching]
    shown = "; touching: " + ", ".join(map(place_words, touched)) if touched else ""
    return Finding(
        f"{len(chosen) - len(touched)} of {len(chosen)} bend",
        math.nan,
        verdict(not touched),
        f"nairn2015_fig13, nairn2015_regimes; holds if all bend{shown}",
    )
