import math

import pytest
from scipy.optimize import minimize_scalar

from orthocut.params.cohesive import CohesiveZone
from orthocut.params.material import ElasticPlastic
from orthocut.params.tool import Tool
from orthocut.theory import touching

MATERIAL, INTERFACE = ElasticPlastic(modulus_tangent="0 MPa"), CohesiveZone()


def tool(rake, friction):
    return Tool(rake_angle=f"{rake} deg", friction=friction)


@pytest.mark.parametrize("criterion", ["mises", "tresca"])
@pytest.mark.parametrize("rubbing", [0.0, 1500.0])
@pytest.mark.parametrize(("rake", "friction"), [(30, 0.0), (30, 0.3), (30, 0.6), (10, 0.2), (60, 0.4), (-15, 0.1)])
@pytest.mark.parametrize("depth", [0.1e-3, 0.9e-3, 5e-3])
def test_force_is_the_least_over_all_shear_planes(depth, rake, friction, rubbing, criterion):
    found = touching.solve(MATERIAL, INTERFACE, tool(rake, friction), depth, rubbing, criterion)
    arguments = (depth, math.radians(rake), friction, 25e6, 2000.0, rubbing, criterion)
    least = minimize_scalar(
        touching.force_of_angle,
        bounds=(0.2, min(1.3, math.radians(85 + rake))),
        args=arguments,
        method="bounded",
        options={"xatol": 1e-10},
    )
    assert found.force_cutting == pytest.approx(least.fun, rel=1e-9)
    assert found.angle_shear == pytest.approx(least.x, abs=1e-5)


def test_energy_balance_by_hand():
    """Work of the tool equals plastic work, sliding on the rake, rubbing and fracture: eq. (13) with forces of (11)."""
    rake, friction, rubbing, depth = math.radians(20), 0.25, 800.0, 1.5e-3
    found = touching.solve(MATERIAL, INTERFACE, tool(20, friction), depth, rubbing)
    shear = found.angle_shear
    along = found.force_cutting - friction * rubbing
    across = found.force_thrust - rubbing
    sliding = along * math.sin(rake) + across * math.cos(rake)
    pressing = along * math.cos(rake) - across * math.sin(rake)
    strain = 1 / math.tan(shear) + math.tan(shear - rake)
    work = 25e6 / math.sqrt(3) * strain * depth + sliding * math.sin(shear) / math.cos(shear - rake)

    assert sliding == pytest.approx(friction * pressing, rel=1e-12)
    assert found.force_cutting == pytest.approx(work + friction * rubbing + 2000.0, rel=1e-12)


def test_without_toughness_it_is_merchants_angle():
    angle = touching.force_cutting(1e-3, math.radians(10), 0.2, 25e6, 0.0)[1]
    assert angle == pytest.approx(math.pi / 4 - (math.atan(0.2) - math.radians(10)) / 2, rel=1e-12)


def test_frictionless_force_does_not_depend_on_rubbing():
    forces = [touching.solve(MATERIAL, INTERFACE, tool(30, 0.0), 1e-3, f).force_cutting for f in (0.0, 1000.0)]
    assert forces[0] == forces[1]


def test_a_chip_that_cannot_slide_has_no_solution():
    found = touching.solve(MATERIAL, INTERFACE, tool(-45, 1.2), 1e-3)
    assert found.reason
    assert math.isnan(found.force_cutting)
    assert "cannot slide" in found.reason


def test_an_elastic_chip_has_no_solution():
    found = touching.solve(ElasticPlastic(hardening="none"), INTERFACE, tool(30, 0.0), 1e-3)
    assert "never yields" in found.reason


@pytest.mark.parametrize("depth", [0.0, -1e-3, math.nan])
def test_a_depth_that_is_not_positive_is_refused(depth):
    with pytest.raises(ValueError, match="cut_depth"):
        touching.solve(MATERIAL, INTERFACE, tool(30, 0.0), depth)


def test_unknown_criterion_is_refused():
    with pytest.raises(ValueError, match="mises, tresca"):
        touching.solve(MATERIAL, INTERFACE, tool(30, 0.0), 1e-3, criterion="coulomb")
