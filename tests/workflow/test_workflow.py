"""From a study file to figures: what runs, what runs again, and what does not."""

import contextlib
import csv

import pytest

from orthocut.io.netcdf import read
from orthocut.io.store import Store
from orthocut.params.study import load_study

pytestmark = pytest.mark.xdist_group("workflow")


@contextlib.contextmanager
def edited(path, old, new):
    """Replace a text in a file for a while."""
    text = path.read_text(encoding="utf-8")
    assert old in text
    try:
        path.write_text(text.replace(old, new, 1), encoding="utf-8")
        yield
    finally:
        path.write_text(text, encoding="utf-8")


def appended(path):
    """Add a line to a source file for a while."""
    text = path.read_text(encoding="utf-8")
    return edited(path, text, text + "\nEDITED = True\n")


def test_lint(fresh):
    done = fresh.snakemake("--lint")
    assert done.returncode == 0, done.stdout
    assert "in a good condition" in done.stdout


def test_quick_study_plans_every_case_and_figure_once(fresh):
    study = load_study(fresh.root / "workflow" / "config" / "quick.yaml")
    cases = {key for sweep in study.cases().values() for key in sweep}
    planned = fresh.planned("quick")
    assert fresh.missing("quick") == len(cases)
    assert planned["figure"] == len(study.figures)
    assert planned["collect"] == sum(bool(names) for names in study.figures.values())


def test_calibration_runs_on_request_and_needs_the_kernels_of_glass_alone(fresh):
    done = fresh.snakemake("--dry-run", "calibrate")
    assert done.returncode == 0, done.stdout
    assert "kernels/dem.compiled" in done.stdout
    assert "calibration/joint.yaml" in done.stdout
    assert "rule simulate" not in done.stdout
    assert "mpm.compiled" not in done.stdout


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("base_ratio: 1.0", "base_ratio: 1.0 mm", "sweeps.ductile: workpiece.base_ratio = '1.0 mm': must be a number"),
        ("cut_depth: 0.05 mm", "cut_depth: 0.05", "sweeps.cut: cut_depth = 0.05: needs a unit"),
        (
            "yang2018_fig05: [tension]",
            "yang2018_fig99: [tension]",
            "yang2018_fig99: no such figure; did you mean yang2018",
        ),
        ("yang2018_fig05: [tension]", "yang2018_fig05: []", "yang2018_fig05 = []: this figure needs one sweep or more"),
        ("figures:", "figures: [", "smoke.yaml, line"),
    ],
)
def test_a_faulty_study_stops_with_one_clear_line(fresh, old, new, words):
    with edited(fresh.root / "workflow" / "config" / "smoke.yaml", old, new):
        done = fresh.snakemake("--dry-run")
    assert done.returncode != 0
    assert words in done.stdout
    assert "smoke.yaml" in done.stdout
    assert "Traceback" not in done.stdout


def test_unknown_study(fresh):
    done = fresh.snakemake("--dry-run", study="nonsense")
    assert done.returncode != 0
    assert "nonsense.yaml: cannot be read: No such file" in done.stdout


def test_smoke_study_leaves_runs_datasets_figures_and_tables(finished):
    results = finished.root / "results"
    study = load_study(finished.root / "workflow" / "config" / "smoke.yaml")
    cases = {key for sweep in study.cases().values() for key in sweep}
    store = Store(results / "store")
    assert {key.rpartition("-")[0] for key in store.names()} == cases
    assert {store.entry(key).status for key in store.names()} == {"done"}
    for figure, sweeps in study.figures.items():
        assert (results / "figures" / f"{figure}.png").stat().st_size > 5000
        assert (results / "figures" / f"{figure}.svg").stat().st_size > 5000
        assert (results / "datasets" / f"{figure}.nc").exists() == bool(sweeps)
    with open(results / "tables" / "run_times.csv", encoding="utf-8") as file:
        assert len(list(csv.reader(file))) == len(cases) + 2
    assert not list(results.rglob("*.part"))


def test_small_results_and_snapshots_only_where_a_figure_draws_them(finished):
    store = Store(finished.root / "results" / "store")
    for key in store.names():
        assert store.path(key).stat().st_size <= 20_000
    assert [path.name.split("-")[1] for path in store.root.glob("*.snapshots.nc")] == ["tension"]


def test_progress_names_cases_counts_them_and_tells_the_time_left(finished):
    lines = finished.first.stdout.splitlines()
    assert any(line.startswith("3 cases to simulate") for line in lines), finished.first.stdout
    assert any("ductile" in line and "/3 cases" in line and " left)" in line for line in lines), finished.first.stdout
    assert any(line.startswith("workers: http://127.0.0.1:") for line in lines), finished.first.stdout


def test_second_run_does_nothing_and_says_so(finished):
    done = finished.snakemake()
    assert done.returncode == 0
    assert "Nothing to do" in done.stdout
    assert finished.planned() == {}


def test_edit_of_a_figure_redraws_and_simulates_nothing(finished):
    with appended(finished.root / "src" / "orthocut" / "figures" / "palette.py"):
        planned = finished.planned()
    assert planned["figure"] == 4
    assert planned["collect"] == 1  # table4 condenses its runs itself
    assert not {"simulate", "warm"} & set(planned)


@pytest.mark.parametrize(
    ("source", "count"), [("mpm/solver.py", 1), ("kernels/mpm/grid.py", 1), ("dem/solver.py", 2), ("kernels/jit.py", 3)]
)
def test_edit_of_the_physics_simulates_what_it_concerns(finished, source, count):
    with appended(finished.root / "src" / "orthocut" / source):
        text = finished.snakemake("--dry-run").stdout
        planned = finished.planned()
    assert f"{count} cases to simulate ({count} of them stale)" in text
    assert planned["warm"] >= 1
    assert planned["simulate"] >= 1


def test_edit_of_the_command_line_or_the_plan_reruns_nothing(finished):
    with appended(finished.root / "src" / "orthocut" / "plan.py"), appended(finished.root / "src/orthocut/cli/run.py"):
        assert finished.planned() == {}


def test_a_changed_value_simulates_one_case_and_comments_none(finished):
    path = finished.root / "workflow" / "config" / "smoke.yaml"
    with edited(path, "travel: 5 um", "travel: 6 um"):
        assert finished.missing() == 1
    with edited(path, "travel: 5 um", "travel: 0.005 mm  # the same"):
        assert finished.planned() == {}


def test_another_figure_of_the_same_cases_simulates_nothing(finished):
    path = finished.root / "workflow" / "config" / "smoke.yaml"
    with edited(path, "figures:\n", "figures:\n  nairn2015_fig08: [ductile]\n"):
        assert finished.missing() == 0
        assert set(finished.planned()) == {"all", "collect", "figure"}


def test_a_table_of_claims_makes_do_with_the_snapshots_that_are_there(finished):
    path = finished.root / "workflow" / "config" / "smoke.yaml"
    with edited(path, "figures:\n", "figures:\n  nairn2015_claims: [ductile]\n"):
        assert finished.missing() == 0
        assert set(finished.planned()) == {"all", "collect", "figure", "table"}


def test_a_figure_that_draws_snapshots_has_them_made(finished):
    path = finished.root / "workflow" / "config" / "smoke.yaml"
    with edited(path, "figures:\n", "figures:\n  nairn2015_fig05: [ductile]\n"):
        assert finished.missing() == 1


@pytest.mark.parametrize("damage", ["deleted", "truncated"])
def test_a_lost_or_broken_result_is_simulated_again_to_the_same_bits(finished, damage):
    store = Store(finished.root / "results" / "store")
    key = next(key for key in store.names() if key.startswith("dem-cutting"))
    before = store.read(key)
    path = store.path(key)
    if damage == "deleted":
        path.unlink()
    else:
        path.write_bytes(path.read_bytes()[:-50])
    done = finished.snakemake(copied=False)
    assert done.returncode == 0, done.stdout
    assert ("truncated" in done.stdout) == (damage == "truncated")
    assert store.read(key).drop_attrs().identical(before.drop_attrs())
    assert finished.planned() == {}


@pytest.mark.parametrize(
    ("target", "rules"),
    [
        ("fig05", {"figure"}),
        ("table4", {"figure", "table"}),
        ("mpm", {"figure"}),
        ("dem", {"figure", "table"}),
        ("calibration", {"figure"}),
        ("paper", {"figure", "table"}),
        ("energy_balance", {"figure"}),
    ],
)
def test_targets(finished, target, rules):
    text = finished.snakemake(target, "--dry-run", "--forcerun", "figure", "table").stdout
    planned = {line.split()[0] for line in text.split("Job stats:")[1].split("total")[0].splitlines() if line.split()}
    assert planned & {"figure", "table"} == rules, text


def test_a_failing_case_is_a_hole_with_a_reason_until_it_is_tried_again(finished):
    path = finished.root / "src" / "orthocut" / "experiments" / "mpm_cutting.py"
    old = "def simulate("
    new = "def simulate(*_):\n    raise Diverged('it blew up')\n\n\ndef _old("
    with edited(path, old, new):
        done = finished.snakemake()
        assert done.returncode == 0, done.stdout
        assert "FAILED ductile: it blew up" in done.stdout
        aggregate = read(finished.root / "results" / "datasets" / "energy_balance.nc")
        assert list(aggregate["failure"].values) == ["it blew up"]
        assert finished.planned() == {}
        assert finished.orthocut("store", "retry").stderr.startswith("1 failed")
        assert finished.missing() == 1
    again = finished.snakemake()
    assert again.returncode == 0, again.stdout
    assert finished.planned() == {}
