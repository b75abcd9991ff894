"""Predicted sizes and steps against those of runs; no clock is looked at."""

from pathlib import Path

import pytest

from orthocut.cost import estimate_seconds, expected_steps, seconds_of
from orthocut.io import machine
from orthocut.io.collect import case_of
from orthocut.io.store import Store
from orthocut.kernels.mpm.layout import BASE, CHIP, LANES
from orthocut.mpm import setup
from orthocut.mpm.solver import Solver
from orthocut.params.case import load
from orthocut.params.size import least_share, moving, particles

PUBLISHED = Path(__file__).parents[2] / "results" / "published" / "store"
STEPS = {"mpm_cutting": 1e-9, "dem_cutting": 0.01, "dem_tension": 0.4, "dem_compression": 0.4}
"""Kind to the tolerance of the number of steps: a test of glass ends when it breaks."""
LONG = {"travel_ratio": 18, "window_ratio": 9, "workpiece.length_ratio": 24}


@pytest.mark.parametrize("key", Store(PUBLISHED).names())
def test_particles_and_steps_of_published_runs(key):
    run = Store(PUBLISHED).read(key)
    if run.attrs["status"] != "done":
        pytest.skip("failed")
    case = case_of(run)
    assert particles(case) == pytest.approx(run.attrs["particles"], rel=0.07)
    assert expected_steps(case) == pytest.approx(run.attrs["steps"], rel=STEPS[case.kind])


def test_moving_points_of_a_cut():
    case = load("mpm", {"points_per_depth": 4, **LONG, "courant": 1.0, "cut_speed": "20 m/s"})
    solver, counts = Solver(setup.build(case)), []
    for _ in range(10):
        solver.advance(case.steps // 20)
        awake = solver.freeze()["awake"]
        counts.append(LANES * sum(int(awake[body, 1] - awake[body, 0]) for body in (CHIP, BASE)))
    assert moving(case, 0.5) == pytest.approx(sum(counts) / len(counts), rel=0.15)


def test_cuts_that_end_early_take_fewer_steps():
    whole = load("mpm", {"points_per_depth": 8, **LONG})
    early = load("mpm", {"points_per_depth": 8, **LONG, "error_target": 0.01})
    loose = load("mpm", {"points_per_depth": 8, **LONG, "error_target": 0.05})
    assert least_share(whole) == 1
    assert expected_steps(loose) == pytest.approx(least_share(loose) * loose.steps)
    assert expected_steps(loose) < expected_steps(early) < expected_steps(whole) == whole.steps
    assert estimate_seconds(early) == seconds_of(early, expected_steps(early)) < estimate_seconds(whole)


def test_a_machine_that_was_measured_is_remembered(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert machine.factors() == {}
    machine.remember("mpm", 1.5)
    machine.remember("dem", 0.8)
    assert machine.factors() == {"mpm": 1.5, "dem": 0.8}
    next((tmp_path / "orthocut" / "machines").iterdir()).write_text("[")
    assert machine.factors() == {}
