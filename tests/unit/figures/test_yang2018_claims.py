"""Verdicts on the claims of Yang et al. (2018) follow from the runs by rules, in both directions; none without runs."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from synthetic import dem_cut_run, dem_test_run, make_case

from orthocut.figures import registry
from orthocut.figures import yang2018_rules_damage as damage
from orthocut.figures import yang2018_rules_forces as force
from orthocut.figures import yang2018_rules_material as material
from orthocut.figures.claims import NOT_REPRODUCED, NOT_TESTED, REPRODUCED, UNDECIDED
from orthocut.figures.confidence import Interval
from orthocut.figures.yang2018_claims import CLAIMS
from orthocut.figures.yang2018_convergence import changes
from orthocut.figures.yang2018_finding import Glass, above, agrees, below, glass_of, said, worst
from orthocut.figures.yang2018_paper import SIMULATION, TABLE_2, mean
from orthocut.figures.yang2018_runs import (
    PARTS,
    GlassRun,
    along,
    as_printed,
    condense,
    conditions,
    cuts_of,
    early,
    usual,
)
from orthocut.io.collect import collect

BIG = {"packing.radius_min": "40 um"}
CUTS = list(SIMULATION)
SCATTER = np.array([0.97, 1.0, 1.03, 1.0, 0.98, 1.02])


def cut(depth=0.1, grooved=False, seed=1, scale=1.0, grooves=None, **numbers):
    fields = {"cut_depth": f"{depth} mm", "packing.seed": seed}
    if grooved:
        fields["grooves"] = grooves or {}
    paper = SIMULATION[depth, grooved]
    known = {f"{name}_mean": scale * mean(paper[name]) for name in paper}
    return GlassRun(make_case("dem_cutting", **fields), {**known, **numbers})


def glass(cuts=(), tension=(), compression=()):
    return Glass(list(cuts), conditions(cuts), list(tension), list(compression))


def four(factor=lambda depth, grooved: 1.0, **numbers):
    """Six packings of each cut of the paper, with forces as in the paper times a factor."""
    return [
        cut(depth, grooved, seed + 1, factor(depth, grooved) * scatter, **numbers)
        for depth, grooved in CUTS
        for seed, scatter in enumerate(SCATTER)
    ]


def verdict(rule, *arguments, **options):
    found = rule(glass(*arguments, **options))
    return found.verdict if found else NOT_TESTED


def specimen(kind="dem_tension", seed=1, joint=None, **numbers):
    return GlassRun(make_case(kind, **{"packing.seed": seed}, **(joint or {})), numbers)


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.text)
def test_missing_runs_are_not_tested(claim):
    assert claim.rule(glass()) is None


@pytest.mark.parametrize(
    ("known", "wanted"),
    [
        (Interval(10.5, 0.5, 1, 8), REPRODUCED),
        (Interval(13.0, 1.0, 1, 8), NOT_REPRODUCED),
        (Interval(13.0, 4.0, 1, 3), UNDECIDED),
        (Interval(10.0, 4.0, 1, 3), UNDECIDED),
        (Interval(10.0, math.nan, math.nan, 1), UNDECIDED),
        (Interval(20.0, math.nan, math.nan, 1), NOT_REPRODUCED),
    ],
)
def test_numbers_agree_within_the_band_or_not_or_it_is_not_known(known, wanted):
    assert agrees(known, 10.0) == wanted


@pytest.mark.parametrize(
    ("known", "wanted"),
    [
        (Interval(0.5, 0.2, 1, 5), REPRODUCED),
        (Interval(0.9, 0.2, 1, 5), UNDECIDED),
        (Interval(1.02, 0.1, 1, 5), NOT_REPRODUCED),
        (Interval(1.02, 0.7, 1, 3), UNDECIDED),
        (Interval(2.0, 0.5, 1, 3), NOT_REPRODUCED),
        (Interval(0.5, math.nan, math.nan, 1), UNDECIDED),
    ],
)
def test_being_less_is_judged_with_the_interval(known, wanted):
    assert below(known, 1.0) == wanted
    mirrored = known._replace(mean=2.0 - known.mean)
    assert above(mirrored, 1.0) == wanted


def test_grooves_at_the_other_pitch_and_damped_cuts_are_evidence():
    usual = four()
    assert "pitch" not in force.grooves_lower_forces(glass(usual)).evidence
    closer = [cut(0.2, True, seed, 0.5, {"distance": "0.14 mm"}) for seed in (1, 2, 3)]
    paper = {place: mean(SIMULATION[place]["force_cutting"]) for place in CUTS}
    expected = 0.5 * paper[0.2, True] / paper[0.2, False]
    found = force.grooves_lower_forces(glass(usual + closer)).evidence
    assert f"as the pitch of the grooves: {expected:.3g} ± " in found
    assert "at 0.2 mm" in found
    assert "at 0.1 mm" not in found.split("pitch")[1]

    rule = force.mean_is((0.1, False), "force_cutting")
    assert "damping" not in rule(glass(usual)).evidence
    damped = [
        GlassRun(make_case("dem_cutting", **{"cut_depth": "0.1 mm", "packing.seed": seed, "joint.damping": 0.9}), known)
        for seed, known in ((1, {"force_cutting_mean": 50.0}), (2, {"force_cutting_mean": 52.0}))
    ]
    assert "with a damping of 0.9 51.0 ± " in rule(glass(usual + damped)).evidence.replace("51 ±", "51.0 ±")


def test_grooves_are_also_judged_before_chips_pile_up_at_the_fixed_side():
    """The last quarter of the travel is the same on both surfaces; before it, grooves halve the force."""
    runs = []
    for run in four():
        parts = np.repeat([0.5 if run.case.grooves else 1.0, 5.0], [6, 2])
        runs.append(replace(run, parts={"force_cutting": (1 + 0.01 * run.seed) * parts}))
    found = force.grooves_lower_forces(glass(runs)).evidence
    assert "over the first three quarters of the travel 0.5 ± " in found


def test_every_part_of_a_claim_must_hold():
    assert worst([REPRODUCED, UNDECIDED]) == UNDECIDED
    assert worst([UNDECIDED, NOT_REPRODUCED]) == NOT_REPRODUCED
    assert said(Interval(332.0, 124.0, 1, 3), "MPa") == "332 ± 124 MPa"


@pytest.mark.parametrize(("scale", "wanted"), [(1.02, REPRODUCED), (1.5, NOT_REPRODUCED)])
def test_means_of_table_4(scale, wanted):
    for place in CUTS:
        for name in SIMULATION[place]:
            assert verdict(force.mean_is(place, name), four(lambda depth, grooved: scale)) == wanted


@pytest.mark.parametrize(("deep", "wanted"), [(1.0, REPRODUCED), (0.5, NOT_REPRODUCED)])
def test_forces_and_depth(deep, wanted):
    cuts = four(lambda depth, grooved: deep if depth == 0.2 else 1.0)
    assert verdict(force.forces_rise_with_depth, cuts) == wanted
    found = force.exponent_of_depth(glass(cuts))
    assert found.verdict == wanted
    assert found.error == pytest.approx(100 * math.log2(deep) / math.log2(17.70 / 14.98), abs=1.0)


@pytest.mark.parametrize(("grooved", "wanted"), [(1.0, REPRODUCED), (3.0, NOT_REPRODUCED)])
def test_forces_and_grooves(grooved, wanted):
    cuts = four(lambda depth, there: grooved if there else 1.0)
    found = force.grooves_lower_forces(glass(cuts))
    assert found.verdict == wanted
    assert f"at all: {REPRODUCED}" in found.evidence


def test_thrust_ratio():
    assert verdict(force.thrust_over_main, four()) == REPRODUCED
    assert verdict(force.thrust_over_main, four(force_thrust_mean=30.0)) == NOT_REPRODUCED


@pytest.mark.parametrize(
    ("variation", "excursions", "wanted"),
    [(1.5, 12, REPRODUCED), (0.1, 12, NOT_REPRODUCED), (1.5, 2, NOT_REPRODUCED)],
)
def test_peaks(variation, excursions, wanted):
    numbers = {"force_cutting_variation": variation, "force_cutting_excursions": excursions, "force_cutting_peak": 100}
    assert verdict(force.peaks_are_random, four(**numbers)) == wanted


@pytest.mark.parametrize(
    ("regular", "grooved", "wanted"), [(1, 20, REPRODUCED), (5, 1, NOT_REPRODUCED), (1, 1.4, UNDECIDED)]
)
def test_repeatability(regular, grooved, wanted):
    cuts = [
        cut(depth, there, seed + 1, 1 + (grooved if there else regular) * (scatter - 1))
        for depth, there in CUTS
        for seed, scatter in enumerate(SCATTER)
    ]
    assert verdict(force.grooved_cuts_scatter_more, cuts) == wanted


@pytest.mark.parametrize(("spread", "wanted"), [(0.4, REPRODUCED), (0.02, NOT_REPRODUCED)])
def test_odd_replicate(spread, wanted):
    cuts = [cut(0.2, True, seed, 30 * (1 + spread * place)) for seed, place in enumerate((-1, 0, 1, -0.5, 0.5, 0), 1)]
    found = force.odd_replicate(glass(cuts))
    assert found.verdict == wanted
    assert "in newtons it is" in found.evidence
    assert force.odd_replicate(glass(cuts[:4])).verdict in (UNDECIDED, NOT_REPRODUCED)


def test_experiments_are_compared_for_the_same_width():
    found = force.agrees_with_experiment(glass(four()))
    assert found.verdict == NOT_REPRODUCED
    assert found.ours.startswith("x 23")
    assert "10 to 24 times" in found.evidence
    assert verdict(force.agrees_with_experiment, four(lambda depth, grooved: 1 / 23.3)) == REPRODUCED


@pytest.mark.parametrize(
    ("rule", "names", "share"),
    [
        (damage.grooves_leave_fewer_cracks, ("cracks_tension_total", "cracks_shear_total"), 0.6),
        (damage.grooves_leave_shallower_cracks, ("damage_depth_most", "damage_depth"), 0.6),
        (damage.grooves_leave_no_cracks_below, ("cracks_tension_below", "cracks_shear_below"), 0.05),
    ],
)
def test_grooves_and_damage(rule, names, share):
    for factor, wanted in ((share, REPRODUCED), (1.4, NOT_REPRODUCED)):
        cuts = four()
        for run in cuts:
            number = (factor if run.case.grooves else 1.0) * (100 + run.seed)
            run.numbers.update(dict.fromkeys(names, number))
        assert verdict(rule, cuts) == wanted


@pytest.mark.parametrize(
    ("rule", "name"),
    [
        (damage.deep_cuts_damage_deeper, "damage_depth_most"),
        (damage.deep_cuts_have_larger_chips, "chip_area_largest"),
    ],
)
def test_depth_and_damage(rule, name):
    for factor, wanted in ((2.0, REPRODUCED), (0.5, NOT_REPRODUCED)):
        cuts = four(damage_depth=1.0)
        for run in cuts:
            run.numbers[name] = (factor if run.case.cut_depth > 0.15e-3 else 1.0) * (1 + 0.01 * run.seed)
        assert verdict(rule, cuts) == wanted


@pytest.mark.parametrize(("scale", "wanted"), [(2.5, REPRODUCED), (1.1, NOT_REPRODUCED)])
def test_trapezoids(scale, wanted):
    shaped = [cut(0.2, True, seed + 1, scale * one, {"bottom_ratio": 0.5}) for seed, one in enumerate(SCATTER)]
    assert verdict(damage.trapezoids_explain_the_thrust, four() + shaped) == wanted
    assert verdict(damage.trapezoids_explain_the_thrust, four()) == NOT_TESTED


@pytest.mark.parametrize(("scale", "wanted"), [(1.0, REPRODUCED), (1.4, NOT_REPRODUCED)])
def test_properties(scale, wanted):
    other = {"joint.modulus": "80 GPa"}
    for joint, reference in (({}, "model"), (other, "glass")):
        runs = {"dem_tension": [], "dem_compression": []}
        for kind, some in runs.items():
            for seed, one in enumerate(SCATTER, 1):
                known = {row.variable: scale * one * getattr(row, reference) for row in TABLE_2 if row.kind == kind}
                some.append(specimen(kind, seed, joint, **known))
        found = glass(tension=runs["dem_tension"], compression=runs["dem_compression"])
        rules = [material.printed_gives(row) for row in TABLE_2] if not joint else [material.calibration_reaches_glass]
        assert {rule(found).verdict for rule in rules} == {wanted}


@pytest.mark.parametrize(("tension", "wanted"), [(3, REPRODUCED), (0, NOT_REPRODUCED)])
def test_both_kinds_of_cracks(tension, wanted):
    numbers = {"cracks_tension_total": tension, "cracks_shear_total": 9}
    found = glass(four(**numbers), [specimen(**numbers)], [])
    assert material.both_kinds_of_cracks(found).verdict == wanted


def test_damping_and_time_step_are_no_part_of_the_material():
    printed, other = ({"joint.damping": 0.3, "joint.time_step_factor": 0.2}, {"joint.cohesion": "112 MPa"})
    assert as_printed(make_case("dem_cutting", **printed).joint)
    assert not as_printed(make_case("dem_cutting", **other).joint)


def test_usual_cuts_leave_out_other_numerics_and_conditions_other_grooves():
    fast = GlassRun(make_case("dem_cutting", cut_speed="2 m/s"), {})
    shaped = cut(0.2, True, 1, 1.0, {"distance": "0.14 mm"})
    cuts = [*four(), fast, shaped]
    assert fast not in usual(cuts)
    assert shaped in usual(cuts)
    assert sum(map(len, conditions(cuts).values())) == 24


def test_series_differ_in_one_field_and_the_seed():
    speeds = []
    for speed, seed in itertools.product((2, 1), (1, 2, 3)):
        case = make_case("dem_cutting", cut_speed=f"{speed} m/s", **{"packing.seed": seed})
        speeds.append(GlassRun(case, {"force_cutting_mean": 5.0 + speed + seed}))
    (group,) = along(speeds, "cut_speed")
    assert list(group) == [1.0, 2.0]
    assert [len(runs) for runs in group.values()] == [3, 3]
    change = changes(group[2.0], group[1.0], "force_cutting")
    assert change.mean == pytest.approx(1 / 8)
    assert change.half == pytest.approx(4.303 * 0.125 / 8 / math.sqrt(3), rel=1e-3)
    assert along(speeds, "joint_damping") == []


def test_condensed_runs_keep_means_of_parts_and_tell_of_peaks():
    run = dem_cut_run(**BIG)
    history = np.zeros(200)
    history[100:110] = 8e3
    history[150:160] = 8e3
    run["force_cutting"][:] = history
    (found,) = cuts_of(collect([condense(run)], dims=("sample",)))
    assert found.parts["force_cutting"] == pytest.approx([0, 0, 0, 0, 3.2, 0, 3.2, 0])
    assert len(found.parts["force_thrust"]) == PARTS
    assert early([found], "force_cutting") == [pytest.approx(3.2 / 6)]
    assert found["force_cutting_excursions"] == 2
    assert found["force_cutting_variation"] == pytest.approx(3.0)
    assert found["force_cutting_mean"] == pytest.approx(1e-3 * float(run.force_cutting_mean))


def test_claims_are_judged_from_datasets_too():
    runs = [condense(dem_cut_run(cracks=8, **BIG, **{"packing.seed": seed})) for seed in (1, 2, 3)]
    tests = [condense(dem_test_run(kind, cracks=8, **BIG)) for kind in ("dem_tension", "dem_compression")]
    found = glass_of(collect([*runs, *tests], dims=("sample",)))
    assert [len(some) for some in (found.cuts, found.tension, found.compression)] == [3, 1, 1]
    table = registry.tabulate("yang2018_claims", collect([*runs, *tests], dims=("sample",)))
    verdicts = {row[0]: row[5] for row in table.rows}
    assert verdicts["cracks in tension and in shear"] == REPRODUCED
    assert verdicts["mean main force, 0.2 mm regular"] == NOT_TESTED
