"""Batches in this process: a case that cannot be run costs no other one."""

import json

import pytest

from orthocut import sweep
from orthocut.io.store import Store
from orthocut.survey import Batch, Job


class Told(list):
    def tell(self, event, **facts):
        self.append((event, facts))


def test_a_case_that_breaks_the_process_does_not_keep_the_others_from_being_run(monkeypatch, tmp_path):
    jobs = [
        Job(case_id=name, case=json.dumps({}), snapshots=0, seconds=1.0, memory_mb=10)
        for name in ("mpm-a", "mpm-b", "mpm-c")
    ]
    done, events = [], Told()

    def simulate(job, store, events):
        if job.case_id == "mpm-a":
            raise IndexError("no such disc")
        done.append(job.case_id)

    monkeypatch.setattr(sweep, "simulate_job", simulate)
    with pytest.raises(sweep.Interrupted, match="1 of 3 cases could not be run: mpm-a: IndexError: no such disc"):
        sweep.run_batch(Batch("batch-1", jobs), Store(tmp_path), events, workers=1, memory_mb=1000)
    assert done == ["mpm-b", "mpm-c"]
    assert events == [("lost", {"case": "mpm-a", "reason": "IndexError: no such disc"})]
