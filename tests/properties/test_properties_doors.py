"""Bad input at every door: exit codes, no traceback, no file outside the results."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from strategies import spell, studies
from typer.testing import CliRunner

from orthocut.cli import app
from orthocut.params.study import load_study
from orthocut.plan import load_plan

ROOT = Path(__file__).resolve().parents[2]
BAD = [None, -1, True, "nan mm", "-1 mm", "../../x", "a\0b", "\x1b[2J", [], {"x": 1}, float("inf"), 10**30]
WRONG = {
    "field": "title: t\nsweeps: {a: {base: {kind: mpm, cut_dept: 1 mm}}}\nfigures: {nairn2015_fig08: [a]}\n",
    "unit": "title: t\nsweeps: {a: {base: {kind: mpm, cut_depth: 1}}}\nfigures: {nairn2015_fig08: [a]}\n",
    "wedge": "title: t\nsweeps: {a: {base: {kind: mpm, tool: {rake_angle: 60 deg, clearance_angle: 30 deg}}}}\n"
    "figures: {nairn2015_fig08: [a]}\n",
    "figure": "title: t\nsweeps: {a: {base: {kind: mpm}}}\nfigures: {../../../figure: [a]}\n",
    "sweep": "title: t\nsweeps: {../../a: {base: {kind: mpm}}}\nfigures: {nairn2015_fig08: [../../a]}\n",
    "count": "title: t\nsweeps: {a: {base: {kind: mpm}, axes: {product: {cut_depth: &v ["
    + "1 mm, " * 1000
    + "], cut_speed: *v, strength: *v}}}}\nfigures: {nairn2015_fig08: [a]}\n",
    "bomb": "a0: &a0 [x]\n" + "".join(f"a{k}: &a{k} [{f'*a{k - 1}, ' * 10}]\n" for k in range(1, 12)),
    "tag": "title: !!python/object/apply:os.system ['touch pwned']\nsweeps: {}\nfigures: {}\n",
}


def tree(folder):
    """Every file, with its time of change, and every folder, but for what Snakemake keeps for itself."""
    return {
        str(path.relative_to(folder)): 0 if path.is_dir() else path.lstat().st_mtime_ns
        for path in folder.rglob("*")
        if ".snakemake" not in path.parts
    }


@pytest.fixture
def project(tmp_path, monkeypatch):
    """Return an empty folder of a project inside a folder that is watched too; the working directory."""
    root = tmp_path / "outer" / "project"
    root.mkdir(parents=True)
    (root / "studies").mkdir()
    monkeypatch.chdir(root)
    return root


def call(*arguments):
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


@given(st.data())
@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_verbs_end_with_0_or_2_and_write_nothing(project, data):
    study = spell(data.draw, data.draw(studies()))
    sweep = next(iter(study["sweeps"].values()))
    spot = data.draw(st.sampled_from([study, study["sweeps"], study["figures"], sweep, sweep["base"]]))
    spot[data.draw(st.sampled_from([*spot, "../../x", "other", 7]))] = data.draw(st.sampled_from(BAD))
    (project / "studies" / "s.yaml").write_text(yaml.safe_dump(study), encoding="utf-8")
    before = tree(project.parent)
    for verb in (("expand", "studies/s.yaml"), ("status", "studies/s.yaml"), ("list", "studies")):
        done = call("study", *verb)
        assert done.exit_code in (0, 2), (done.output, done.exception)
        assert done.exception is None or isinstance(done.exception, SystemExit)
        assert all(line.startswith("error: ") for line in done.stderr.splitlines()) or done.exit_code == 0
    assert tree(project.parent) == before


@pytest.mark.parametrize("name", WRONG)
def test_verbs_refuse_with_2(project, name):
    path = project / "s.yaml"
    path.write_text(WRONG[name])
    before = tree(project.parent)
    done = call("study", "status", "s.yaml")
    assert done.exit_code == 2, done.output
    assert done.stdout == ""
    assert done.stderr.startswith("error: s.yaml")
    assert tree(project.parent) == before


@pytest.mark.parametrize("name", ["../../x", "/etc", "a\nb", "x" * 5000, "é", "-", ".", "/dev/zero", "'; rm -rf x"])
def test_studies_that_are_no_names(project, name):
    before = tree(project.parent)
    for verb in ("expand", "status"):
        done = call("study", verb, "--", name)
        assert done.exit_code == 2, (done.output, done.exception)
        assert done.stderr.startswith("error: ")
    assert tree(project.parent) == before


@pytest.mark.parametrize(
    "setting",
    ["cut_depth=nan mm", "cut_depth=*x", "cut_depth=&a [*a]", "cut_depth=!!python/object:os.x 1", "=", "../x=1",
     "tool=3", "tool={a: {a: {a: 1}}}", "cut_depth=1 mm^999999999", "points_per_depth=0",
     "points_per_depth=010", "kind=../x"],
)  # fmt: skip
def test_settings_of_a_case_that_are_refused(project, setting):
    done = call("run", "mpm", "--set", setting, "--output", "x.nc")
    assert done.exit_code == 2, (done.output, done.exception)
    assert all(line.startswith("error: ") for line in done.stderr.splitlines())
    assert not list(project.glob("*.nc"))


def snakemake(project, *config):
    """Run the workflow of this checkout in another folder; it must not come to simulations."""
    return subprocess.run(
        [
            sys.executable,
            "-m",
            "snakemake",
            "--snakefile",
            str(ROOT / "Snakefile"),
            "--cores",
            "1",
            "--config",
            *config,
        ],
        cwd=project,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=60,
        check=False,
    )


@pytest.mark.xdist_group("doors")
@pytest.mark.parametrize("name", ["unit", "figure", "bomb"])
def test_the_workflow_refuses_a_study(project, name):
    (project / "s.yaml").write_text(WRONG[name])
    before = tree(project.parent)
    done = snakemake(project, "study_file=s.yaml")
    assert done.returncode != 0
    assert "s.yaml" in done.stdout.split("WorkflowError", 1)[1]
    assert "Traceback" not in done.stdout
    assert tree(project.parent) == before


@pytest.mark.xdist_group("doors")
@pytest.mark.parametrize(
    ("config", "words"),
    [
        (["study=../../x"], "study = '../../x': must be a name"),
        (["study=smoke", "results=../elsewhere"], "leads out of the folder of the project"),
        (["study=smoke", "results=/etc"], "results = /etc: holds other things"),
        (["study=smoke", "reslts=x"], "reslts = 'x': no such field; did you mean results?"),
    ],
)
def test_the_workflow_refuses_options(project, config, words):
    before = tree(project.parent)
    done = snakemake(project, *config)
    assert done.returncode != 0
    assert words in done.stdout
    assert "Traceback" not in done.stdout
    assert tree(project.parent) == before


def test_five_thousand_cases_are_planned_in_no_time(tmp_path):
    path = tmp_path / "s.yaml"
    depths, angles = [f"{100 + k} um" for k in range(100)], [f"{k} deg" for k in range(50)]
    axes = {"product": {"cut_depth": depths, "rake_angle": angles}}
    sweeps = {"a": {"base": {"kind": "mpm"}, "axes": axes}}
    path.write_text(yaml.safe_dump({"title": "t", "sweeps": sweeps, "figures": {"nairn2015_fig08": ["a"]}}))
    load_plan(path)
    began = time.process_time()
    assert len(load_plan(path).cases) == 5000
    assert time.process_time() - began < 2.0


def test_a_hundred_thousand_cases_are_the_most(tmp_path):
    path = tmp_path / "s.yaml"
    sweep = {"base": {"kind": "dem"}, "axes": {"product": {"cut_depth": ["0.1 mm"] * 101}}, "replicates": 1000}
    path.write_text(yaml.safe_dump({"title": "t", "sweeps": {"a": sweep}, "figures": {}}))
    began = time.process_time()
    with pytest.raises(ValueError, match=r"has 101000 cases, .* \(allowed: up to 100000\)"):
        load_study(path)
    assert time.process_time() - began < 0.1
