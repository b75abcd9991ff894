"""Cuts whose force is known: elastic ones and those that shear the whole chip (T13, T14, T15, T16)."""

import numpy as np
import pytest
from bodies import Bodies, rectangle

from orthocut.experiments.mpm_cutting import simulate
from orthocut.params.case import load
from orthocut.theory import touching

SHORT = {"travel_ratio": 7.0, "window_ratio": 4.0, "length_ratio": 11.0, "modulus_tangent": "0 MPa"}
ELASTIC = {"stress_yield": "100 GPa", "modulus_tangent": "0 MPa"}
LONG = {"travel_ratio": 15.0, "window_ratio": 8.0, "length_ratio": 21.0, "failure_criterion": "coupled"}


def energies_of_travel(run):
    """Changes of all histories over the last two fifths of a run, over the travel of the tool."""
    late = slice(300, None)
    histories = [name for name in run.data_vars if run[name].dims == ("sample",)]
    change = {name: float(run[name][late][-1] - run[name][late][0]) for name in histories}
    return {name: value / change["tool_travel"] for name, value in change.items()}


@pytest.fixture(scope="module")
def elastic():
    """Elastic cuts by law of failure and points through the chip, each run once."""
    runs = {}

    def get(failure, count):
        if (failure, count) not in runs:
            case = load("mpm", {**ELASTIC, "failure_criterion": failure, "points_per_depth": count})
            runs[failure, count] = simulate(case, snapshots=0)
        return runs[failure, count]

    return get


def check_balance(run):
    """The balance closes to 2.5 % of the toughness, and the crack costs the toughness: the excess is in transfers."""
    rate = energies_of_travel(run)
    lost = rate["energy_numerical"] + rate["energy_contact"]
    stored = rate["energy_elastic"] + rate["energy_kinetic"]
    excess = float(run.force_cutting_mean) / 2000.0 - 1
    print(
        f"force {1 + excess:.3f} Gc; per travel: crack {rate['energy_cohesive'] / 2000:.3f}, transfers and contact "
        f"{lost / 2000:.3f}, stored {stored / 2000:.3f}, unknown {rate['energy_residual'] / 2000:.4f} Gc"
    )
    assert abs(rate["energy_residual"]) < 0.025 * 2000.0
    advance = -np.polyfit(run.tool_travel.values[300:], run.crack_tip.values[300:], 1)[0]
    toughness = np.polyfit(run.tool_travel.values[300:], run.energy_cohesive.values[300:], 1)[0] / advance
    print(f"crack advances {advance:.3f} of the travel and costs {toughness / 2000:.3f} Gc")
    assert toughness == pytest.approx(2000.0, rel=0.04)
    assert rate["energy_plastic"] == 0.0


def test_elastic_cut_without_jumps_of_traction_costs_the_toughness(elastic):
    """Exact: Fc = Gc, by energy, for any rake angle, without friction; 6 % at 8 points, before steady state."""
    run = elastic("coupled", 8)
    check_balance(run)
    assert float(run.force_cutting_mean) == pytest.approx(2000.0, rel=0.06)


def test_support_lowers_the_excess_of_a_long_elastic_cut():
    """Exact: Fc = Gc and, for a chip that leaves at the speed v of the tool, rho h v^2/2 = 0.0056 Gc.

    A travel of eleven depths ends before the chip is steady. What is above is lost at nodes of little mass, where the
    tractions lift the surface of the base out of its row of nodes and where the bent chip crosses cells.
    """
    force = {}
    for support in (0.05, 0.25):
        run = simulate(load("mpm", {**ELASTIC, **LONG, "points_per_depth": 8, "support": support}), snapshots=0)
        check_balance(run)
        force[support] = float(run.force_cutting_mean) / 2000.0 - 0.0056
    assert 1.03 < force[0.05] < 1.09
    assert force[0.25] == pytest.approx(1.0, abs=0.045)
    assert force[0.25] < force[0.05] - 0.02


def test_excess_of_an_elastic_cut_with_the_area_criterion_is_found_in_the_balance(elastic):
    """The jump of the traction at mixed-mode failure frees energy: more than the toughness, by less than a quarter."""
    for count in (5, 8):
        run = elastic("area", count)
        check_balance(run)
        assert 1.0 < float(run.force_cutting_mean) / 2000.0 < {5: 1.32, 8: 1.25}[count]


@pytest.mark.xfail(strict=True, reason="tractions that jump to zero in mixed mode free energy that transfers take")
def test_elastic_cut_with_the_area_criterion_costs_the_toughness(elastic):
    """Exact: Fc = Gc; the area criterion of eq (4) breaks pairs that still carry traction."""
    assert float(elastic("area", 8).force_cutting_mean) == pytest.approx(2000.0, rel=0.06)


@pytest.fixture(scope="module")
def plastic():
    """Force of perfectly plastic cuts over that of eq (15), and the run; each run once."""
    runs = {}

    def get(depth="0.5 mm", rake=30, count=8, courant=0.5):
        key = depth, rake, count, courant
        if key not in runs:
            chosen = {"cut_depth": depth, "rake_angle": f"{rake} deg", "points_per_depth": count, "courant": courant}
            case = load("mpm", {**SHORT, **chosen})
            run = simulate(case, snapshots=0)
            theory = touching.solve(case.material, case.interface, case.tool, case.cut_depth)
            runs[key] = float(run.force_cutting_mean) / theory.force_cutting, run
            print(f"{depth}, rake {rake}, {count} points, Courant {courant}: {runs[key][0]:.3f} of eq (15)")
        return runs[key]

    return get


ABOVE = "15 % above eq (15) at 8 points; cause not isolated, a fifth of the crack's energy is mode II"
BELOW = "13 % below eq (15), which is an upper bound; cause not isolated, near the change to bending"


@pytest.mark.parametrize(
    ("depth", "rake"),
    [
        ("1 mm", 15),
        ("0.5 mm", 30),
        ("0.5 mm", 45),
        pytest.param("0.5 mm", 15, marks=pytest.mark.xfail(strict=True, reason=ABOVE)),
        pytest.param("1 mm", 45, marks=pytest.mark.xfail(strict=True, reason=BELOW)),
    ],
)
def test_touching_force_at_other_rake_angles_is_that_of_the_shear_plane(plastic, depth, rake):
    """Nairn (2015), eq (15), without fit, within 10 %: the tool stays at the crack tip and the chip shears."""
    ratio, run = plastic(depth, rake)
    assert float(run.touching) == 1.0
    assert ratio == pytest.approx(1.0, abs=0.1)


def test_touching_force_does_not_hang_on_resolution_or_time_step(plastic):
    """At 5, 6 and 8 points through the chip, and with half the time step at 5, all within 7 % of eq (15)."""
    found = [plastic(count=count)[0] for count in (5, 6, 8)]
    found.append(plastic(count=5, courant=0.25)[0])
    assert np.abs(np.array(found) - 1).max() < 0.07
    assert np.ptp(found) < 0.08


def test_energy_of_a_touching_cut_is_accounted_for(plastic):
    """Half a per cent of the tool's work is unknown at most, 7 % goes to transfers, most is plastic."""
    for count in (5, 8):
        run = plastic(count=count)[1]
        work = float(run.work_tool[-1])
        share = {name: float(run[f"energy_{name}"][-1]) / work for name in ("plastic", "cohesive", "numerical")}
        print(f"{count} points: {share}, unknown {float(run.energy_closure):.1e}")
        assert abs(float(run.energy_closure)) < 5e-3
        assert abs(share["numerical"]) < 0.07
        assert share["plastic"] > 0.5


def test_transfers_give_no_energy_to_a_touching_cut(plastic):
    """Exact: what transfers take is not negative; without support it is 5 % of the work."""
    assert float(plastic()[1].energy_numerical[-1]) > 0.0


def test_chip_below_the_cut_is_noticed():
    """A chip is sunken once it reaches more than two cells below y = 0."""
    for low, sunken in ((0, False), (-1, False), (-4, True)):
        assert Bodies(rectangle(0, 4, low, low + 6, 1e-3)).sunken is sunken
