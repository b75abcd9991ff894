"""Rules on cracks, chips and the shape of grooves in Yang et al. (2018)."""

from __future__ import annotations

import math

from orthocut.figures.claims import Finding
from orthocut.figures.confidence import Interval
from orthocut.figures.yang2018_finding import (
    GROOVED,
    REGULAR,
    Glass,
    above,
    agrees,
    below,
    deviation,
    over,
    said,
    worst,
)
from orthocut.figures.yang2018_paper import EXPERIMENT, SIMULATION, mean
from orthocut.figures.yang2018_runs import GlassRun, usual
from orthocut.params.dem import Grooves

SHALLOW, DEEP = 0.1, 0.2
FEW = 0.1
"""Share of the cracks below a regular cut up to which those of a grooved one are nearly none."""


def _grooved_over_regular(glass: Glass, name: str) -> list[Interval] | None:
    found = []
    for depth in (SHALLOW, DEEP):
        grooved, regular = (glass.conditions.get((depth, surface), []) for surface in (GROOVED, REGULAR))
        if not grooved or not regular:
            return None
        found.append(over(grooved, regular, name))
    return found


def _both(found: list[Interval]) -> str:
    return ", ".join(f"x {said(one)} at {depth:g} mm" for depth, one in zip((SHALLOW, DEEP), found, strict=True))


def grooves_leave_fewer_cracks(glass: Glass) -> Finding | None:
    """Fewer broken elements in all with grooves, at both depths of cut."""
    found = _grooved_over_regular(glass, "cracks_total")
    if found is None:
        return None
    return Finding(
        _both(found),
        math.nan,
        worst([below(one, 1.0) for one in found]),
        "yang2018_damage; broken elements with grooves over those without, same packings; holds if both 95 % intervals "
        "lie below 1",
    )


def grooves_leave_shallower_cracks(glass: Glass) -> Finding | None:
    """Cracks below the cut reach less deep with grooves, at both depths of cut."""
    found, deepest = (_grooved_over_regular(glass, name) for name in ("damage_depth_most", "damage_depth"))
    if found is None or deepest is None:
        return None
    return Finding(
        _both(found),
        math.nan,
        worst([below(one, 1.0) for one in found]),
        f"yang2018_damage; depth that 95 % of the cracks below the cut keep to, with grooves over that without; "
        f"holds if both 95 % intervals lie below 1; of the deepest crack: {_both(deepest)}",
    )


def grooves_leave_no_cracks_below(glass: Glass) -> Finding | None:
    """Hardly any broken elements below the cut with grooves: a tenth of those without, or fewer."""
    found = _grooved_over_regular(glass, "cracks_below")
    if found is None:
        return None
    return Finding(
        _both(found),
        math.nan,
        worst([below(one, FEW) for one in found]),
        f"yang2018_damage; broken elements below the cut with grooves over those without; holds up to {FEW:g}",
    )


def _deep_over_shallow(glass: Glass, name: str, surface: bool = REGULAR) -> Interval | None:
    deep, shallow = (glass.conditions.get((depth, surface), []) for depth in (DEEP, SHALLOW))
    return over(deep, shallow, name) if deep and shallow else None


def deep_cuts_damage_deeper(glass: Glass) -> Finding | None:
    """Cracks below the cut reach deeper at 0.2 mm than at 0.1 mm, without grooves."""
    found, deepest = (_deep_over_shallow(glass, name) for name in ("damage_depth_most", "damage_depth"))
    if found is None or deepest is None:
        return None
    return Finding(
        f"x {said(found)}",
        math.nan,
        above(found, 1.0),
        f"yang2018_damage; depth that 95 % of the cracks below the cut keep to, 0.2 over 0.1 mm; holds if the 95 % "
        f"interval lies above 1; of the deepest crack: x {said(deepest)}",
    )


def deep_cuts_have_larger_chips(glass: Glass) -> Finding | None:
    """The largest chip is larger at 0.2 mm than at 0.1 mm, without grooves."""
    found, grooved = (_deep_over_shallow(glass, "chip_area_largest", surface) for surface in (REGULAR, GROOVED))
    if found is None:
        return None
    words = f"; with grooves: x {said(grooved)}" if grooved else ""
    return Finding(
        f"x {said(found)}",
        math.nan,
        above(found, 1.0),
        f"yang2018_damage; area of the largest chip, 0.2 over 0.1 mm; holds if the 95 % interval lies above 1{words}",
    )


def trapezoids_explain_the_thrust(glass: Glass) -> Finding | None:
    """Trapezoid grooves raise the thrust force of the deep cut to the measured one."""
    rectangles = glass.conditions.get((DEEP, GROOVED), [])
    ratios = sorted({run.case.grooves.bottom_ratio for run in usual(glass.cuts) if run.case.grooves is not None})
    found = {}
    for share in ratios:
        if share < 1:
            shape = Grooves(bottom_ratio=share)
            runs = [run for run in usual(glass.cuts) if run.case.grooves == shape and _is_deep(run)]
            found[share] = (over(runs, rectangles, "force_thrust_mean"), over(runs, rectangles, "force_cutting_mean"))
    found = {share: pair for share, pair in found.items() if pair[0].count}
    if not found:
        return None
    cut = (DEEP, GROOVED)
    wanted = [mean(EXPERIMENT[cut][name]) / mean(SIMULATION[cut][name]) for name in ("force_thrust", "force_cutting")]
    best = max(found, key=lambda share: found[share][0].mean)
    thrust = found[best][0]
    words = "; ".join(
        f"foot {share:g} of the width: thrust x {said(pair[0])}, main x {said(pair[1])}"
        for share, pair in found.items()
    )
    return Finding(
        f"x {said(thrust)} (foot {best:g} of the width)",
        deviation(thrust.mean, wanted[0]),
        agrees(thrust, wanted[0]),
        f"yang2018_damage; force with trapezoids over that with rectangles, same packings: {words}; needed in the "
        f"paper's raw comparison: thrust x {wanted[0]:.2f}, main x {wanted[1]:.2f}; holds within 10 %",
    )


def _is_deep(run: GlassRun) -> bool:
    return math.isclose(run.case.cut_depth, 1e-3 * DEEP)
