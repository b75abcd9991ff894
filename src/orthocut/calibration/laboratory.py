"""Simulate cases into a store, in this process or in some that stay; what the store holds is not simulated again."""

from __future__ import annotations

import multiprocessing
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import xarray as xr

from orthocut.calibration.trial import Simulate, Test
from orthocut.cost import estimate_memory, estimate_seconds
from orthocut.io.events import Events
from orthocut.io.store import Store
from orthocut.params.block import CaseFailed
from orthocut.params.identity import canonical, case_id, result_key
from orthocut.survey import Job
from orthocut.sweep import simulate_job


@contextmanager
def laboratory(store: Store, events: Path, workers: int) -> Iterator[Simulate]:
    """Give a function that simulates cases.

    Parameters
    ----------
    store : Store
    events : Path
        File that tells what happens, one JSON object a line.
    workers : int
        Number of processes, one core each.
    """
    if workers == 1:
        yield lambda cases: _simulate(cases, store, events, None)
        return
    with ProcessPoolExecutor(workers, multiprocessing.get_context("spawn")) as pool:
        yield lambda cases: _simulate(cases, store, events, pool)


def _simulate(cases: Sequence[Test], store: Store, events: Path, pool: Executor | None) -> list[xr.Dataset]:
    jobs = [Job(case_id(case), canonical(case), 0, estimate_seconds(case), estimate_memory(case)) for case in cases]
    longest_first = sorted(jobs, key=lambda job: -job.seconds)
    entries = list((pool.map if pool else map)(_run, longest_first, *_repeated(len(jobs), store, events)))
    for job, entry in zip(longest_first, entries, strict=True):
        if entry.status != "done":
            raise CaseFailed(f"{job.case_id}: {entry.reason}")
    return [store.read(result_key(case)) for case in cases]


def _repeated(count: int, *values: object) -> list[list[object]]:
    return [[value] * count for value in values]


def _run(job: Job, store: Store, events: Path):
    return simulate_job(job, store, Events(events))
