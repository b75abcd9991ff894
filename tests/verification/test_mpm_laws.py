"""Short cuts with every hardening law, cohesive law and criterion of failure: energies balance, limits agree."""

import pytest

from orthocut.params.case import load
from orthocut.run import run_case

SHORT = {
    "points_per_depth": 5,
    "travel_ratio": 4.0,
    "window_ratio": 2.0,
    "window": "fixed",
    "length_ratio": 8.0,
    "notch_ratio": 1.0,
}


def cut(**values):
    return run_case(load("mpm", {**SHORT, **values}), snapshots=0)


@pytest.fixture(scope="module")
def default():
    return cut()


@pytest.mark.parametrize(
    "values",
    [
        {"hardening": "ludwik", "law": "triangular"},
        {"hardening": "voce", "failure_criterion": "dissipated"},
        {"hardening": "none", "law": "triangular", "failure_criterion": "coupled"},
    ],
    ids=lambda values: "-".join(values.values()),
)
def test_energy_balances(values):
    run = cut(**values)
    assert abs(float(run["energy_closure"])) < 0.01
    assert (float(run["energy_plastic"][-1]) > 0.0) == (values["hardening"] != "none")
    assert float(run["work_tool"][-1]) > float(run["energy_cohesive"][-1]) > 0.0


def test_ludwik_with_exponent_one_is_linear_hardening(default):
    slope = load("mpm").material.modulus_plastic
    run = cut(hardening="ludwik", hardening_exponent=1.0, hardening_modulus=f"{slope!r} Pa")
    for name in ("force_cutting_mean", "force_thrust_mean", "crack_gap_mean"):
        assert float(run[name]) == pytest.approx(float(default[name]), rel=0.03)


def test_voce_that_hardly_hardens_is_perfectly_plastic():
    voce = cut(hardening="voce", stress_saturation="25.001 MPa", strain_saturation=0.001)
    plain = cut(modulus_tangent="0 MPa")
    force = float(plain["force_cutting_mean"])
    assert float(voce["force_cutting_mean"]) == pytest.approx(force, rel=0.05)
    assert float(voce["force_thrust_mean"]) == pytest.approx(float(plain["force_thrust_mean"]), abs=0.05 * force)
    assert float(voce["crack_gap_mean"]) == pytest.approx(float(plain["crack_gap_mean"]), rel=0.05)


def test_force_by_criterion(default):
    """A mixed opening takes more than the toughness by dissipation; only coupled modes drop no traction at failure."""
    forces = {rule: float(cut(failure_criterion=rule)["force_cutting_mean"]) for rule in ("dissipated", "coupled")}
    area = float(default["force_cutting_mean"])
    assert forces["coupled"] < area < forces["dissipated"]
