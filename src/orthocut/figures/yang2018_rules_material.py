"""Rules on the synthetic glass of Yang et al. (2018): its properties and its cracks."""

from __future__ import annotations

from collections.abc import Sequence

from orthocut.figures.claims import NOT_REPRODUCED, REPRODUCED, Finding
from orthocut.figures.confidence import interval
from orthocut.figures.yang2018_finding import Glass, Rule, agrees, deviation, said, worst
from orthocut.figures.yang2018_paper import CRACKS, TABLE_2, Property
from orthocut.figures.yang2018_runs import GlassRun, as_printed


def _specimens(glass: Glass, row: Property, printed: bool) -> list[GlassRun]:
    """Tests of a property with the finest discs that there are, smooth platens."""
    runs = glass.tension if row.kind == "dem_tension" else glass.compression
    runs = [
        run for run in runs if as_printed(run.case.joint) == printed and not getattr(run.case, "friction_platen", 0.0)
    ]
    finest = min((run.case.packing.radius_min for run in runs), default=0.0)
    return [run for run in runs if run.case.packing.radius_min == finest]


def printed_gives(row: Property) -> Rule:
    """Return the rule on one property of the specimen with the parameters of Table 1 as printed."""

    def rule(glass: Glass) -> Finding | None:
        runs = _specimens(glass, row, True)
        if not runs:
            return None
        known = interval([run[row.variable] for run in runs])
        return Finding(
            said(known, "" if row.unit == "-" else row.unit),
            deviation(known.mean, row.model),
            agrees(known, row.model),
            f"yang2018_table2; {known.count} packings of discs from {1e6 * runs[0].case.packing.radius_min:.3g} um, "
            f"Table 1 as printed; holds within 10 %",
        )

    return rule


def calibration_reaches_glass(glass: Glass) -> Finding | None:
    """All four properties of glass within 10 % with one set of calibrated joints."""
    found = [(row, _specimens(glass, row, False)) for row in TABLE_2]
    if not all(runs for _, runs in found):
        return None
    known = [(row, interval([run[row.variable] for run in runs])) for row, runs in found]
    errors = [deviation(one.mean, row.glass) for row, one in known]
    words = ", ".join(
        f"{row.words} {said(one, '' if row.unit == '-' else row.unit)} ({row.glass:g})" for row, one in known
    )
    return Finding(
        f"largest deviation {max(errors, key=abs):+.0f} %",
        max(errors, key=abs),
        worst([agrees(one, row.glass) for row, one in known]),
        f"yang2018_table2; ours (glass): {words}; holds within 10 % each",
    )


def both_kinds_of_cracks(glass: Glass) -> Finding | None:
    """Every cut of the paper has cracks in tension and in shear."""
    cuts = [run for runs in glass.conditions.values() for run in runs if run["cracks_tension_total"] >= 0]
    if not cuts:
        return None
    both = [run["cracks_tension_total"] > 0 and run["cracks_shear_total"] > 0 for run in cuts]
    tests = "".join(
        f"; {name} tests: {interval([run['cracks_total'] for run in some]).mean:.0f} broken elements (paper: "
        f"{CRACKS[f'dem_{name}']}), {_shear_share(some):.0%} in shear"
        for name, some in (("tension", glass.tension), ("compression", glass.compression))
        if some
    )
    return Finding(
        f"in {sum(both)} of {len(both)} cuts; {_shear_share(cuts):.0%} in shear",
        float("nan"),
        REPRODUCED if all(both) else NOT_REPRODUCED,
        f"yang2018_fig11-14, fig07, fig08; holds if every cut has both{tests}",
    )


def _shear_share(runs: Sequence[GlassRun]) -> float:
    """Share of the broken elements of some runs that broke in shear."""
    return sum(run["cracks_shear_total"] for run in runs) / max(sum(run["cracks_total"] for run in runs), 1)
