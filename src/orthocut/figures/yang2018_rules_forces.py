"""Rules on the cutting forces of Yang et al. (2018): means, depth of cut, grooves, peaks, replicates, experiments."""

from __future__ import annotations

import math

from scipy.special import fdtrc

from orthocut.figures.claims import NOT_REPRODUCED, REPRODUCED, UNDECIDED, Finding
from orthocut.figures.confidence import Interval, interval, needed, prediction, ratio
from orthocut.figures.yang2018_comparison import factor
from orthocut.figures.yang2018_finding import (
    GROOVED,
    REGULAR,
    Glass,
    Rule,
    above,
    agrees,
    below,
    deviation,
    over,
    over_early,
    said,
    worst,
)
from orthocut.figures.yang2018_paper import EXPERIMENT, FORCES, SIMULATION, WIDTHS, Cut, mean, words
from orthocut.figures.yang2018_runs import GlassRun, condition, early, forces, usual
from orthocut.params.dem import Grooves

MAIN, THRUST = FORCES
SHALLOW, DEEP = 0.1, 0.2
LEAST = 6
"""Fewest packings that decide on how replicates scatter."""
ODD = 1.06
"""Thrust force of the third replicate of the deep grooved cut in Table 4 [N/mm]."""


def mean_is(cut: Cut, name: str) -> Rule:
    """Return the rule on one mean of Table 4."""

    def rule(glass: Glass) -> Finding | None:
        values = forces(glass.conditions.get(cut, []), name)
        if not values:
            return None
        known, paper = interval(values), mean(SIMULATION[cut][name])
        return Finding(
            said(known, "N/mm"),
            deviation(known.mean, paper),
            agrees(known, paper),
            f"yang2018_table4; {known.count} packings; holds within 10 %; {needed(values, 0.1):g} packings would bring "
            f"the 95 % half-width below 10 %; over the first three quarters of the travel "
            f"{said(interval(early(glass.conditions[cut], name)), 'N/mm')}{_damped(glass, cut, name)}",
        )

    return rule


def _damped(glass: Glass, cut: Cut, name: str) -> str:
    """Mean force of the same cut with most damping, for the evidence."""
    made = glass.conditions[cut][0].case
    most = max(run.case.joint.damping for run in glass.cuts)
    joint = made.joint.model_copy(update={"damping": most})
    same = made.model_copy(update={"joint": joint})
    damped = [run for run in glass.cuts if run.case.model_copy(update={"packing": made.packing}) == same]
    if most == made.joint.damping or not damped:
        return ""
    return f"; with a damping of {most:g} {said(interval(forces(damped, name)), 'N/mm')}"


def _rise(glass: Glass, grooved: bool, name: str) -> Interval | None:
    deep, shallow = (glass.conditions.get((depth, grooved), []) for depth in (DEEP, SHALLOW))
    return over(deep, shallow, f"{name}_mean") if deep and shallow else None


def forces_rise_with_depth(glass: Glass) -> Finding | None:
    """Main forces of deep cuts exceed those of shallow ones, on both surfaces, by more than the interval."""
    found = {surface: _rise(glass, surface, MAIN) for surface in (REGULAR, GROOVED)}
    if None in found.values():
        return None
    thrust = _rise(glass, GROOVED, THRUST)
    return Finding(
        f"x {said(found[REGULAR])} regular, x {said(found[GROOVED])} grooved",
        deviation(found[REGULAR].mean, _paper_rise(REGULAR)),
        worst([above(one, 1.0) for one in found.values()]),
        f"yang2018_table4; the paper's factors: {_paper_rise(REGULAR):.2f} and {_paper_rise(GROOVED):.2f}; holds if "
        f"both 95 % intervals lie above 1; thrust of grooved cuts: x {said(thrust)}",
    )


def _paper_rise(grooved: bool) -> float:
    return mean(SIMULATION[(DEEP, grooved)][MAIN]) / mean(SIMULATION[(SHALLOW, grooved)][MAIN])


def exponent_of_depth(glass: Glass) -> Finding | None:
    """Exponent of the main force over the depth of cut of regular cuts."""
    rise = _rise(glass, REGULAR, MAIN)
    if rise is None or not rise.mean > 0:
        return None
    known = Interval(math.log2(rise.mean), rise.half / (rise.mean * math.log(2.0)), math.nan, rise.count)
    paper = math.log2(_paper_rise(REGULAR))
    inside = abs(known.mean - paper) <= max(known.half, 0.05)
    verdict = NOT_REPRODUCED if not inside else REPRODUCED if known.half <= 0.25 else UNDECIDED
    return Finding(
        said(known),
        deviation(known.mean, paper),
        verdict,
        f"yang2018_table4; {known.count} packings at both depths; holds if the 95 % interval holds {paper:.2f} and its "
        f"half-width is 0.25 at most; a force that goes with the area of the cut would have 1",
    )


def grooves_lower_forces(glass: Glass) -> Finding | None:
    """Main forces with grooves over those without: in the paper's range at both depths."""
    found, before = {}, {}
    for depth in (SHALLOW, DEEP):
        grooved, regular = (glass.conditions.get((depth, surface), []) for surface in (GROOVED, REGULAR))
        if not grooved or not regular:
            return None
        found[depth] = over(grooved, regular, f"{MAIN}_mean")
        before[depth] = over_early(grooved, regular, MAIN)
    paper = [mean(SIMULATION[(depth, GROOVED)][MAIN]) / mean(SIMULATION[(depth, REGULAR)][MAIN]) for depth in found]
    lower = worst([below(one, 1.0) for one in found.values()])
    average = 0.5 * sum(one.mean for one in found.values())
    return Finding(
        _at_depths(found),
        deviation(average, 0.5 * sum(paper)),
        worst([agrees(one, min(paper), max(paper)) for one in found.values()]),
        f"yang2018_table4; holds within the paper's {paper[0]:.2f} and {paper[1]:.2f}, 10 % aside; that grooves lower "
        f"the force at all: {lower}; over the first three quarters of the travel {_at_depths(before)}{_closer(glass)}",
    )


def _at_depths(found: dict[float, Interval]) -> str:
    return ", ".join(f"{said(one)} at {depth:g} mm" for depth, one in found.items())


def _closer(glass: Glass) -> str:
    """The same ratios where 0.2 mm is the pitch of the grooves, not their distance, for the evidence."""
    close = [run for run in usual(glass.cuts) if run.case.grooves and run.case.grooves.distance < Grooves().distance]
    found, before = {}, {}
    for depth in (SHALLOW, DEEP):
        grooved = [run for run in close if condition(run)[0] == depth]
        if grooved and glass.conditions.get((depth, REGULAR)):
            found[depth] = over(grooved, glass.conditions[depth, REGULAR], f"{MAIN}_mean")
            before[depth] = over_early(grooved, glass.conditions[depth, REGULAR], MAIN)
    if not found:
        return ""
    return (
        f"; with 0.2 mm as the pitch of the grooves: {_at_depths(found)}, over the first three quarters of the travel, "
        f"without the groove at the fixed side, {_at_depths(before)}"
    )


def thrust_over_main(glass: Glass) -> Finding | None:
    """Thrust over main force of regular cuts: in the paper's range at both depths."""
    found = {}
    for depth in (SHALLOW, DEEP):
        runs = glass.conditions.get((depth, REGULAR), [])
        if not runs:
            return None
        found[depth] = _thrust_ratio(runs)
    paper = [mean(SIMULATION[(depth, REGULAR)][THRUST]) / mean(SIMULATION[(depth, REGULAR)][MAIN]) for depth in found]
    average = 0.5 * sum(one.mean for one in found.values())
    return Finding(
        _at_depths(found),
        deviation(average, 0.5 * sum(paper)),
        worst([agrees(one, min(paper), max(paper)) for one in found.values()]),
        f"yang2018_table4; holds within the paper's {min(paper):.2f} to {max(paper):.2f}, 10 % aside; its experiments "
        f"have 0.82 and 0.79",
    )


def _thrust_ratio(runs: list[GlassRun]) -> Interval:
    return ratio(forces(runs, THRUST), forces(runs, MAIN))


def peaks_are_random(glass: Glass) -> Finding | None:
    """Forces rise above their mean many times, scatter by half of it or more, and not alike in two packings."""
    runs = [run for some in glass.conditions.values() for run in some if math.isfinite(run["force_cutting_variation"])]
    if not runs:
        return None
    variation = interval([run["force_cutting_variation"] for run in runs])
    times = interval([run["force_cutting_excursions"] for run in runs])
    peak = interval([run[f"{MAIN}_peak"] / run[f"{MAIN}_mean"] for run in runs])
    holds = variation.mean >= 0.5 and times.mean >= 5
    return Finding(
        f"{times.mean:.0f} excursions above the mean, peak {peak.mean:.0f} times the mean",
        math.nan,
        REPRODUCED if holds else NOT_REPRODUCED,
        f"yang2018_fig11-14; {len(runs)} cuts; standard deviation over mean {said(variation)}; holds from 5 excursions "
        f"and a standard deviation of half of the mean on",
    )


def grooved_cuts_scatter_more(glass: Glass) -> Finding | None:
    """Replicates of main forces scatter more, over their mean, with grooves than without: F test at both depths."""
    pairs, verdicts = [], []
    for depth in (SHALLOW, DEEP):
        some = [forces(glass.conditions.get((depth, surface), []), MAIN) for surface in (REGULAR, GROOVED)]
        if min(map(len, some)) < 3:
            return None
        enough = min(map(len, some)) >= LEAST
        regular, grooved = (_variation(interval(values)) for values in some)
        pairs.append((regular, grooved))
        chance = float(fdtrc(len(some[1]) - 1, len(some[0]) - 1, (grooved / regular) ** 2))
        verdicts.append(REPRODUCED if chance < 0.05 else NOT_REPRODUCED if chance > 0.5 and enough else UNDECIDED)
    paper = [
        [_variation(interval(SIMULATION[(depth, surface)][MAIN])) for surface in (REGULAR, GROOVED)]
        for depth in (SHALLOW, DEEP)
    ]
    return Finding(
        "; ".join(f"{regular:.0%} regular, {grooved:.0%} grooved" for regular, grooved in pairs),
        math.nan,
        worst(verdicts),
        "yang2018_table4; standard deviation over mean of replicates, 0.1 and 0.2 mm; holds if the chance of such a "
        "ratio without a difference is below 5 %, fails if ours is the other way round in six packings or more; paper: "
        + "; ".join(f"{regular:.0%}, {grooved:.0%}" for regular, grooved in paper),
    )


def _variation(known: Interval) -> float:
    return known.spread / abs(known.mean)


def odd_replicate(glass: Glass) -> Finding | None:
    """The paper's 1.06 N over the mean of its replicates lies where one more replicate of ours is expected."""
    values = forces(glass.conditions.get((DEEP, GROOVED), []), THRUST)
    if len(values) < 3:
        return None
    low, high = prediction(values)
    average = sum(values) / len(values)
    share = ODD / mean(SIMULATION[(DEEP, GROOVED)][THRUST])
    absolute, relative = low <= ODD <= high, low / average <= share <= high / average
    lowest = min(values) / average
    return Finding(
        f"{share:.2f} of the mean is {_place(relative)} {max(low / average, 0):.2f} to {high / average:.2f}",
        math.nan,
        NOT_REPRODUCED if not relative else REPRODUCED if len(values) >= LEAST else UNDECIDED,
        f"yang2018_table4; {len(values)} packings, 95 % prediction for one more, each over the mean of its replicates; "
        f"our lowest is {lowest:.2f}; in newtons it is {_place(absolute)} {max(low, 0.0):.3g} to {high:.3g} N/mm; "
        f"without it the paper's replicates scatter by 1 %",
    )


def _place(inside: bool) -> str:
    return "inside" if inside else "outside"


def agrees_with_experiment(glass: Glass) -> Finding | None:
    """Main force of regular cuts for the same width over the measured one."""
    cuts = [(depth, REGULAR) for depth in (SHALLOW, DEEP)]
    if not all(glass.conditions.get(cut) for cut in cuts):
        return None
    ours = [interval(forces(glass.conditions[cut], MAIN)) for cut in cuts]
    real = [mean(EXPERIMENT[cut][MAIN]) / WIDTHS["experiment"] for cut in cuts]
    ratios = [one.mean / each for one, each in zip(ours, real, strict=True)]
    raw = [one.mean / (WIDTHS["experiment"] * each) for one, each in zip(ours, real, strict=True)]
    paper = [factor(cut, name) for cut in sorted(SIMULATION) for name in FORCES]
    return Finding(
        ", ".join(f"x {value:.0f} ({words(cut)})" for value, cut in zip(ratios, cuts, strict=True)),
        100 * (sum(ratios) / len(ratios) - 1),
        REPRODUCED if all(abs(value - 1) <= 0.26 for value in ratios) else NOT_REPRODUCED,
        f"yang2018_table6; force for the same width over the measured one; the paper compares a cut of 1 mm with one "
        f"of 25.4 mm: for the same width its own simulations exceed its experiments {min(paper):.0f} to "
        f"{max(paper):.0f} times; compared in the raw way ours are x {raw[0]:.2f} and x {raw[1]:.2f}",
    )
