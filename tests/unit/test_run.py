"""The door to the simulations, the plan of a study, and what importing costs."""

import subprocess
import sys
import types

import pytest
import xarray as xr

from orthocut.cost import estimate_seconds
from orthocut.params.case import KINDS, load
from orthocut.plan import load_plan
from orthocut.run import SMALLEST, run_case


@pytest.fixture
def experiment(monkeypatch):
    """Put a fake in the place of the MPM experiment; return what it received."""
    received = {}
    module = types.ModuleType("orthocut.experiments.mpm_cutting")

    def simulate(case, progress, checkpoint=None, snapshots=6):
        received["case"] = case
        progress(0.5)
        return xr.Dataset({"force": ("time", [1.0])}, {"time": [0.0]})

    module.simulate = simulate
    monkeypatch.setitem(sys.modules, module.__name__, module)
    return received


def test_run_case_dispatches_by_kind_and_reports_progress(experiment):
    seen = []
    dataset = run_case(load("mpm"), seen.append)
    assert experiment["case"] == load("mpm")
    assert seen == [0.5]
    assert dataset.attrs["wall_time_s"] >= 0


def test_run_case_counts_the_time_of_runs_that_were_cut_short(experiment):
    assert run_case(load("mpm"), checkpoint=types.SimpleNamespace(seconds=12.0)).attrs["wall_time_s"] == 12.0


def test_every_kind_has_a_smallest_case_and_a_cost():
    assert set(SMALLEST) == set(KINDS)
    for kind in KINDS:
        assert estimate_seconds(load(kind, SMALLEST[kind])) < estimate_seconds(load(kind))


def test_cost_grows_as_the_work_does():
    start = 0.1
    coarse, fine = (estimate_seconds(load("mpm", {"points_per_depth": n})) - start for n in (8, 16))
    assert 7 < fine / coarse < 8  # a step has a cost beside that of its points
    coarse, fine = (estimate_seconds(load("dem", {"radius_min": f"{r} um"})) - start for r in (20, 10))
    assert fine / coarse == pytest.approx(8, rel=1e-3)


def test_plan_holds_each_case_once(tmp_path):
    path = tmp_path / "s.yaml"
    path.write_text(
        "title: t\n"
        "sweeps:\n"
        "  a: {base: {kind: mpm}, axes: {product: {cut_depth: [0.9 mm, 1 mm]}}}\n"
        "  b: {base: {kind: mpm}}\n"
        "figures: {energy_balance: [b, a], nairn2015_fig07: []}\n"
    )
    plan = load_plan(path)
    assert len(plan.cases) == 2
    assert plan.figures == {"energy_balance": list(plan.cases), "nairn2015_fig07": []}
    assert set(plan.labels) == set(plan.cases)


@pytest.mark.parametrize(
    ("module", "absent"),
    [
        ("orthocut.cli", ("numba", "xarray", "matplotlib", "numpy", "snakemake")),
        ("orthocut.run", ("numba", "xarray", "matplotlib")),
        ("orthocut.plan", ("numba",)),
    ],
)
def test_imports_stay_light(module, absent):
    code = f"import sys, {module}; print(*(name for name in {absent} if name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == ""
