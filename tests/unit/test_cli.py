"""The command line: help, errors, pure JSON, no half files."""

import json
import math
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import typer
import xarray as xr
from synthetic import mpm_run
from typer.testing import CliRunner

from orthocut import run as run_module
from orthocut.cli import app
from orthocut.io import machine
from orthocut.io.collect import collect
from orthocut.io.datasets import build, failed
from orthocut.io.netcdf import read, write
from orthocut.io.store import Store
from orthocut.measure.guard import Diverged
from orthocut.params.case import validate

ROOT = Path(__file__).parents[2]
VERBS = [
    [],
    ["run"],
    ["show"],
    ["export"],
    ["redraw"],
    ["bench"],
    ["calibrate"],
    ["study"],
    ["study", "list"],
    ["study", "expand"],
    ["study", "status"],
    ["theory"],
    ["theory", "touching"],
    ["theory", "bending"],
]


def call(*arguments):
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


@pytest.fixture
def simulated(monkeypatch, tmp_path):
    """Replace the simulation by one that returns its inputs at once; return the cases it was given."""
    seen = []

    def simulate(case, progress=None, checkpoint=None):
        seen.append(case)
        scalars = {"force_cutting_mean": ((), case.cut_depth * 1e7), "energy_closure": ((), math.nan)}
        dataset = build(
            case, "fake", {**scalars, "force_cutting": (("time",), [1.0, 2.0])}, {"time": (("time",), [0, 1])}
        )
        dataset.attrs["wall_time_s"] = 0.5
        return dataset

    monkeypatch.setattr(run_module, "run_case", simulate)
    monkeypatch.chdir(tmp_path)
    return seen


@pytest.mark.parametrize("verb", VERBS, ids=" ".join)
def test_help(verb):
    result = call(*verb, "--help")
    assert result.exit_code == 0
    assert "Usage: " in result.stdout
    if verb not in ([], ["study"], ["theory"]):
        assert "Example" in result.stdout
        assert f"orthocut {' '.join(verb)}" in result.stdout


def examples():
    """Lines of the help and of README that call the program."""
    pending, texts = [typer.main.get_command(app)], [(ROOT / "README.md").read_text(encoding="utf-8")]
    while pending:
        command = pending.pop()
        texts.append(command.epilog or "")
        pending += getattr(command, "commands", {}).values()
    lines = "\n".join(texts).splitlines()
    return [shlex.split(line, comments=True) for line in lines if line.startswith("orthocut ")]


@pytest.mark.parametrize("words", examples(), ids=" ".join)
def test_examples_name_verbs_and_options_that_there_are(words):
    command, rest = typer.main.get_command(app), words[1:]
    while hasattr(command, "commands"):
        name, *rest = rest
        command = command.commands[name]
    with command.make_context(command.name, rest, resilient_parsing=True) as context:
        assert not context.args


def test_version():
    assert call("--version").stdout.startswith("orthocut 0.")


def test_run_sets_fields_writes_and_reports(simulated, tmp_path):
    (tmp_path / "a").mkdir()
    result = call(
        "run", "mpm", "--set", "cut_depth=0.5 mm", "--set", "tool.friction=3e-1", "--output", "a/cut.nc", "--json"
    )
    assert result.exit_code == 0, result.stderr
    report = json.loads(result.stdout)
    assert report["results"] == {"force_cutting_mean": pytest.approx(5000.0), "energy_closure": None}
    assert report["units"]["force_cutting_mean"] == "N/m"
    assert (simulated[0].cut_depth, simulated[0].tool.friction) == (0.0005, 0.3)
    dataset = read(tmp_path / "a" / "cut.nc")
    assert dataset.attrs["case_id"] == report["case_id"]
    assert [path.name for path in (tmp_path / "a").iterdir()] == ["cut.nc"]


def test_run_reads_a_file_and_names_the_output_after_the_case(simulated, tmp_path):
    (tmp_path / "case.yaml").write_text("kind: dem\ncut_depth: 0.1 mm\ngrooves: {width: 50 um}\n")
    result = call("run", "case.yaml", "--set", "grooves.distance=0.1 mm")
    assert result.exit_code == 0, result.stderr
    assert "N/mm" in result.stdout
    assert (simulated[0].grooves.width, simulated[0].grooves.distance) == (50e-6, 100e-6)
    assert len(list(tmp_path.glob("dem-cutting-*.nc"))) == 1


def test_run_replaces_its_own_result_but_nothing_else(simulated, tmp_path):
    assert call("run", "mpm", "--output", "cut.nc").exit_code == 0
    assert call("run", "mpm", "--output", "cut.nc").exit_code == 0
    before = (tmp_path / "cut.nc").read_bytes()
    other = call("run", "mpm", "--set", "cut_depth=1 mm", "--output", "cut.nc")
    assert other.exit_code == 2
    assert "does not hold this case" in other.stderr
    assert (tmp_path / "cut.nc").read_bytes() == before
    (tmp_path / "notes.txt").write_text("precious")
    assert call("run", "mpm", "--output", "notes.txt").exit_code == 2
    assert (tmp_path / "notes.txt").read_text() == "precious"
    assert call("run", "mpm", "--set", "cut_depth=1 mm", "--output", "cut.nc", "--force").exit_code == 0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["run", "fem"], "fem: cannot be read"),
        (
            ["run", "mpm", "--set", "cut_depth=0.9"],
            "cut_depth = 0.9: needs a unit, such as '0.9 mm' (allowed: 0.02 mm to 20 mm)",
        ),
        (
            ["run", "mpm", "--set", "cut_depth=90 mm"],
            "cut_depth = '90 mm': is out of range (allowed: 0.02 mm to 20 mm)",
        ),
        (["run", "mpm", "--set", "cut_depth"], "must read field=value"),
        (["run", "mpm", "--set", "=3"], "must read field=value"),
        (["run", "mpm", "--set", "rake=3 deg"], "mpm_cutting has no such field"),
        (
            ["run", "mpm", "--set", "tool.friction=0.1", "--set", "friction=0.2"],
            "tool.friction is already set by 'tool.friction=0.1'",
        ),
        (["run", "mpm", "--set", "tool={a: [}"], "--set tool, line 1"),
        (["run", "mpm", "--set", "cut_depth=1e400 mm"], "cut_depth = '1e400 mm': is out of range"),
        (["run", "mpm", "--output", "."], "is a folder"),
        (["run", "mpm", "--output", "no/cut.nc"], "--output no/cut.nc: no does not exist (allowed: a file in an exis"),
        (["run", "mpm", "--output", f"{__file__}/cut.nc"], "test_cli.py is not a folder (allowed: a file in an exis"),
        (["run", "dem", "--set", "grooves=3"], "grooves = 3: must hold the fields of Grooves (allowed: "),
        (["show", "none.nc"], "none.nc: cannot be read: no such file"),
        (["show", "none.nc", "--output", "a.doc"], "allowed: .png, .svg, .pdf"),
        (["study", "expand", "none.yaml"], "none.yaml: cannot be read: No such file"),
        (["study", "list", "nowhere"], "nowhere: is not a folder"),
        (["theory", "touching", "--cut-depth", "0.9"], "cut_depth = '0.9': has no unit"),
        (["theory", "bending", "--force-rubbing", "1 mm"], "--force-rubbing = '1 mm': is not a quantity in N/m"),
        (["theory", "bending", "--form", "mine"], "--form = 'mine': must be one of consistent, paper"),
        (["theory", "bending", "--set", "friction=0.1"], "has an option of its own, --friction"),
        (["bench", "fem"], "method = 'fem': must be one of mpm, dem"),
    ],
)
def test_bad_input_is_one_clear_line_and_exit_code_2(simulated, arguments, words):
    result = call(*arguments)
    assert result.exit_code == 2, result.output
    assert words in result.stderr
    assert result.stderr.startswith("error: ")
    assert "Traceback" not in result.output
    assert result.stdout == ""
    assert not simulated


def test_run_refuses_a_folder_that_cannot_be_written_to(simulated, monkeypatch):
    monkeypatch.setattr("os.access", lambda path, mode: False)  # the user root may write everywhere
    result = call("run", "mpm", "--output", "cut.nc")
    assert result.exit_code == 2
    assert "--output cut.nc: . cannot be written to" in result.stderr
    assert not simulated


@pytest.mark.parametrize(("text", "depth"), [("9e-4 m", 9e-4), ("1e-3 m", 1e-3), ("0.09e1 mm", 9e-4)])
def test_run_takes_quantities_with_an_exponent(simulated, text, depth):
    result = call("run", "mpm", "--set", f"cut_depth={text}")
    assert result.exit_code == 0, result.stderr
    assert simulated[0].cut_depth == depth


def test_unknown_options_exit_with_2():
    assert call("run", "mpm", "--nonsense").exit_code == 2


@pytest.mark.parametrize(
    ("error", "code", "words"),
    [
        (KeyboardInterrupt(), 130, "interrupted; no file is half-written"),
        (Diverged("energy is not finite\nat 3 ms"), 1, "error: energy is not finite at 3 ms"),
        (OSError(28, "No space left on device"), 1, "No space left"),
        (MemoryError(), 1, "error: the case is too large for the memory of this machine\n"),
    ],
)
def test_failures_leave_no_file(monkeypatch, tmp_path, error, code, words):
    def fails(case, progress=None, checkpoint=None):
        raise error

    monkeypatch.setattr(run_module, "run_case", fails)
    result = call("run", "mpm", "--output", tmp_path / "cut.nc", "--json")
    assert result.exit_code == code
    assert words in result.stderr
    assert result.stdout == ""
    assert list(tmp_path.iterdir()) == []


def test_interrupt_while_writing_leaves_no_file(simulated, monkeypatch, tmp_path):
    def stops(self, path, **options):
        path.write_bytes(b"half")
        raise KeyboardInterrupt

    monkeypatch.setattr(xr.Dataset, "to_netcdf", stops)
    assert call("run", "mpm", "--output", tmp_path / "cut.nc").exit_code == 130
    assert list(tmp_path.iterdir()) == []


def test_theory_touching_gives_the_known_force():
    report = json.loads(call("theory", "touching", "--rake-angle", "30 deg", "--cut-depth", "0.9 mm", "--json").stdout)
    assert report["force_over_toughness"] == pytest.approx(8.5, rel=1e-6)
    assert report["angle_shear"] == pytest.approx(math.pi / 3, rel=1e-6)
    assert set(report["units"]) == set(report) - {"model", "reason", "units"}


def test_theory_takes_any_field_and_prints_words():
    base = ["theory", "bending", "--rake-angle", "30 deg", "--cut-depth", "1 mm"]
    soft, hard = (
        json.loads(call(*base, "--set", f"stress_yield={stress}", "--json").stdout)["force_cutting"]
        for stress in ("25 MPa", "50 MPa")
    )
    assert soft != hard
    assert "curvature" in call(*base).stdout


def test_theory_without_a_solution_says_why():
    result = call("theory", "bending", "--rake-angle", "10 deg", "--friction", "0.6", "--json")
    assert result.exit_code == 1
    assert json.loads(result.stdout)["force_over_toughness"] is None
    (line,) = result.stderr.splitlines()
    assert line.startswith("error: ")
    assert "does not lift the chip" in line


def test_a_reader_that_stops_early_is_no_error():
    verb = f"{shlex.quote(sys.executable)} -c 'from orthocut.cli import app; app()' study expand quick"
    done = subprocess.run(["bash", "-c", f"{verb} | true"], capture_output=True, text=True, cwd=ROOT, check=False)
    assert done.stderr == ""  # true has gone long before the first line; head might let all of them through


STUDY = """\
title: two sweeps
sweeps:
  a: {base: {kind: mpm}, axes: {product: {cut_depth: [0.9 mm, 1 mm]}}}
  b: {base: {kind: mpm}}
figures: {}
"""


def test_study_expand_and_status(simulated, tmp_path):
    (tmp_path / "s.yaml").write_text(STUDY)
    report = json.loads(call("study", "expand", "s.yaml", "--json").stdout)
    assert [case["sweeps"] for case in report["cases"]] == [["a", "b"], ["a"]]
    status = json.loads(call("study", "status", "s.yaml", "--json").stdout)
    assert status["counts"] == {"done": 0, "failed": 0, "stale": 0, "missing": 2}
    first = validate(report["cases"][0]["case"])
    Store("results/store").put(first, failed(first, "it blew up", 0.1), 0)
    status = json.loads(call("study", "status", "s.yaml", "--json").stdout)
    assert status["counts"] == {"done": 0, "failed": 1, "stale": 0, "missing": 1}
    assert "it blew up" in call("study", "status", "s.yaml").stdout


def test_study_list_goes_on_after_a_faulty_study(simulated, tmp_path):
    (tmp_path / "s.yaml").write_text(STUDY)
    (tmp_path / "a.yaml").write_text("title: 3\n")
    done = call("study", "list", tmp_path)
    assert done.exit_code == 2
    assert done.stdout.startswith("s  ")
    assert "a.yaml: title = 3: must be words" in done.stderr


def test_study_list(simulated, tmp_path):
    (tmp_path / "s.yaml").write_text(STUDY)
    report = json.loads(call("study", "list", tmp_path, "--json").stdout)
    assert report == {"studies": [{"name": "s", "title": "two sweeps", "cases": 2, "figures": []}]}


@pytest.mark.parametrize(("method", "name"), [("mpm", "ns_per_point_step"), ("dem", "ns_per_bond_step")])
def test_bench_prints_one_object_and_is_remembered(monkeypatch, tmp_path, method, name):
    import sys
    import types

    module = types.ModuleType(f"orthocut.experiments.speed_{method}")
    setattr(module, f"bench_{method}", lambda: {name: 30.0, "over_cost_model": 1.5, "repeats": 3})
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setitem(sys.modules, module.__name__, module)
    assert json.loads(call("bench", method, "--json").stdout)[name] == 30.0
    assert name in call("bench", method).stdout
    assert machine.factors() == {method: 1.5}


def test_redraw_draws_collected_datasets(tmp_path):
    write(collect([mpm_run(0), mpm_run(0, cut_depth="2 mm")], "nairn2015_fig08", ()), tmp_path / "nairn2015_fig08.nc")
    result = call("redraw", tmp_path, "--output", tmp_path / "new")
    assert result.exit_code == 0
    assert result.stdout.split() == [str(tmp_path / "new" / "nairn2015_fig08.png")]
    assert (tmp_path / "new" / "nairn2015_fig08.png").stat().st_size > 10_000


def test_redraw_takes_the_first_word_from_the_folder(tmp_path):
    folder = tmp_path / "nairn2015"
    folder.mkdir()
    write(collect([mpm_run(0)], "nairn2015_fig08", ()), folder / "fig08.nc")
    assert call("redraw", folder, "--output", tmp_path).stdout.split() == [str(tmp_path / "fig08.png")]


def test_redraw_says_what_it_looks_for(tmp_path):
    result = call("redraw", tmp_path, "--output", tmp_path / "new")
    assert result.exit_code == 2
    assert "no dataset with the name of a figure" in result.stderr
    assert not (tmp_path / "new").exists()
