"""Verdicts on the claims of Nairn (2015) follow from the cuts by rules, in both directions; none without cuts."""

import dataclasses
import math

import numpy as np
import pytest
from synthetic import failed, make_case, mpm_run

from orthocut.figures import nairn2015_rules_bending as bending
from orthocut.figures import nairn2015_rules_method as method
from orthocut.figures import nairn2015_rules_touching as touching
from orthocut.figures import nairn2015_rules_transition as transition
from orthocut.figures import nairn2015_rules_zone as zone
from orthocut.figures import registry
from orthocut.figures.claims import ARTEFACT, NOT_REPRODUCED, NOT_TESTED, REPRODUCED, UNDECIDED
from orthocut.figures.nairn2015_claims import CLAIMS
from orthocut.figures.nairn2015_cuts import Cut, at_zero_size, condense, cuts_of, hanging, usual
from orthocut.figures.nairn2015_finding import force_bending, force_touching
from orthocut.io.collect import collect

DEPTHS = (0.5, 1.0, 1.5, 2.0, 2.1, 3.0, 5.0)


def cut(depth=0.9, force=5.0, tangent=0, rake=30, **values):
    facts = {key: values.pop(key) for key in [*values] if key in {field.name for field in dataclasses.fields(Cut)}}
    case = make_case(
        "mpm_cutting", cut_depth=f"{depth} mm", modulus_tangent=f"{tangent} MPa", rake_angle=f"{rake} deg", **values
    )
    return Cut(case, force, **{"error": 0.01, "drift": 0.0, **facts})


def like(model, ratio, *cuts):
    """Cuts with the force of a model times a ratio."""
    return [dataclasses.replace(one, force=ratio * model(one)) for one in cuts]


def series(change, depths=DEPTHS, **values):
    """Cuts that touch up to a depth [mm] and bend beyond."""
    return [cut(depth, touching=depth <= change, **values) for depth in depths]


def verdict(rule, cuts):
    found = rule(cuts)
    return found.verdict if found else NOT_TESTED


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.rule.__name__)
def test_missing_cuts_are_not_tested(claim):
    assert claim.rule([cut(0.7, rake=33, tangent=1)]) is None


@pytest.mark.parametrize(("thick", "wanted"), [(5.02, REPRODUCED), (5.3, NOT_REPRODUCED)])
def test_base(thick, wanted):
    cuts = [cut(base_ratio=base, force=force) for base, force in ((1, 6.0), (3, 5.0), (4, 5.01), (6, thick))]
    assert verdict(method.force_does_not_depend_on_base, cuts) == wanted
    assert verdict(method.force_does_not_depend_on_base, cuts[:2]) == NOT_TESTED


def test_noise_of_base_is_that_of_repeats_with_other_time_steps():
    forces = {3: (5.0, 5.0, 5.02), 5: (5.01, 4.99, 5.0), 6: (5.2, 5.0, 5.1)}
    cuts = [
        cut(base_ratio=base, force=force, courant=courant, error=0.01)
        for base, some in forces.items()
        for force, courant in zip(some, (0.5, 0.49, 0.45), strict=True)
    ]
    found = method.force_does_not_depend_on_base(cuts)
    assert found.ours == "changes by 2.0% ± 1.1% from d = 5 to 6"
    assert found.verdict == UNDECIDED


@pytest.mark.parametrize(("slope", "wanted"), [(4.0, REPRODUCED), (0.0, NOT_REPRODUCED), (-4.0, NOT_REPRODUCED)])
def test_particle_size(slope, wanted):
    cuts = [cut(tangent=100, affine=0, points_per_depth=n, force=3 + slope / n) for n in (5, 8, 12)]
    assert verdict(method.force_declines_with_size, cuts) == wanted


@pytest.mark.parametrize(("pic", "wanted"), [(5.1, REPRODUCED), (5.6, NOT_REPRODUCED)])
def test_transfers(pic, wanted):
    cuts = [cut(affine=0, force=pic), cut(affine=0.9, force=5.0)]
    found = method.transfers_do_not_change_the_force(cuts)
    assert found.verdict == wanted
    assert found.error == pytest.approx(100 * (pic / 5 - 1))


@pytest.mark.parametrize(("flip", "wanted"), [(4.9, REPRODUCED), (4.2, NOT_REPRODUCED)])
def test_transfers_are_compared_with_flip_where_there_is_one(flip, wanted):
    theirs = {"scheme": "usavg", "affine": 0.0, "support": 0.0, "reach_ratio": 0.0}
    cuts = [cut(affine=0, force=5.0), cut(affine=0.9, force=5.0)]
    cuts += [cut(**theirs, flip=share, force=force) for share, force in ((0.0, 5.0), (0.5, 4.0), (0.9, flip))]
    found = method.transfers_do_not_change_the_force(cuts)
    assert found.verdict == wanted
    assert found.error == pytest.approx(100 * (5 / flip - 1))
    assert found.ours.startswith("PIC over 90% FLIP")


@pytest.mark.parametrize(("travel", "wanted"), [(5.0, REPRODUCED), (8.0, NOT_REPRODUCED), (math.nan, NOT_TESTED)])
def test_steady_start(travel, wanted):
    assert verdict(method.steady_from_four_ms, [cut(tangent=100, steady=travel)]) == wanted


@pytest.mark.parametrize(("ratio", "wanted"), [(1.05, REPRODUCED), (1.2, NOT_REPRODUCED)])
@pytest.mark.parametrize(
    ("rule", "friction"),
    [(touching.touching_agrees_without_friction, 0), (touching.touching_agrees_with_friction, 0.3)],
)
def test_touching_forces(rule, friction, ratio, wanted):
    cuts = [cut(depth, touching=True, friction=friction, rubbing=0.5) for depth in (0.5, 1, 2)]
    assert verdict(rule, like(force_touching, ratio, *cuts)) == wanted


def test_one_bad_touching_cut_is_enough_and_is_named():
    good = like(force_touching, 1.0, *series(9, (0.5, 1, 1.5)))
    found = touching.touching_agrees_without_friction([*good, *like(force_touching, 1.3, cut(2, touching=True))])
    assert found.verdict == NOT_REPRODUCED
    assert "largest +30.0% ± 0.1% at 2 mm and 30°" in found.evidence


def test_agreement_that_vanishes_with_particle_size_is_an_artefact():
    sizes = [like(force_touching, 1.6 - 4.8 / n, cut(touching=True, points_per_depth=n))[0] for n in (8, 12, 16)]
    usual_ones = like(force_touching, 1.0, *series(9, (0.5, 1, 1.5, 2), points_per_depth=8))
    assert verdict(touching.touching_agrees_without_friction, usual_ones + sizes) == ARTEFACT


def test_thin_cuts_touch_although_bending_needs_less():
    cuts = series(2.0)
    assert verdict(touching.thin_cuts_touch_against_the_lower_force, cuts) == REPRODUCED
    thin = cut(0.5, touching=True, rake=10, friction=0.17)
    assert force_bending(thin) > force_touching(thin)
    assert verdict(touching.thin_cuts_touch_against_the_lower_force, [*cuts, thin]) == NOT_REPRODUCED


@pytest.mark.parametrize(("slope", "wanted"), [(-1, REPRODUCED), (1, NOT_REPRODUCED)])
def test_mode_over_thrust_ratio(slope, wanted):
    cuts = [
        cut(depth, rake=rake, touching=True, mode_one=0.8 - slope * 0.3 * math.tan(math.radians(rake)))
        for depth in (0.5, 1)
        for rake in (15, 30, 45)
    ]
    assert verdict(touching.touching_mode_falls_with_thrust_ratio, cuts) == wanted
    assert verdict(touching.touching_mode_falls_with_thrust_ratio, cuts[:5]) == NOT_TESTED


@pytest.mark.parametrize(
    ("limit", "slope", "wanted"), [(2.05, -5, REPRODUCED), (1.55, -5, NOT_REPRODUCED), (1.0, 8.4, ARTEFACT)]
)
def test_transition_is_judged_at_zero_particle_size(limit, slope, wanted):
    """Two sizes with many depths, of which the finer one is the usual one, and two with a few around the transition."""
    depths = [0.1 * step for step in range(5, 32)]
    changes = {n: limit + slope / n for n in (5, 8, 12, 16)}
    near = {n: [depth for depth in depths if abs(depth - change) < 0.35] for n, change in changes.items()}
    cuts = [one for n in changes for one in series(changes[n], depths if n < 10 else near[n], points_per_depth=n)]
    found = transition.transition_at_thirty_degrees(cuts)
    assert found.verdict == wanted
    assert found.error == pytest.approx(100 * (limit / 2.05 - 1), abs=5)
    assert "mm at 8 points" in found.ours
    assert "mm at 5 points" in found.evidence


def test_transition_whose_limit_is_vague_is_judged_at_the_usual_resolution():
    wide = [one for n in (5, 6, 8) for one in series(0.5, (0.5, 3.5), points_per_depth=n)]
    wide += [cut(5, points_per_depth=n) for n in (5, 6, 8)]
    found = transition.transition_at_thirty_degrees(wide)
    assert "no limit at zero particle size is known to 15 %" in found.evidence
    assert "at zero size" not in found.ours


@pytest.mark.parametrize(("change", "wanted"), [(2.0, REPRODUCED), (1.0, NOT_REPRODUCED)])
def test_transition_depth(change, wanted):
    found = transition.transition_at_thirty_degrees(series(change))
    assert found.verdict == wanted
    low, high = change, DEPTHS[DEPTHS.index(change) + 1]
    assert found.error == pytest.approx(100 * (0.5 * (low + high) / 2.05 - 1))


def test_transition_names_what_a_long_notch_gives():
    bent = series(1.0, DEPTHS[:4], notch_ratio=8)
    assert "from a long notch 1-1.5 mm" in transition.transition_at_thirty_degrees(series(2.0) + bent).evidence


@pytest.mark.parametrize(
    ("changes", "wanted"),
    [
        ((1.0, 1.5, 9.0), REPRODUCED),
        ((1.0, 1.0, 2.0), REPRODUCED),
        ((1.0, 1.0, 1.0), NOT_REPRODUCED),
        ((1.5, 0.5, 3.0), NOT_REPRODUCED),
    ],
)
def test_friction_and_transition(changes, wanted):
    cuts = [one for mu, change in zip((0, 0.1, 0.3), changes, strict=True) for one in series(change, friction=mu)]
    assert verdict(transition.friction_moves_the_transition_deeper, cuts) == wanted


@pytest.mark.parametrize(("changes", "wanted"), [((2.0, 1.0, 0.0), REPRODUCED), ((1.0, 2.0, 2.1), NOT_REPRODUCED)])
def test_hardening_and_transition(changes, wanted):
    cuts = [one for et, change in zip((0, 25, 100), changes, strict=True) for one in series(change, tangent=et)]
    assert verdict(transition.hardening_moves_the_transition_thinner, cuts) == wanted


@pytest.mark.parametrize(("weak", "wanted"), [(1.0, REPRODUCED), (2.0, NOT_REPRODUCED)])
def test_cohesive_stress_and_transition(weak, wanted):
    cuts = series(2.0) + series(weak, strength="10 MPa")
    assert verdict(transition.weak_interface_moves_the_transition_thinner, cuts) == wanted


@pytest.mark.parametrize(
    ("plastic", "harder", "wanted"),
    [(4.0, 9.5, REPRODUCED), (4.0, 7.0, NOT_REPRODUCED), (9.5, 9.9, NOT_REPRODUCED)],
)
def test_drop(plastic, harder, wanted):
    cuts = [
        cut(depth, force, tangent)
        for tangent, after in ((0, plastic), (25, harder))
        for depth, force in ((1, 8.0), (2, 10.0), (2.1, after))
    ]
    assert verdict(transition.drop_vanishes_at_25_mpa, cuts) == wanted


def test_always_bending():
    cuts = series(0, tangent=100)
    assert verdict(transition.hard_cuts_always_bend, cuts) == REPRODUCED
    found = transition.hard_cuts_always_bend(series(0.5, tangent=100))
    assert found.verdict == NOT_REPRODUCED
    assert "touching: 0.5 mm and 30°" in found.evidence


@pytest.mark.parametrize(("ratio", "wanted"), [(1.5, REPRODUCED), (1.02, NOT_REPRODUCED), (2.5, NOT_REPRODUCED)])
def test_excess_over_bending(ratio, wanted):
    cuts = like(lambda one: force_bending(one, "paper"), ratio, *series(0, tangent=100, rubbing=0.3))
    assert verdict(bending.forces_exceed_bending_by_10_to_90_percent, cuts) == wanted


def test_excess_that_vanishes_with_particle_size_is_an_artefact():
    cuts = like(force_bending, 1.5, *series(0, tangent=100, points_per_depth=8))
    for limit, wanted in ((1.0, ARTEFACT), (1.3, REPRODUCED)):
        sizes = [
            like(force_bending, limit + (1.5 - limit) * 8 / n, cut(tangent=100, points_per_depth=n))[0]
            for n in (6, 8, 16)
        ]
        assert verdict(bending.forces_exceed_bending_by_10_to_90_percent, cuts + sizes) == wanted


@pytest.mark.parametrize(("deepest", "wanted"), [(4.1, REPRODUCED), (3.5, NOT_REPRODUCED)])
def test_peak(deepest, wanted):
    cuts = [cut(depth, force, 100) for depth, force in ((1, 3.0), (3, 4.0), (7, deepest))]
    assert verdict(bending.deep_cuts_have_no_peak, cuts) == wanted
    assert verdict(bending.deep_cuts_have_no_peak, cuts[:2]) == NOT_TESTED


@pytest.mark.parametrize(("steep", "wanted"), [(0.5, REPRODUCED), (0.1, NOT_REPRODUCED)])
def test_rubbing(steep, wanted):
    cuts = [
        cut(depth, rake=rake, rubbing=slope * depth)
        for rake, slope in ((15, 0.2), (30, 0.3), (45, steep))
        for depth in (2, 3, 5)
    ]
    assert verdict(bending.rubbing_grows_with_rake_and_depth, cuts) == wanted


@pytest.mark.parametrize(("strain", "wanted"), [(0.75, REPRODUCED), (0.4, NOT_REPRODUCED), (1.5, NOT_REPRODUCED)])
def test_shear_strain(strain, wanted):
    assert verdict(bending.shear_strain_reaches_80_percent, [cut(tangent=100, strain=strain), cut()]) == wanted


@pytest.mark.parametrize(("lowest", "wanted"), [(0.91, REPRODUCED), (0.85, NOT_REPRODUCED)])
def test_mode_in_bending(lowest, wanted):
    cuts = [cut(3, mode_one=0.95), cut(5, mode_one=lowest), cut(1, mode_one=0.3, touching=True)]
    assert verdict(zone.bending_is_mode_one, cuts) == wanted


@pytest.mark.parametrize(("fraction", "wanted"), [(0.77, REPRODUCED), (0.9, NOT_REPRODUCED)])
def test_mode_in_weak_bending(fraction, wanted):
    assert verdict(zone.weak_bending_is_75_percent_mode_one, [cut(3, strength="10 MPa", mode_one=fraction)]) == wanted


@pytest.mark.parametrize(("weak", "wanted"), [(1.1, REPRODUCED), (1.6, NOT_REPRODUCED)])
def test_fit_of_weak_bending(weak, wanted):
    cuts = like(force_bending, 1.4, cut(3)) + like(force_bending, weak, cut(3, strength="10 MPa"))
    assert verdict(zone.weak_interface_fits_bending_better, cuts) == wanted


def test_cohesive_law_is_not_tested_with_one_law():
    assert zone.law_changes_the_force(series(0, tangent=100)) is None


def test_usual_cuts_leave_out_other_schemes():
    cuts = [*series(2.0), cut(points_per_depth=20), cut(affine=0), cut(notch_ratio=8), cut(cut_speed="2 m/s")]
    assert usual(cuts) == cuts[: len(DEPTHS)]


def test_usual_cuts_are_the_finest_of_two_common_resolutions():
    coarse, fine = (series(2.0, points_per_depth=n) for n in (5, 8))
    assert usual([*coarse, cut(4, points_per_depth=5), *fine, *series(2.0, DEPTHS[:2], points_per_depth=12)]) == fine


@pytest.mark.parametrize(
    ("rule", "friction"),
    [(touching.touching_agrees_without_friction, 0), (touching.touching_agrees_with_friction, 0.3)],
)
@pytest.mark.parametrize(
    ("here", "limit", "wanted"),
    [(0.95, 1.05, REPRODUCED), (0.85, 1.05, REPRODUCED), (0.95, 1.2, ARTEFACT), (0.85, 1.2, NOT_REPRODUCED)],
)
def test_touching_forces_are_judged_at_zero_particle_size(rule, friction, here, limit, wanted):
    cuts = [
        like(force_touching, ratio, *series(9, (0.5, 1, 2), friction=friction, points_per_depth=n))
        for n, ratio in ((5, limit + (here - limit) * 8 / 5), (8, here))
    ]
    found = rule([one for group in cuts for one in group])
    assert found.verdict == wanted
    assert found.error == pytest.approx(100 * (limit - 1))
    assert f"3 touching cuts at 8 points against eq. ({15 - bool(friction)})" in found.evidence
    assert f"mean {here - 1:+.1%}" in found.evidence
    assert "median standard error of an extrapolation" in found.evidence


def test_cuts_whose_regime_hangs_on_resolution_have_no_limit():
    coarse, fine = series(1.0, points_per_depth=5), series(2.0, points_per_depth=8)
    assert [one.depth for one in hanging(coarse + fine)] == pytest.approx([1.5e-3, 2e-3])
    assert len(at_zero_size(coarse + fine)) == len(DEPTHS) - 2
    evidence = touching.touching_agrees_without_friction(coarse + fine).evidence
    assert "2 of the touching cuts bend at another resolution" in evidence


def test_limits_of_force_and_rubbing_take_the_straight_line():
    pair = [cut(points_per_depth=n, force=3 + 4 / n, rubbing=1 - 2 / n) for n in (5, 8)]
    one = at_zero_size(pair)[0]
    assert (one.points, one.force, one.rubbing) == (8, pytest.approx(3.0), pytest.approx(1.0))
    assert one.error == pytest.approx(math.hypot(0.0175 * 8 / 3, 0.019 * 5 / 3), rel=1e-6)


@pytest.mark.parametrize(("weak", "wanted"), [(1.1, REPRODUCED), (1.6, ARTEFACT)])
def test_fit_of_weak_bending_is_judged_at_zero_particle_size(weak, wanted):
    cuts = [
        one
        for n in (5, 8)
        for one in (
            *like(force_bending, 1.4, cut(3, points_per_depth=n)),
            *like(force_bending, weak + (1.2 - weak) * 8 / n, cut(3, strength="10 MPa", points_per_depth=n)),
        )
    ]
    assert verdict(zone.weak_interface_fits_bending_better, cuts) == wanted


@pytest.mark.parametrize(
    ("limit", "error", "wanted"),
    [(1.2, 0.01, REPRODUCED), (1.0, 0.0, ARTEFACT), (1.0, 0.1, UNDECIDED)],
)
def test_cohesive_law_is_judged_at_zero_particle_size(limit, error, wanted):
    cuts = [
        one
        for n in (5, 8)
        for one in (
            cut(3, 4.0, 100, points_per_depth=n, error=error),
            cut(3, 4.0 * (limit + (1.2 - limit) * 8 / n), 100, points_per_depth=n, law="triangular", error=error),
        )
    ]
    assert verdict(zone.law_changes_the_force, cuts) == wanted


@pytest.mark.parametrize(("limit", "wanted"), [(1.5, REPRODUCED), (0.9, ARTEFACT)])
def test_excess_over_bending_is_judged_at_zero_particle_size(limit, wanted):
    def printed(one):
        return force_bending(one, "paper")

    cuts = [
        one
        for n in (5, 8)
        for one in like(printed, limit + (1.5 - limit) * 8 / n, *series(0, tangent=100, points_per_depth=n))
    ]
    assert verdict(bending.forces_exceed_bending_by_10_to_90_percent, cuts) == wanted


def sheared(strain):
    run = mpm_run(snapshots=2, modulus_tangent="100 MPa", **{"numerics.points_per_depth": 3})
    run["point_deformation"][-1, :, :] = np.array([1.0, strain, 0.0, 1.0])
    return run


def test_condensed_runs_know_strain_and_steady_start_and_little_else():
    run = condense(sheared(0.8))
    assert float(run["strain_shear"]) == pytest.approx(0.8)
    assert 0 < float(run["steady_travel"]) < 6
    one = cuts_of(collect([run], dims=()))[0]
    assert one.strain == pytest.approx(0.8)
    assert one.steady == float(run["steady_travel"])


def test_a_cut_that_never_settles_has_no_steady_start():
    run = mpm_run(snapshots=0)
    run["force_cutting"][...] = np.linspace(0, 2e4, run.sizes["sample"])
    assert math.isnan(float(condense(run)["steady_travel"]))


def test_table_has_a_row_a_claim_and_names_figures_that_exist():
    runs = [mpm_run(snapshots=0, cut_depth=f"{h} mm", touching=int(h < 2.05), modulus_tangent="0 MPa") for h in DEPTHS]
    table = registry.tabulate("nairn2015_claims", collect([condense(run) for run in [*runs, failed(sheared(0.1))]]))
    assert [row[0] for row in table.rows] == [claim.text for claim in CLAIMS]
    assert table.header == ["claim", "source", "paper value", "ours", "error [%]", "verdict", "evidence"]
    rows = {row[0]: row for row in table.rows}
    assert rows["transition at 30°"][3] == "2-2.1 mm at 4 points"
    assert rows["transition at 30°"][5] == REPRODUCED
    assert rows["always bending at 100 MPa"][5:] == [NOT_TESTED, "runs are missing"]
    for row in table.rows:
        named = [word.strip(",;.") for word in row[-1].split() if word.startswith("nairn2015_")]
        assert set(named) <= set(registry.FIGURES)


def test_nothing_at_all_is_not_tested():
    table = registry.tabulate("nairn2015_claims", collect([]))
    assert {row[5] for row in table.rows} == {NOT_TESTED}
