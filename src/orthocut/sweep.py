"""Simulate cases into a store: one in this process, or many by warm worker processes."""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from orthocut.io.checkpoint import Checkpoint
from orthocut.io.datasets import failed
from orthocut.io.events import Events
from orthocut.io.store import CHECKPOINT, Entry, Store
from orthocut.params.block import CaseFailed
from orthocut.params.case import validate
from orthocut.params.identity import result_key
from orthocut.run import run_case
from orthocut.survey import Batch, Job

if TYPE_CHECKING:
    import distributed

_PATIENCE = 5.0  # seconds between reports of how far a case is
_ALLOWED_FAILURES = 2  # times that a worker may die of a case


class Interrupted(RuntimeError):
    """Cases of a batch could not be run, for reasons that are not theirs; all others are in the store."""


def simulate_job(job: Job, store: Store, events: Events) -> Entry:
    """Simulate a case into a store, unless it is there already; go on from its checkpoint if it has one.

    A case that fails by its own numbers is stored as failed.

    Raises
    ------
    OSError
        If the result cannot be written.
    """
    case = validate(json.loads(job.case), job.case_id)
    key = result_key(case)
    if store.holds(key, job.snapshots):
        entry = store.entry(key)
        events.tell("done" if entry.status == "done" else "failed", case=job.case_id, seconds=0.0, reason=entry.reason)
        return entry

    events.tell("start", case=job.case_id)
    started = reported = time.monotonic()

    def progress(fraction: float) -> None:
        nonlocal reported
        if time.monotonic() - reported > _PATIENCE:
            reported = time.monotonic()
            events.tell("fraction", case=job.case_id, fraction=fraction)

    checkpoint = Checkpoint(store.path(key, CHECKPOINT), key)
    try:
        dataset = run_case(case, progress, checkpoint, job.snapshots)
    except CaseFailed as error:
        dataset = failed(case, " ".join(str(error).split()), checkpoint.seconds)
    entry = store.put(case, dataset, job.snapshots)
    checkpoint.remove()
    seconds = time.monotonic() - started
    events.tell("done" if entry.status == "done" else "failed", case=job.case_id, seconds=seconds, reason=entry.reason)
    return entry


def run_batch(
    batch: Batch, store: Store, events: Events, workers: int, memory_mb: int, cluster: str = "local", minutes: int = 60
) -> list[Entry]:
    """Simulate the cases of a batch, longest first.

    Parameters
    ----------
    batch : Batch
    store : Store
    events : Events
    workers : int
        Number of worker processes, one core each; with one, the cases run in this process.
    memory_mb : int
        Memory of all workers together [MB]; a worker that needs more than its share is ended.
    cluster : str
        ``local``, or ``slurm``: the workers are Slurm jobs of their own, on any nodes.
    minutes : int
        Time limit of such a job [min].

    Raises
    ------
    Interrupted
        After all other cases, if workers died of a case or results could not be written.
    """
    workers = min(workers, len(batch.jobs))
    entries, lost = [], []

    def lose(job: Job, why: str) -> None:
        lost.append(f"{job.case_id}: {why}")
        events.tell("lost", case=job.case_id, reason=why)

    if workers == 1 and cluster == "local":
        for job in batch.jobs:
            try:
                entries.append(simulate_job(job, store, events))
            except Exception as error:
                lose(job, f"{type(error).__name__}: {error}")
        return _all(entries, lost, batch)

    from distributed import Client, as_completed

    logs = events.path.with_suffix("")
    with _cluster(cluster, workers, memory_mb, minutes, logs) as running, Client(running) as client:
        events.tell("dashboard", address=client.dashboard_link)
        futures = {
            client.submit(_simulate_alone, job, store, events, key=job.case_id, priority=-rank, pure=False): job
            for rank, job in enumerate(batch.jobs)
        }
        for future in as_completed(futures):
            job = futures[future]
            if future.status == "finished":
                entries.append(future.result())
            else:
                lose(job, _why(future))
    return _all(entries, lost, batch)


def _all(entries: list[Entry], lost: list[str], batch: Batch) -> list[Entry]:
    """Return what became of the cases of a batch if none was lost."""
    if lost:
        raise Interrupted(f"{len(lost)} of {len(batch.jobs)} cases could not be run: {'; '.join(lost)}")
    return entries


def _simulate_alone(job: Job, store: Store, events: Events) -> Entry:
    """Simulate a case in a worker, where xarray would ask the scheduler for a lock at each access to a file."""
    import dask

    with dask.config.set(scheduler="synchronous"):
        return simulate_job(job, store, events)


def _why(future: distributed.Future) -> str:
    """Why a case has no result."""
    error = future.exception()
    if type(error).__name__ == "KilledWorker":
        return f"its worker died {_ALLOWED_FAILURES + 1} times; out of memory?"
    return f"{type(error).__name__}: {error}"


@contextmanager
def _cluster(kind: str, workers: int, memory_mb: int, minutes: int, logs: Path) -> Iterator[distributed.deploy.Cluster]:
    """Worker processes with one thread each, which start once and keep their compiled kernels."""
    import dask
    from distributed import LocalCluster

    share = f"{memory_mb / workers:.0f}MB"
    settings = {
        "distributed.scheduler.allowed-failures": _ALLOWED_FAILURES,
        "distributed.scheduler.work-stealing": False,
        "distributed.comm.timeouts.connect": "60s",
    }
    with tempfile.TemporaryDirectory(prefix="orthocut-") as scratch, dask.config.set(settings):
        if kind == "slurm":
            from dask_jobqueue import SLURMCluster

            options = {"cores": 1, "processes": 1, "memory": share, "walltime": str(minutes)}
            with SLURMCluster(**options, local_directory=scratch, log_directory=str(logs)) as cluster:
                cluster.scale(workers)
                yield cluster
        else:
            options = {"n_workers": workers, "threads_per_worker": 1, "memory_limit": share}
            with LocalCluster(**options, dashboard_address="127.0.0.1:0", local_directory=scratch) as cluster:
                yield cluster
