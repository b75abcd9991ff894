"""What goes wrong on real machines: after each fault a plain rerun completes, with nothing lost and nothing wrong."""

import contextlib
import os
import signal
import subprocess
import sys
import time

import psutil
import pytest
from workflow.conftest import copy_project

from orthocut.io.store import Store

pytestmark = pytest.mark.xdist_group("faults")

STUDY = """
title: Four short cuts and a long one
sweeps:
  short:
    base: &cut
      kind: mpm_cutting
      travel_ratio: 1.5
      window_ratio: 0.5
      workpiece: {length_ratio: 6.0, base_ratio: 1.0, notch_ratio: 1.0}
      numerics: {points_per_depth: 4}
    axes: {product: {cut_depth: [0.5 mm, 0.6 mm, 0.7 mm, 0.8 mm]}}
  long:
    base: {<<: *cut, numerics: {points_per_depth: 16}}
figures:
  nairn2015_fig08: [short, long]
"""


def twin(folder):
    """Return a copy of the project, without results, that has the study."""
    project = copy_project(folder)
    (project.root / "workflow" / "config" / "faults.yaml").write_text(STUDY, encoding="utf-8")
    return project


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """Return the numbers of an undisturbed run."""
    project = twin(tmp_path_factory.mktemp("undisturbed"))
    done = project.snakemake(study="faults", copied=False)
    assert done.returncode == 0, done.stdout
    return numbers(project)


@pytest.fixture
def project(tmp_path):
    return twin(tmp_path)


def numbers(project, store=None):
    """Key to result, without what differs between runs."""
    store = Store(store or project.root / "results" / "store")
    return {key: store.read(key).drop_attrs() for key in store.names()}


def check(project, expected, store=None):
    """A plain rerun completes, gives the undisturbed numbers, and leaves nothing to do and no debris."""
    done = project.snakemake(study="faults", copied=False)
    assert done.returncode == 0, done.stdout
    found = numbers(project, store)
    assert set(found) == set(expected)
    for key, result in expected.items():
        assert found[key].identical(result)
    assert project.planned("faults") == {}
    assert not list(project.root.rglob("*.part"))


@contextlib.contextmanager
def running(project, *config):
    """Run the workflow in a process group of its own."""
    command = [sys.executable, "-m", "snakemake", "--cores", "2", "--config", "study=faults", *config]
    process = subprocess.Popen(
        command, cwd=project.root, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True, text=True
    )
    try:
        yield process
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def wait_for(condition, seconds=60):
    """Wait until something is true; fail if it does not come true in time."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if found := condition():
            return found
        time.sleep(0.02)
    raise AssertionError("it did not happen in time")


def started(project):
    """Whether a case has started."""
    return any("start" in path.read_text() for path in (project.root / "results/progress").glob("*.jsonl"))


def workers(process):
    """Worker processes of a workflow that has started its batch."""
    children = psutil.Process(process.pid).children(recursive=True)
    return [child for child in children if "spawn_main" in " ".join(child.cmdline())]


def test_kill_9_of_the_whole_workflow(project, expected):
    with running(project) as process:
        wait_for(lambda: started(project))
        time.sleep(0.7)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        for child in psutil.process_iter(["cwd"]):
            if child.info["cwd"] and child.info["cwd"].startswith(str(project.root)):
                child.kill()
    before = {key: (project.root / f"results/store/{key}.nc").stat().st_mtime_ns for key in numbers(project)}
    check(project, expected)
    for key, written in before.items():
        assert (project.root / f"results/store/{key}.nc").stat().st_mtime_ns == written


def test_kill_9_of_a_worker(project, expected):
    with running(project) as process:
        wait_for(lambda: started(project))
        workers(process)[-1].kill()
        text = process.communicate(timeout=120)[0]
    assert process.returncode == 0, text
    check(project, expected)


@contextlib.contextmanager
def mounted(folder, *options):
    """File system in memory, or skip where we may not mount any."""
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", ",".join(options), "tmpfs", folder], capture_output=True, check=False
    )
    if done.returncode:
        pytest.skip("mounting a file system needs to be root")
    try:
        yield
    finally:
        subprocess.run(["umount", "-l", folder], check=True)


def test_full_disk(project, expected):
    with mounted(project.root / "results" / "store", "size=24k"):
        done = project.snakemake(study="faults", copied=False)
        assert done.returncode != 0
        assert "No space left on device" in done.stdout, done.stdout
        assert not list((project.root / "results/store").glob(".*"))
    check(project, expected)


def test_read_only_store(project, expected):
    assert project.snakemake(study="faults", copied=False).returncode == 0
    folder = project.root / "results" / "store"
    lost = next(iter(expected))
    content = (folder / f"{lost}.nc").read_bytes()
    subprocess.run(["cp", "-r", folder, project.root / "copy"], check=True)
    (project.root / "copy" / f"{lost}.nc").unlink()
    with mounted(folder, "size=10m"):
        subprocess.run(["cp", "-r", f"{project.root}/copy/.", folder], check=True)
        subprocess.run(["mount", "-o", "remount,ro", folder], check=True)
        (project.root / "results/figures/nairn2015_fig08.png").unlink()
        done = project.snakemake("nairn2015_fig08", study="faults", copied=False)
        assert done.returncode == 0, done.stdout
        done = project.snakemake(study="faults", copied=False)
        assert done.returncode != 0
        assert "Read-only file system" in done.stdout, done.stdout
    assert (folder / f"{lost}.nc").read_bytes() == content
    check(project, expected)


def test_two_workflows_on_one_store_at_once(tmp_path, expected):
    projects = [twin(tmp_path / name) for name in "ab"]
    store = tmp_path / "store"
    processes = []
    with contextlib.ExitStack() as stack:
        for project in projects:
            processes.append(stack.enter_context(running(project, f"store={store}")))
        for process in processes:
            text = process.communicate(timeout=200)[0]
            assert process.returncode == 0, text
    found = numbers(projects[0], store)
    assert set(found) == set(expected)
    assert all(found[key].identical(expected[key]) for key in expected)


@pytest.mark.parametrize("hours", [-48, 48])
def test_the_clock_jumps(project, expected, hours):
    assert project.snakemake(study="faults", copied=False).returncode == 0
    for path in (project.root / "results").rglob("*"):
        if path.is_file() and path.stat().st_ino % 2:
            then = time.time() + 3600 * hours
            os.utime(path, (then, then))
    done = project.snakemake(study="faults", copied=False)
    assert done.returncode == 0, done.stdout
    assert "cases to simulate" not in done.stdout or "0 cases to simulate" in done.stdout
    check(project, expected)
