"""What a store holds of a plan, what is missing, and how long that will take on this machine."""

from __future__ import annotations

import hashlib
import json
import statistics
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from orthocut.cost import estimate_memory, estimate_seconds
from orthocut.io import machine
from orthocut.io.files import write_text
from orthocut.io.store import Entry, Store
from orthocut.params.identity import canonical, result_key
from orthocut.plan import Plan

STATES = ("done", "failed", "stale", "missing")
MOST_CASES = 2000
"""Cases of one batch."""


class Job(NamedTuple):
    """One case to simulate."""

    case_id: str
    case: str
    """Canonical JSON."""
    snapshots: int
    seconds: float
    """Predicted run time [s]."""
    memory_mb: int
    """Predicted memory [MB]."""


class Batch(NamedTuple):
    """Cases that one job of the workflow simulates, longest first."""

    name: str
    jobs: list[Job]

    @property
    def seconds(self) -> float:
        """Predicted run time of all cases, one after another [s]."""
        return sum(job.seconds for job in self.jobs)

    @property
    def method(self) -> str:
        """Return ``mpm`` or ``dem``."""
        return self.jobs[0].case_id.split("-")[0]

    @property
    def memory_mb(self) -> int:
        """Predicted memory of the largest case [MB]."""
        return max(job.memory_mb for job in self.jobs)

    def write(self, folder: Path) -> None:
        """Write the batch for the job that will run it."""
        write_text(json.dumps(self.jobs), folder / f"{self.name}.json")


def read_batch(path: Path) -> Batch:
    """Read a batch that `Batch.write` wrote."""
    return Batch(path.stem, [Job(*row) for row in json.loads(path.read_text(encoding="utf-8"))])


@dataclass(frozen=True)
class Survey:
    """State of the cases of a plan."""

    plan: Plan
    entries: dict[str, Entry]
    """Case id to what its result tells, for cases that are done or failed."""
    states: dict[str, str]
    """Case id to one of `STATES`; a case whose snapshots are missing counts as missing."""
    factors: dict[str, float]
    """Kind to measured over predicted run time on the machines that filled the store."""
    machine: dict[str, float]
    """Method to the same of a step, as it was measured on this machine; for kinds that the store does not know."""

    def seconds(self, case_id: str) -> float:
        """Run time of a case on one core: measured if it is done, else predicted [s]."""
        if case_id in self.entries:
            return self.entries[case_id].seconds
        case = self.plan.cases[case_id]
        return estimate_seconds(case) * self._factor(case.kind)

    def _factor(self, kind: str) -> float:
        """Measured over predicted run time of a kind, as far as it is known; of all kinds, or 1, where it is not."""
        overall = statistics.median(self.factors.values()) if self.factors else 1.0
        return self.factors.get(kind, self.machine.get(kind.split("_")[0], overall))

    @property
    def counts(self) -> dict[str, int]:
        """State to number of cases."""
        found = list(self.states.values())
        return {state: found.count(state) for state in STATES}

    @property
    def missing(self) -> list[str]:
        """Cases to simulate."""
        return [case_id for case_id, state in self.states.items() if state in ("stale", "missing")]

    @property
    def seconds_left(self) -> float:
        """Predicted run time of all that is missing, on one core [s]."""
        return sum(self.seconds(case_id) for case_id in self.missing)

    def announcement(self) -> dict[str, tuple[str, float]]:
        """Missing case to label and predicted run time, for the display of progress."""
        return {case_id: (self.plan.labels[case_id], self.seconds(case_id)) for case_id in self.missing}

    def summary(self) -> str:
        """What there is to do, in one line."""
        counts = self.counts
        present = f"{counts['done']} done" + (f", {counts['failed']} failed" if counts["failed"] else "")
        stale = f" ({counts['stale']} of them stale)" if counts["stale"] else ""
        return f"{len(self.missing)} cases to simulate{stale}, {self.seconds_left:.0f} s on one core; {present}"

    def batches(self, cores: int, minutes: float) -> list[Batch]:
        """Share out what is missing.

        Parameters
        ----------
        cores : int
            Cores that one batch uses.
        minutes : float
            Predicted run time of a batch on these cores; a case that takes longer by itself is a batch of its own.
        """
        jobs = [
            Job(case_id, canonical(case), self.plan.snapshots[case_id], self.seconds(case_id), estimate_memory(case))
            for case_id, case in ((case_id, self.plan.cases[case_id]) for case_id in self.missing)
        ]
        room = 60 * minutes
        long = [[job] for job in jobs if job.seconds > room]
        short = [job for job in jobs if job.seconds <= room]
        return [_batch(group) for group in long + list(_groups(short, room * cores))]


def survey(plan: Plan, store: Store) -> Survey:
    """Look for every case of a plan in a store; broken files are named and set aside."""
    known = store.names()
    present, others = set(known), {key.rpartition("-")[0] for key in known}
    entries: dict[str, Entry] = {}
    states: dict[str, str] = {}
    ratios: dict[str, list[float]] = {}
    for case_id, case in plan.cases.items():
        key = result_key(case)
        entry = store.entry(key) if key in present else None
        if entry is None:
            states[case_id] = "stale" if case_id in others and key not in present else "missing"
            continue
        entries[case_id] = entry
        short = entry.status == "done" and plan.snapshots[case_id] > 0
        states[case_id] = "missing" if short and store.snapshots(key) < plan.snapshots[case_id] else entry.status
        if entry.status == "done":
            ratios.setdefault(case.kind, []).append(entry.seconds / estimate_seconds(case))
    factors = {kind: statistics.median(found) for kind, found in ratios.items()}
    return Survey(plan, entries, states, factors, machine.factors())


def _groups(jobs: Iterable[Job], room: float) -> Iterable[list[Job]]:
    """Neighbours in the order of the study, of one method, up to the predicted run time `room` [s]."""
    by_method: dict[str, list[Job]] = {}
    for job in jobs:
        by_method.setdefault(job.case_id.split("-")[0], []).append(job)
    for members in by_method.values():
        group: list[Job] = []
        for job in members:
            if group and (len(group) == MOST_CASES or sum(one.seconds for one in group) + job.seconds > room):
                yield group
                group = []
            group.append(job)
        yield group


def _batch(jobs: list[Job]) -> Batch:
    """Name a group: by its case if it is one, else by a hash."""
    jobs = sorted(jobs, key=lambda job: -job.seconds)
    if len(jobs) == 1:
        return Batch(f"case-{jobs[0].case_id}", jobs)
    digest = hashlib.sha256(json.dumps([(job.case, job.snapshots) for job in jobs]).encode()).hexdigest()[:10]
    return Batch(f"batch-{jobs[0].case_id.split('-')[0]}-{digest}", jobs)


def as_rows(found: Survey) -> list[dict[str, Any]]:
    """One row a case for people and programs."""
    return [_row(found, case_id) for case_id in found.plan.cases]


def _row(found: Survey, case_id: str) -> Mapping[str, Any]:
    entry = found.entries.get(case_id)
    return {
        "case_id": case_id,
        "label": found.plan.labels[case_id],
        "state": found.states[case_id],
        "seconds": found.seconds(case_id),
        "reason": entry.reason if entry else "",
    }
