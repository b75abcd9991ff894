"""Whole small tests and cuts: agreement of stresses, energy balance, cracks, identical bits, diverging runs."""

import hashlib
import os
import subprocess
import sys

import numpy as np
import pytest

from orthocut.dem.packing import PackedDiscs, pack
from orthocut.experiments import dem_compression, dem_cutting, dem_specimen, dem_tension
from orthocut.io.netcdf import read, write
from orthocut.kernels.dem.walls import wedge_distance
from orthocut.measure.guard import Diverged
from orthocut.params.case import load
from orthocut.variables import VARIABLES

SPECIMEN = {"packing.width": "0.25 mm", "packing.height": "0.5 mm", "grip_speed": "20 mm/s"}
BLOCK = {"packing.width": "0.4 mm", "packing.height": "0.3 mm", "cut_depth": "0.06 mm", "travel": "0.06 mm"}
EXPERIMENTS = {"dem_tension": dem_tension, "dem_compression": dem_compression, "dem_cutting": dem_cutting}


def simulate(kind, **values):
    return EXPERIMENTS[kind].simulate(load(kind, values), lambda fraction: None)


def simulate_unstable(kind, **values):
    """Run with a step that a case may not ask for."""
    case = load(kind, values)
    joint = case.joint.model_copy(update={"time_step_factor": 1.0})
    return EXPERIMENTS[kind].simulate(case.model_copy(update={"joint": joint}), lambda fraction: None)


@pytest.fixture(scope="module")
def tension():
    return simulate("dem_tension", **SPECIMEN)


@pytest.fixture(scope="module")
def compression():
    return simulate("dem_compression", **SPECIMEN, strain_max=0.008)


@pytest.fixture(scope="module")
def cut():
    return simulate("dem_cutting", **BLOCK)


def test_every_variable_stands_in_the_table_and_survives_a_file(tension, compression, cut, tmp_path):
    for run in (tension, compression, cut):
        assert set(run.variables) <= set(VARIABLES)
        write(run, tmp_path / "run.nc")
        back = read(tmp_path / "run.nc")
        for name in run.variables:
            np.testing.assert_array_equal(run[name].values, back[name].values)


@pytest.mark.parametrize("which", ["tension", "compression"])
def test_stress_in_the_specimen_agrees_with_the_grips(which, request):
    run = request.getfixturevalue(which)
    stress, grip = abs(run.stress_axial.values), abs(run.stress_grip.values)
    peak = int(np.nanargmax(stress))
    loaded = np.flatnonzero(stress[: peak + 1] > 0.3 * stress[peak])
    assert len(loaded) > 20
    assert grip[loaded] == pytest.approx(stress[loaded], rel=0.02)


def test_tests_end_after_a_clear_peak_and_pad_the_history(tension, compression):
    for run, sign in ((tension, 1), (compression, -1)):
        stress = sign * run.stress_axial.values[np.isfinite(run.stress_axial.values)]
        assert len(run.sample) == 200
        assert len(stress) < 200
        assert stress[-1] < 0.7 * float(run.strength_ultimate)
        assert float(run.strength_ultimate) >= stress.max() > 0
        assert "time" in run.coords
        assert sign * run.strain_axial.values[len(stress) - 1] > 0


def test_specimen_is_stronger_in_compression_than_in_tension(tension, compression):
    assert float(compression.strength_ultimate) > 2 * float(tension.strength_ultimate)
    assert float(compression.cracks_tension_total + compression.cracks_shear_total) > float(
        tension.cracks_tension_total + tension.cracks_shear_total
    )


@pytest.mark.parametrize(("which", "limit"), [("tension", 0.03), ("compression", 0.01), ("cut", 0.005)])
def test_energy_balance_closes(which, limit, request):
    run = request.getfixturevalue(which)
    assert 0 < abs(float(run.energy_closure)) < limit
    spent = [run[f"energy_{name}"].values for name in ("damping", "friction", "fracture")]
    for series in spent:
        finite = series[np.isfinite(series)]
        assert finite[-1] > 0
        assert np.diff(finite).min() > -1e-4 * float(run.work_tool.max())


def test_cut_breaks_joints_in_both_modes_and_logs_them(cut):
    modes = cut.crack_mode.values
    assert (modes == 0).sum() == int(cut.cracks_tension_total) > 0
    assert (modes == 1).sum() == int(cut.cracks_shear_total) > 0
    assert (np.diff(cut.crack_time.values) >= 0).all()
    assert cut.crack_time.values[-1] <= cut.time.values[-1]
    assert (np.abs(cut.crack_normal.values) <= np.pi / 2).all()
    lost = (1 - cut.bond_intact.values[-1]).sum() * load("dem").joint.elements
    assert lost == pytest.approx(len(modes))
    assert len(np.unique(cut.crack_bond.values)) == (cut.bond_intact.values[-1] < 1).sum()


def test_cut_tells_its_damage_its_chips_and_its_contact(cut):
    below = cut.crack_y.values < 0.24e-3
    shear = cut.crack_mode.values[below].sum()
    assert (int(cut.cracks_tension_below), int(cut.cracks_shear_below)) == (below.sum() - shear, shear)
    assert float(cut.damage_depth) == pytest.approx(max(0.24e-3 - cut.crack_y.values.min(), 0))
    assert 0 <= float(cut.damage_depth_most) <= float(cut.damage_depth)
    assert int(cut.chip_count) == len(cut.chip_area) > 0
    assert float(cut.chip_area_total) == pytest.approx(cut.chip_area.values.sum())
    assert float(cut.chip_area_largest) == cut.chip_area.values[0]
    assert float(cut.chip_area_total + cut.grain_area_total) < 0.5 * np.pi * (cut.disc_radius.values**2).sum()
    air = float(cut.air_share)
    assert 0 <= air < 1
    assert float(cut.force_cutting_contact) * (1 - air) == pytest.approx(float(cut.force_cutting_mean), rel=0.01)


def test_tool_pushes_the_block_along_its_motion_and_reports_it(cut):
    assert float(cut.force_cutting_mean) == pytest.approx(float(cut.force_cutting.mean()), rel=1e-12)
    assert float(cut.force_cutting_mean) > 0
    assert float(cut.force_cutting_error) > 0
    assert float(cut.force_cutting_peak) >= float(cut.force_cutting.max())
    assert cut.tool_travel.values[-1] == pytest.approx(0.06e-3, rel=1e-3)
    work = np.sum(cut.force_cutting.values * np.diff(cut.tool_travel.values, prepend=0.0))
    assert cut.work_tool.values[-1] == pytest.approx(work, rel=1e-6)
    assert len(cut.force_cutting) == 500
    assert cut.tool_tip_snapshot.values[-1] == pytest.approx(cut.tool_tip.values[-1])


def test_fixed_discs_stay_and_grooves_have_the_depth_of_the_cut():
    case = load("dem_cutting", {**BLOCK, "packing.width": "0.6 mm", "grooves": {}})
    packed = pack(case.packing)
    keep = dem_cutting.select_discs(case, packed)
    (left, right), *more = case.grooves.edges(case.packing.width)
    assert (left, right) == pytest.approx((0.34e-3, 0.4e-3))
    assert more == [pytest.approx((0.08e-3, 0.14e-3))]
    removed = packed.y[~keep]
    assert 0 < len(removed) < 0.1 * len(packed.x)
    assert removed.min() > case.packing.height - case.cut_depth
    run = simulate("dem_cutting", **{**BLOCK, "packing.width": "0.6 mm", "travel": "0.01 mm", "grooves": {}})
    x, y, radius = run.disc_x.values, run.disc_y.values, run.disc_radius.values
    fixed = (x[0] - radius < 0) | (y[0] - radius < 0)
    assert fixed.sum() > 10
    assert np.array_equal(x[0, fixed], x[-1, fixed])
    assert np.array_equal(y[0, fixed], y[-1, fixed])


@pytest.mark.parametrize("ratio", [1.0, 0.4, 0.0])
def test_grooves_are_trapezoids_with_the_stated_widths(ratio):
    case = load("dem_cutting", {"cut_depth": "0.2 mm", "grooves.bottom_ratio": ratio})
    x, y = (grid.ravel() for grid in np.meshgrid(np.linspace(0, 1e-3, 2001), np.linspace(0.75e-3, 1e-3, 6)))
    grid = PackedDiscs(x, y, np.full(x.size, 1e-5), 0, 0, 0, 0, 0)
    keep = dem_cutting.select_discs(case, grid)
    (left, right), *_ = case.grooves.edges(case.packing.width)
    for height in np.unique(y):
        taken = x[(y == height) & (np.abs(x - 0.5 * (left + right)) < 0.1e-3) & ~keep]
        share = (height - 0.8e-3) / 0.2e-3
        width = 0.06e-3 * (ratio + (1 - ratio) * share) if share > 1e-9 else 0.0
        assert (np.ptp(taken) if taken.size else 0.0) == pytest.approx(width, abs=1.1e-6)


@pytest.mark.parametrize("rake", [-45, -15, 0, 30, 60])
def test_tool_starts_where_it_touches(rake):
    """No disc that the tip passes over is in the tool, and one of them meets its rake face or its tip."""
    case = load("dem_cutting", {**BLOCK, "tool.rake_angle": f"{rake} deg", "tool.clearance_angle": "5 deg"})
    scene = dem_cutting.make_scene(case, pack(case.packing))
    tip_x, tip_y = scene.walls.rows[0, :2]
    away = scene.places - [tip_x, tip_y]
    above = away[:, 1] > -scene.radius
    gap = [wedge_distance(*place, *scene.walls.rows[0, 2:6])[0] for place in away[above]] - scene.radius[above]
    assert gap.min() == pytest.approx(0, abs=1e-12)


def test_progress_rises_to_one():
    seen = []
    dem_tension.simulate(load("dem_tension", {**SPECIMEN, "strain_max": 1e-4}), seen.append)
    assert seen == sorted(seen)
    assert seen[-1] == 1


def test_repeat_gives_identical_bits(cut):
    again = simulate("dem_cutting", **BLOCK)
    for name in cut.variables:
        assert cut[name].values.tobytes() == again[name].values.tobytes(), name


SCRIPT = """
import hashlib
import numpy as np
from orthocut.dem.setup import build, wall
from orthocut.dem.solver import advance
from orthocut.params.dem import FlatJoint
random = np.random.default_rng(1)
x, y = 19e-6 * np.mgrid[:12, :12].reshape(2, -1) + random.uniform(-1e-6, 1e-6, (2, 144))
tool = wall((240e-6, 150e-6), ((-1.0, 0.0), (0.0, -1.0)), (-5.0, 0.0), 0.5, 107e9)
fixed = np.flatnonzero(x < 10e-6)
scene = build(x, y, random.uniform(9e-6, 10e-6, 144), FlatJoint(), [tool], fixed, 0 * fixed)
assert advance(scene, 6000) == 0
assert scene.cracks.count[0] > 20
parts = (scene.position, scene.velocity, scene.joints.state, scene.contacts.shear, scene.walls.rows, scene.tally)
print(hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest())
"""


def test_fresh_compilation_and_cached_code_give_identical_bits(tmp_path):
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    prints = [
        subprocess.run(
            [sys.executable, "-c", SCRIPT], env=environment, capture_output=True, text=True, check=True
        ).stdout.strip()
        for _ in range(2)
    ]
    assert len(prints[0]) == 2 * hashlib.sha256().digest_size
    assert prints[0] == prints[1]


def test_too_long_a_time_step_stops_with_a_diagnosis():
    with pytest.raises(Diverged, match=r"step \d+, time .*time_step_factor"):
        simulate_unstable("dem_tension", **SPECIMEN)


@pytest.mark.parametrize("travel", [20, 21, 22, 23])
def test_a_cut_that_diverges_between_two_checks_stops_with_a_diagnosis(travel):
    small = {"packing.width": "0.3 mm", "packing.height": "0.3 mm", "cut_depth": "0.05 mm"}
    with pytest.raises(Diverged, match=r"step \d+, time .*(faster than|not accounted).*time_step_factor"):
        simulate_unstable("dem_cutting", **small, travel=f"{travel} um")


def test_strength_and_its_strain_are_those_of_one_sample_though_the_history_is_thinned(monkeypatch):
    seen = []

    class Recorded(dem_specimen.Sample):
        def __new__(cls, *values):
            seen.append(super().__new__(cls, *values))
            return seen[-1]

    monkeypatch.setattr(dem_specimen, "Sample", Recorded)
    monkeypatch.setattr(dem_specimen, "SAMPLES", 10)
    run = simulate("dem_compression", **SPECIMEN, strain_max=0.008, drop_fraction=0.05)
    largest = min(seen, key=lambda sample: sample.stress_axial)
    assert largest.stress_axial not in run.stress_axial.values
    assert float(run.strength_ultimate) == -largest.stress_axial
    assert float(run.strain_peak) == largest.strain_gauge
