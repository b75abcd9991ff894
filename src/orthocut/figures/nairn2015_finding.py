"""What rules find of the claims of Nairn (2015), and what several rules need."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from orthocut.figures.claims import ARTEFACT, NOT_REPRODUCED, REPRODUCED, Finding
from orthocut.figures.extrapolation import Fit, extrapolate
from orthocut.figures.nairn2015_cuts import Cut, along
from orthocut.figures.varied import transfers
from orthocut.theory import bending, touching

Rule = Callable[[Sequence[Cut]], Finding | None]


def verdict(holds: bool, converged: bool = True, alone: bool = False) -> str:
    """Verdict on a claim.

    Parameters
    ----------
    holds : bool
        Whether it holds at the resolution of most cuts.
    converged : bool
        Whether it holds at zero particle size.
    alone : bool
        Whether zero particle size decides alone, as the limits of most cuts are known; otherwise both must hold.
    """
    if converged and (holds or alone):
        return REPRODUCED
    return ARTEFACT if holds else NOT_REPRODUCED


def most_known(limits: Sequence[Cut], cuts: Sequence[Cut]) -> bool:
    """Whether the limits at zero particle size are known of at least half of some cuts."""
    return bool(limits) and 2 * len(limits) >= len(cuts)


def known(number: float) -> float:
    """Return a number, zero for NaN."""
    return number if math.isfinite(number) else 0.0


def force_touching(cut: Cut) -> float:
    """Force over toughness of the touching model with the cut's own rubbing force [-]."""
    case = cut.case
    rubbing = cut.rubbing * case.interface.toughness
    return touching.solve(case.material, case.interface, case.tool, case.cut_depth, rubbing).force_over_toughness


def force_bending(cut: Cut, form: str = "consistent") -> float:
    """Force over toughness of the bending model with the cut's own rubbing force [-]; NaN where it has no solution."""
    case = cut.case
    rubbing = cut.rubbing * case.interface.toughness
    return bending.solve(
        case.material, case.interface, case.tool, case.cut_depth, rubbing, form=form
    ).force_over_toughness


def fits(cuts: Sequence[Cut]) -> list[tuple[list[Cut], Fit]]:
    """Straight fits over particle size of all groups of three sizes or more, by scheme."""
    found = []
    for group in along(cuts, "points_per_depth", least=3):
        sizes = [1 / cut.points for cut in group]
        found.append((group, extrapolate(sizes, [cut.force for cut in group], [cut.error for cut in group])))
    return sorted(found, key=lambda pair: (pair[0][0].case.numerics.affine, pair[0][0].depth))


def scheme_words(group: Sequence[Cut]) -> str:
    """Scheme, depth of cut and tangent modulus of cuts that share them, in words."""
    case = group[0].case
    scheme = transfers(case.numerics.affine)
    return f"{scheme}, {1e3 * case.cut_depth:g} mm, E_T = {1e-6 * case.material.modulus_tangent:g} MPa"


def place_words(cut: Cut) -> str:
    """Depth of cut, rake angle and friction of a cut in words."""
    case = cut.case
    friction = f", μ = {case.tool.friction:g}" if case.tool.friction else ""
    return f"{1e3 * cut.depth:g} mm and {math.degrees(case.tool.rake_angle):.3g}°{friction}"
