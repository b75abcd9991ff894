"""Whole cuts with material points: balances, regimes, repeatability."""

import math

import numpy as np
import pytest

from orthocut.experiments import mpm_cutting
from orthocut.experiments.mpm_cutting import simulate
from orthocut.measure.guard import Diverged
from orthocut.params.case import load
from orthocut.theory import touching

QUICK = {"points_per_depth": 8}


@pytest.fixture(scope="module")
def hardening():
    """Cut of the hardening material in the bending regime, coarser than the quick study."""
    return simulate(load("mpm", {"points_per_depth": 6}))


def test_energy_of_the_tool_is_accounted_for(hardening):
    """The balance closes to half a per cent at every travel beyond one depth of cut, not only at the end."""
    residual = hardening.energy_residual / hardening.work_tool
    late = hardening.tool_travel > 1.0 * 0.9e-3
    worst = float(abs(residual[late]).max())
    print(f"energy closure: {float(hardening.energy_closure):+.1e} of the work at the end, at worst {worst:.1e}")
    assert worst < 5e-3
    parts = [name for name in hardening.data_vars if str(name).startswith("energy_") and hardening[name].ndim == 1]
    assert {"energy_plastic", "energy_cohesive", "energy_elastic", "energy_numerical"} <= set(parts)
    assert float(hardening.energy_plastic[-1]) > 0.3 * float(hardening.work_tool[-1])


def test_affine_transfers_waste_less_and_agree_with_finer_points():
    """At 8 points through the chip: half of the losses are gone, and the force is nearer to that of 12 points."""
    runs = {
        (count, affine): simulate(load("mpm", {"points_per_depth": count, "affine": affine}))
        for count, affine in ((8, 0.0), (8, 0.9), (12, 0.9))
    }
    wasted = {key: float(run.energy_numerical[-1] / run.work_tool[-1]) for key, run in runs.items()}
    force = {key: float(run.force_cutting_mean) for key, run in runs.items()}
    print(f"share of the work lost in transfers: {wasted}; forces [N/m]: {force}")
    assert wasted[8, 0.9] < 0.5 * wasted[8, 0.0]
    assert wasted[12, 0.9] < wasted[8, 0.9]
    assert abs(force[8, 0.9] - force[12, 0.9]) < 0.5 * abs(force[8, 0.0] - force[12, 0.9])


def test_momentum_is_that_of_tool_and_clamp(hardening):
    """In the steady state the clamp carries what the tool applies, up to the momentum that the chip takes along."""
    steady = hardening.tool_travel > 6 * 0.9e-3
    for direction in ("cutting", "thrust"):
        force = hardening[f"force_{direction}"][steady].mean()
        reaction = hardening[f"reaction_{direction}"][steady].mean()
        assert float(reaction) == pytest.approx(-float(force), abs=0.02 * float(hardening.force_cutting_mean))


def test_frictionless_chip_pushes_along_the_normal_of_the_rake_face(hardening):
    loaded = hardening.force_cutting_chip > 100.0
    ratio = (hardening.force_thrust_chip / hardening.force_cutting_chip)[loaded]
    np.testing.assert_allclose(ratio, -math.tan(math.radians(30)), rtol=1e-10)


def test_cohesive_work_is_the_toughness_times_the_crack(hardening):
    window = slice(250, None)
    work = float(hardening.energy_cohesive[window][-1] - hardening.energy_cohesive[window][0])
    advance = float(hardening.crack_tip[window][0] - hardening.crack_tip[window][-1])
    assert work / advance == pytest.approx(2000.0, rel=0.05)
    assert 0.7 < float(hardening.mode_one_fraction) < 1.0


def test_hardening_chip_bends_ahead_of_the_tool(hardening):
    assert float(hardening.touching) == 0.0
    assert float(hardening.crack_gap_mean) > 0.5 * 0.9e-3


def test_particles_fill_space(hardening):
    """Neighbours along the chip stay as far apart as their deformation gradients say."""
    last = hardening.isel(snapshot=-1)
    x, y = last.point_x.values, last.point_y.values
    first = hardening.isel(snapshot=0)
    spacing = 2 * float(hardening.point_half_width)
    column = np.round(first.point_x.values / spacing - 0.5).astype(int)
    row = np.round(first.point_y.values / spacing - 0.5).astype(int)
    place = {(i, j): p for p, (i, j) in enumerate(zip(column, row, strict=True))}
    chip = [(p, place[i + 1, j]) for (i, j), p in place.items() if j >= 0 and 20 < i < 80 and (i + 1, j) in place]
    a, b = np.array(chip).T
    gradient = last.point_deformation.values.reshape(-1, 2, 2)
    expected = 0.5 * (gradient[a] + gradient[b])[:, :, 0] * spacing
    actual = np.stack([x[b] - x[a], y[b] - y[a]], axis=-1)
    mismatch = np.linalg.norm(actual - expected, axis=1).mean() / spacing
    assert mismatch < 0.02


@pytest.mark.parametrize("depth", ["0.5 mm", "1 mm"])
def test_touching_force_is_that_of_the_shear_plane(depth):
    """Perfectly plastic, frictionless, rake angle 30 degrees: within 10 % of Nairn (2015), eq (15)."""
    case = load("mpm", {"cut_depth": depth, "modulus_tangent": "0 MPa", **QUICK})
    result = simulate(case)
    theory = touching.solve(case.material, case.interface, case.tool, case.cut_depth)
    assert float(result.touching) == 1.0
    assert float(result.force_cutting_mean) == pytest.approx(theory.force_cutting, rel=0.1)


SHORT = {"points_per_depth": 4, "length_ratio": 8.0, "travel_ratio": 4.0, "window_ratio": 2.0}


def test_repeat_gives_the_same_bits():
    first, second = (simulate(load("mpm", SHORT)) for _ in range(2))
    for name in first.variables:
        np.testing.assert_array_equal(first[name].values, second[name].values, err_msg=str(name))


def test_friction_is_paid_for():
    smooth, rough = (simulate(load("mpm", {**SHORT, "tool.friction": friction})) for friction in (0.0, 0.3))
    assert float(smooth.energy_friction[-1]) == pytest.approx(0.0, abs=1e-9)
    assert float(rough.energy_friction[-1]) > 0.02 * float(rough.work_tool[-1])
    assert float(rough.force_cutting_mean) > float(smooth.force_cutting_mean)
    assert abs(float(rough.energy_closure)) < 0.01


def test_progress_rises_to_one():
    seen = []
    simulate(load("mpm", SHORT), seen.append)
    assert seen[-1] == 1.0
    assert seen == sorted(seen)


def test_unstable_time_step_is_diagnosed():
    with pytest.raises(Diverged, match="courant"):
        simulate(load("mpm", {**SHORT, "courant": 1.0}))


def test_negative_rake_angle_cuts_to_the_end_with_the_chip_above_the_base():
    """A tool at -15 degrees presses the chip down; failed pairs keep it above the cut, to less than a cell."""
    case = load("mpm", {**SHORT, "points_per_depth": 6, "rake_angle": "-15 deg", "modulus_tangent": "0 MPa"})
    run = simulate(case)
    theory = touching.solve(case.material, case.interface, case.tool, case.cut_depth)
    chip = 6 * round(8.0 * 6)
    lowest = float(run.point_y[:, :chip].min()) / run.attrs["cell_m"]
    force, closure = float(run.force_cutting_mean), float(run.energy_closure)
    print(f"force {force:.0f} N/m, lowest point of the chip at {lowest:.2f} cells, closure {closure:.1e}")
    assert float(run.tool_travel[-1]) == pytest.approx(4.0 * 0.9e-3, rel=1e-3)
    assert 0.8 < force / theory.force_cutting < 1.4
    assert lowest > -1.0
    assert abs(closure) < 5e-3


@pytest.mark.parametrize("speed", ["5 m/s", "1 m/s"])
def test_thin_cut_takes_hardly_any_energy_from_contact_and_transfers(speed):
    """A plastic cut of 0.1 mm at 15 degrees: material ploughed up between chip and tool touches both for many steps.

    With loose nodes that follow the firm ones as if there were no contact, 9 % of the work comes from nowhere at
    5 m/s, and at 1 m/s the plastic work is one and a half times the work of the tool. A few hundredths are left to
    nodes that tool and closed pairs push at once, one after the other; with rows of nodes above the cut there are more
    of these, and the cut at 1 m/s stops.
    """
    thin = {"cut_depth": "0.1 mm", "rake_angle": "15 deg", "modulus_tangent": "0 MPa", "points_per_depth": 6}
    thin["grid_offset"] = 0.0
    run = simulate(load("mpm", {**thin, "cut_speed": speed}), snapshots=1)
    work = float(run.work_tool[-1])
    names = ("numerical", "contact", "plastic", "cohesive")
    share = {name: float(run[f"energy_{name}"][-1]) / work for name in names}
    print(f"{speed}: shares of the work {share}, closure {float(run.energy_closure):.1e}")
    assert -0.05 < share["numerical"] + share["contact"] < 0.15
    assert share["plastic"] + share["cohesive"] < 1.05


def test_stiff_interface_shortens_the_time_step():
    soft, stiff = load("mpm", SHORT), load("mpm", {**SHORT, "strength": "400 MPa", "affine": 0.0})
    assert stiff.time_step < 0.2 * soft.time_step
    assert abs(float(simulate(stiff).energy_closure)) < 0.05


def test_tool_travels_as_far_as_the_case_says_however_often_it_is_sampled(monkeypatch):
    case = load("mpm", {**SHORT, "travel_ratio": 1.3, "window_ratio": 0.5})
    many = simulate(case)
    assert float(many.tool_travel[-1]) == pytest.approx(1.3 * case.cut_depth, abs=case.cut_speed * case.time_step)
    assert float(many.time[-1]) == pytest.approx(case.duration, rel=1e-9)
    monkeypatch.setattr(mpm_cutting, "SAMPLES", 120)
    few = simulate(case)
    for name in ("point_x", "point_y", "point_stress"):
        np.testing.assert_array_equal(few[name][-1], many[name][-1])
    assert float(few.work_tool[-1]) == float(many.work_tool[-1])
