import math

import pytest
from scipy.integrate import quad

from orthocut.params.cohesive import CohesiveZone
from orthocut.params.material import ElasticPlastic
from orthocut.params.tool import Tool
from orthocut.theory import beam, bending

INTERFACE = CohesiveZone()


def material(tangent=0.0, stress_yield=25.0):
    return ElasticPlastic(modulus_tangent=f"{tangent} MPa", stress_yield=f"{stress_yield} MPa")


def tool(rake=30, friction=0.0):
    return Tool(rake_angle=f"{rake} deg", friction=friction)


@pytest.mark.parametrize("rubbing", [0.0, 1000.0])
@pytest.mark.parametrize(("form", "share"), [("paper", 0.0), ("consistent", 1.0)])
@pytest.mark.parametrize("tangent", [0.0, 25.0, 100.0])
@pytest.mark.parametrize(("rake", "friction", "depth"), [(15, 0.0, 0.2e-3), (30, 0.3, 0.9e-3), (45, 0.5, 6e-3)])
def test_both_balances_close_with_areas_by_integration(rake, friction, depth, tangent, form, share, rubbing):
    """Eqs (16) and (17), with A1 and A2 integrated from M(k); the consistent form balances the chip alone."""
    solid, wedge = material(tangent), tool(rake, friction)
    found = bending.solve(solid, INTERFACE, wedge, depth, rubbing, form=form)
    k, r = found.curvature_ratio, bending.slope_ratio(solid)
    elastic = quad(lambda x: float(beam.moment(x, r)), 0, min(k, 1.0), epsrel=1e-12)[0]
    plastic = quad(lambda x: float(beam.moment(x, r)), 1.0, max(k, 1.0), epsrel=1e-12, limit=200)[0]
    top = float(beam.moment(k, r))
    unit = found.depth_dimensionless
    released = unit * (top * k - elastic - plastic)
    dissipated = unit * (elastic + plastic - top**2 * 3 / 4)
    along = found.force_over_toughness - share * friction * rubbing / 2000.0
    across = found.thrust_over_toughness - share * rubbing / 2000.0
    alpha = math.radians(rake)

    assert along * (1 - math.sin(alpha)) - across * math.cos(alpha) == pytest.approx(1 + dissipated, rel=1e-8)
    turned = 2 * bending.ROOT_ROTATION * 25e6 * k / solid.modulus_plane_strain
    assert across * turned == pytest.approx(released - 1, rel=1e-7)


def test_an_elastic_chip_needs_only_the_toughness():
    found = bending.solve(material(stress_yield=20000.0), INTERFACE, tool(30), 1e-3)
    assert found.curvature_ratio < 1
    assert found.force_over_toughness == pytest.approx(1.0, rel=1e-12)
    assert found.force_thrust == pytest.approx(-found.force_cutting * math.tan(math.radians(30)), rel=1e-12)


def test_without_rubbing_both_forms_agree():
    forms = [bending.solve(material(), INTERFACE, tool(30, 0.2), 1e-3, form=form) for form in bending.FORMS]
    assert forms[0].force_cutting == pytest.approx(forms[1].force_cutting, rel=1e-12)


def test_consistent_frictionless_force_does_not_depend_on_rubbing_but_the_papers_does():
    def force(form, rubbing):
        return bending.solve(material(), INTERFACE, tool(30), 2.1e-3, rubbing, form=form).force_over_toughness

    assert force("consistent", 2000.0) == pytest.approx(force("consistent", 0.0), rel=1e-12)
    assert force("paper", 2000.0) > force("paper", 0.0) + 1


def test_literal_slope_is_steeper():
    solid = material(100.0)
    assert bending.slope_ratio(solid) == pytest.approx(0.0891070, rel=1e-5)
    assert bending.slope_ratio(solid, "literal") == pytest.approx(0.0990067, rel=1e-5)


@pytest.mark.parametrize(
    ("wedge", "options", "reason"),
    [
        (tool(30, 0.6), {}, "Z >= 0"),
        (tool(-15, 0.0), {}, "Z >= 0"),
        (tool(30), {"root_rotation": 0.0}, "never reaches the toughness"),
    ],
)
def test_no_solution_is_said(wedge, options, reason):
    found = bending.solve(material(), INTERFACE, wedge, 1e-3, **options)
    assert found.reason
    assert math.isnan(found.force_cutting)
    assert math.isnan(found.curvature_ratio)
    assert reason in found.reason


@pytest.mark.parametrize("law", ["ludwik", "voce", "none"])
def test_other_hardening_than_linear_is_refused(law):
    solid = ElasticPlastic(hardening=law)
    assert "linear hardening only" in bending.solve(solid, INTERFACE, tool(30), 1e-3).reason
    with pytest.raises(ValueError, match="must be linear"):
        bending.slope_ratio(solid)


def test_a_rigid_root_bends_where_the_chip_hardens():
    found = bending.solve(material(100.0), INTERFACE, tool(30), 1e-3, root_rotation=0.0)
    released = found.depth_dimensionless * beam.area_complementary(
        found.curvature_ratio, bending.slope_ratio(material(100.0))
    )
    assert released == pytest.approx(1.0, rel=1e-10)


@pytest.mark.parametrize("options", [{"form": "other"}, {"slope": "other"}])
def test_unknown_options_are_refused(options):
    with pytest.raises(ValueError, match="must be one of"):
        bending.solve(material(), INTERFACE, tool(30), 1e-3, **options)
