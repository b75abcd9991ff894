"""Slurm for the tests of this folder, and projects that run through it."""

import contextlib
import os
import signal
import subprocess
import sys
import time

import psutil
import pytest
from slurm.cluster import CPUS, Cluster, reason_to_skip
from workflow.conftest import copy_project

from orthocut.io.store import Store

SLURM = ("--profile", "workflow/profiles/slurm", "--jobs", str(CPUS), "--slurm-status-command", "squeue")
IMPATIENT = ("--slurm-init-seconds-before-status-checks", "1", "--latency-wait", "5")


class Project:
    """A copy of the project; the installed sources run, whose compiled kernels are in the cache."""

    def __init__(self, folder, study=None):
        self.root = copy_project(folder).root
        self.study = "smoke"
        if study is not None:
            self.study = "mine"
            (self.root / "workflow" / "config" / "mine.yaml").write_text(study, encoding="utf-8")

    def local(self, *arguments, config=()):
        """Run on this machine; return the finished process, stdout and stderr joined."""
        return self._run("--cores", "2", *arguments, config=config)

    def slurm(self, *arguments, config=()):
        """Run through Slurm; return the finished process, stdout and stderr joined."""
        return self._run(*SLURM, *IMPATIENT, *arguments, config=config)

    @contextlib.contextmanager
    def running(self, *arguments, config=()):
        """Run through Slurm in the background; kill what is left of snakemake, but not its jobs, at the end."""
        process = subprocess.Popen(
            self._command(*SLURM, *IMPATIENT, *arguments, config=config),
            cwd=self.root,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )
        try:
            yield process
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.communicate()

    def started(self, case, times=1):
        """Whether a case has started a number of times."""
        path = self.root / "results" / "progress" / f"case-{case}.jsonl"
        return path.exists() and path.read_text(encoding="utf-8").count('"start"') >= times

    def numbers(self):
        """Key to result with its snapshots, without what differs between runs."""
        store = Store(self.root / "results" / "store")
        return {key: store.read(key, snapshots=True).drop_attrs() for key in store.names()}

    def _run(self, *arguments, config):
        return subprocess.run(
            self._command(*arguments, config=config),
            cwd=self.root,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=560,
            check=False,
        )

    def _command(self, *arguments, config):
        return [sys.executable, "-m", "snakemake", *arguments, "--config", f"study={self.study}", *config]


@pytest.fixture(scope="session")
def cluster(tmp_path_factory):
    """Return a running Slurm."""
    if reason := reason_to_skip():
        pytest.skip(reason)
    running = Cluster(tmp_path_factory.mktemp("slurm"))
    try:
        running.start()
        yield running
    finally:
        running.stop()


def wait_for(condition, seconds=300):
    """Wait until something is true and return it; fail if it does not come true in time."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if found := condition():
            return found
        time.sleep(0.05)
    raise AssertionError("it did not happen in time")


def kill_processes(job):
    """Kill -9 every process of a job that runs Python; return how many there were."""
    killed = 0
    for process in psutil.process_iter():
        with contextlib.suppress(psutil.Error):
            if process.environ().get("SLURM_JOB_ID") == job and "python" in process.name():
                process.kill()
                killed += 1
    return killed
