"""Rules on the method of Nairn (2015): base, particle size, transfers, steady state."""

from __future__ import annotations

import math
import statistics
from collections.abc import Sequence
from itertools import chain

from orthocut.figures.claims import UNDECIDED, Finding
from orthocut.figures.nairn2015_cuts import Cut, along, select, usual
from orthocut.figures.nairn2015_finding import fits, known, scheme_words, verdict
from orthocut.io.collect import parameters

DEEP = 3.0
"""Depth of the base over depth of cut from which on the paper's forces are constant [-]."""
ALIKE = 0.03
"""Change of a force that counts as none [-]."""
PAPER_STEADY = 5.6
"""Travel of the paper's tool in 4 ms over its depth of cut: half of 3 ms and then 1 ms at 2 m/s, over 0.9 mm [-]."""


def force_does_not_depend_on_base(cuts: Sequence[Cut]) -> Finding | None:
    """Forces of bases of 3 depths of cut or more agree with that of the deepest within 3 %, two standard errors aside.

    Cuts with other time steps, which change the force by no more than its noise, count as repeats.
    """
    groups = sorted(along(cuts, "base_ratio", least=3), key=lambda group: -group[0].points)
    repeats: dict[float, list[Cut]] = {}
    for cut in chain.from_iterable(groups):
        if _but_base(cut) == _but_base(groups[0][0]):
            repeats.setdefault(cut.case.workpiece.base_ratio, []).append(cut)
    if len(repeats) < 3:
        return None
    deepest = max(repeats)
    force, error = _pooled(repeats.pop(deepest))
    others = {base: _pooled(alike) for base, alike in repeats.items()}
    changes = {base: abs(mean / force - 1) for base, (mean, _) in others.items()}
    deep = [base for base in others if base >= DEEP]
    if not deep:
        return None
    worst = max(deep, key=changes.__getitem__)
    noise = math.hypot(known(error), known(others[worst][1])) / force
    thin = max((change for base, change in changes.items() if base < DEEP), default=math.nan)
    return Finding(
        f"changes by {changes[worst]:.1%} ± {noise:.1%} from d = {worst:g} to {deepest:g}",
        100 * changes[worst],
        verdict(changes[worst] <= ALIKE) if abs(changes[worst] - ALIKE) > 2 * noise else UNDECIDED,
        f"nairn2015_fig03a; means over {min(map(len, repeats.values()))} time steps; holds up to {ALIKE:.0%}, "
        f"undecided within two standard errors of that; below {DEEP:g}: {thin:.1%}",
    )


def _but_base(cut: Cut) -> dict[str, float]:
    """Fields of a cut without the depth of its base and the time step."""
    return {name: value for name, value in parameters(cut.case).items() if name not in ("base_ratio", "courant")}


def _pooled(alike: Sequence[Cut]) -> tuple[float, float]:
    """Mean force of repeats and its standard error, by their scatter or by their own errors, whichever is larger."""
    forces, own = [cut.force for cut in alike], [cut.error for cut in alike]
    scatter = statistics.stdev(forces) if len(forces) > 1 else 0.0
    return statistics.mean(forces), max(scatter, math.sqrt(statistics.mean(e**2 for e in own))) / math.sqrt(len(forces))


def force_declines_with_size(cuts: Sequence[Cut]) -> Finding | None:
    """The force of the bending cut with PIC falls with particle size by more than two standard errors of the slope."""
    groups = fits(select(cuts, tangent=100))
    pic = next(((group, fit) for group, fit in groups if group[0].case.numerics.affine == 0), None)
    if pic is None:
        return None
    group, fit = pic
    others = "; ".join(
        f"{scheme_words(runs)}: slope {one.slope:.2f} ± {one.slope_error:.2f}, limit {one.limit:.2f} ± {one.error:.2f}"
        for runs, one in groups
    )
    first, last = group[0], group[-1]
    points = f"{first.points} to {last.points} points"
    return Finding(
        f"{first.force:.2f} to {last.force:.2f} bGc from {points}, PIC",
        math.nan,
        verdict(fit.slope > 2 * fit.slope_error),
        f"nairn2015_fig03b, nairn2015_convergence; holds if the slope is above two standard errors; {others}",
    )


def transfers_do_not_change_the_force(cuts: Sequence[Cut]) -> Finding | None:
    """Forces with PIC and with FLIP, or else with the gradient handed on, differ by 5 % at most at one resolution."""
    flips = [(group[0], group[-1]) for group in along(cuts, "flip") if group[0].case.numerics.flip == 0]
    pairs = [(group[0], group[-1]) for group in along(cuts, "affine") if group[0].case.numerics.affine == 0]
    if not pairs:
        return None
    usual_points = usual(cuts)[0].points
    near = [pair for pair in pairs if pair[0].points == usual_points] or pairs
    changes = [pic.force / other.force - 1 for pic, other in near]
    compared = {(pic.depth, pic.case.material) for pic, _ in pairs}
    limits = "; ".join(
        f"{scheme_words(group)}: {fit.limit:.2f} ± {fit.error:.2f}"
        for group, fit in fits(select(cuts, tangent=None))
        if (group[0].depth, group[0].case.material) in compared
    )
    said = "PIC over gradients " + ", ".join(f"{change:+.0%}" for change in changes)
    evidence = f"holds within 5 % at the same resolution; at zero particle size {limits or 'not known'}"
    if flips:
        evidence = f"{said}; {evidence}"
        share = min(flip.case.numerics.flip for _, flip in flips)
        changes = [pic.force / flip.force - 1 for pic, flip in flips]
        said = f"PIC over {share:.0%} FLIP " + ", ".join(f"{change:+.0%}" for change in changes)
    largest = max(changes, key=abs)
    return Finding(said, 100 * largest, verdict(abs(largest) <= 0.05), f"nairn2015_convergence; {evidence}")


def steady_from_four_ms(cuts: Sequence[Cut]) -> Finding | None:
    """The cut of Fig. 4 is steady after the travel that the paper's tool has made in 4 ms, 5.6 depths of cut."""
    there = [cut for cut in select(cuts, tangent=100) if math.isclose(cut.depth, 0.9e-3) and math.isfinite(cut.steady)]
    if not there:
        return None
    cut = min(there, key=lambda cut: (abs(cut.case.cut_speed - 2.0), -cut.points))
    ratio = cut.steady / PAPER_STEADY
    return Finding(
        f"from {cut.steady:.1f} depths of cut at {cut.case.cut_speed:g} m/s",
        100 * (ratio - 1),
        verdict(ratio <= 1.1),
        f"nairn2015_fig04; beyond it, means over one depth of cut stay within 10 % of the mean of the window; holds up "
        f"to 1.1 x {PAPER_STEADY} depths of cut; the force then drifts by {known(cut.drift):+.1%} over the window",
    )
