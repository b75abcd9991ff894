"""The workflow through a real Slurm of one node: the same numbers as without, and nothing lost whatever dies."""

import shutil

import pytest
from slurm.conftest import Project, kill_processes, wait_for

from orthocut.io.netcdf import read
from orthocut.params.study import load_study

pytestmark = pytest.mark.xdist_group("slurm")

STUDY = """
title: Cuts of some seconds each and a tension test
sweeps:
  cuts:
    base:
      kind: mpm_cutting
      travel_ratio: 1.5
      window_ratio: 0.5
      workpiece: {length_ratio: 6.0, base_ratio: 1.0, notch_ratio: 1.0}
      numerics: {points_per_depth: 24}
    axes: {product: {cut_depth: [0.5 mm, 0.6 mm, 0.7 mm, 0.8 mm]}}
  tension:
    base: {kind: dem_tension, packing: {width: 0.2 mm, height: 0.4 mm}, strain_max: 1e-5}
figures:
  nairn2015_fig08: [cuts]
  yang2018_fig05: [tension]
"""
DATASETS = [f"results/datasets/{name}.nc" for name in ("nairn2015_fig08", "yang2018_fig05")]
APART = ("batch_minutes=0",)
"""Makes a job of every case."""


def assert_same(found, expected):
    assert set(found) == set(expected)
    for key, result in expected.items():
        assert found[key].identical(result), key


@pytest.fixture(scope="module")
def calm(tmp_path_factory, cluster):
    """Return a project that ran undisturbed on this machine."""
    project = Project(tmp_path_factory.mktemp("calm"), STUDY)
    done = project.local("runs", *DATASETS)
    assert done.returncode == 0, done.stdout
    return project


@pytest.fixture
def project(tmp_path, calm):
    """Return a project with compiled kernels and nothing else."""
    fresh = Project(tmp_path, STUDY)
    shutil.copytree(calm.root / "results" / "kernels", fresh.root / "results" / "kernels")
    return fresh


@pytest.fixture
def cases(calm):
    """Return the names of the cuts and the tension test."""
    study = load_study(calm.root / "workflow" / "config" / "mine.yaml")
    return [case for sweep in study.cases().values() for case in sweep]


def test_every_number_is_the_same_through_slurm(tmp_path, calm, cluster):
    remote = Project(tmp_path, STUDY)
    before = set(cluster.jobs())
    done = remote.slurm("runs", *DATASETS)
    assert done.returncode == 0, done.stdout
    assert_same(remote.numbers(), calm.numbers())
    for path in DATASETS:
        found, expected = (read(project.root / path) for project in (remote, calm))
        assert found.drop_attrs().drop_vars("wall_time").identical(expected.drop_attrs().drop_vars("wall_time"))
    states = {comment: state for job, (state, comment) in cluster.jobs().items() if job not in before}
    assert set(states.values()) == {"COMPLETED"}
    assert sum(comment.startswith("rule_simulate") for comment in states) == 2


def job_of(cluster, case, state="RUNNING"):
    """Id of the newest job of a case in a state."""
    jobs = [job for job, (found, comment) in cluster.jobs().items() if comment.endswith(case) and found == state]
    return max(jobs, key=int, default=None)


def test_jobs_that_slurm_ends_are_tried_again_with_more_and_then_reported(project, cases, calm, cluster):
    cancelled, killed, late, hopeless, tension = cases
    memory = "simulate:mem_mb=(30 if attempt == 1 else 1500) if 'dem' in wildcards.batch else 600 * attempt"
    with project.running("runs", "--retries", "1", "--set-resources", memory, config=APART) as process:
        first = {}
        for case in (late, cancelled, killed, hopeless):
            wait_for(lambda case=case: project.started(case))
            first[case] = job_of(cluster, case)
            if case == killed:
                assert kill_processes(first[case])
            elif case == late:
                cluster.ask("scontrol", "update", f"JobId={first[case]}", "EndTime=now")
            else:
                cluster.ask("scancel", first[case])
        wait_for(lambda: project.started(hopeless, times=2))
        cluster.ask("scancel", job_of(cluster, hopeless))
        text = process.communicate(timeout=400)[0]

    assert process.returncode != 0
    assert f"simulate, case-{hopeless}" in text
    states = {case: cluster.facts(job)["JobState"] for case, job in first.items()}
    assert states == {cancelled: "CANCELLED", killed: "FAILED", late: "TIMEOUT", hopeless: "CANCELLED"}
    for case in (cancelled, killed, late, tension):
        again = cluster.facts(job_of(cluster, case, "COMPLETED"))
        assert again["JobState"] == "COMPLETED"
    before, after = (cluster.facts(job) for job in (first[late], job_of(cluster, late, "COMPLETED")))
    assert after["MinMemoryNode"] == "1200M"
    assert before["MinMemoryNode"] == "600M"
    assert after["TimeLimit"] == "00:20:00"
    expected = {key: result for key, result in calm.numbers().items() if not key.startswith(hopeless)}
    assert_same(project.numbers(), expected)


def test_kill_9_of_snakemake_while_its_jobs_go_on(project, cases, calm, cluster):
    with project.running("runs", config=APART) as process:
        wait_for(lambda: project.started(cases[0]))
        process.kill()
        process.wait()
    assert cluster.jobs("running,pending")
    done = project.slurm("runs", config=APART)
    assert done.returncode == 0, done.stdout
    wait_for(lambda: not cluster.jobs("running,pending,completing"))
    assert_same(project.numbers(), calm.numbers())
    assert "0 cases to simulate" in project.local("--dry-run", "runs").stdout
    assert not list(project.root.rglob("*.part"))
    assert not list((project.root / "results" / "store").glob("*checkpoint*"))


def test_one_batch_on_workers_that_are_jobs_of_their_own(project, calm, cluster):
    before = set(cluster.jobs())
    done = project.local("runs", config=("cluster=slurm",))
    assert done.returncode == 0, done.stdout
    assert_same(project.numbers(), calm.numbers())
    workers = [cluster.facts(job) for job in set(cluster.jobs()) - before]
    assert len(workers) > 1
    assert {(facts["JobName"], facts["TimeLimit"]) for facts in workers} == {("dask-worker", "00:10:00")}
    assert not list(project.root.glob("slurm-*.out"))
