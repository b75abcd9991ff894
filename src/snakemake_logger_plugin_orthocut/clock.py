"""Time left of a workflow: rough estimates of the cases, corrected by those that are done."""

from __future__ import annotations

import time
from collections.abc import Mapping


def words(seconds: float) -> str:
    """Duration in words."""
    if seconds < 60:
        return f"{seconds:.1f} s" if seconds < 10 else f"{seconds:.0f} s"
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest:02d} s" if minutes < 60 else f"{minutes // 60} h {minutes % 60:02d} min"


def method(case: str) -> str:
    """Return the kind in a case id, such as ``dem-cutting``."""
    return case.rpartition("-")[0]


class Clock:
    """Counts jobs and cases and estimates the time left.

    Attributes
    ----------
    cores : int
        Number of jobs that run at once.
    """

    def __init__(self) -> None:
        self.cores = 1
        self.cases: dict[str, tuple[str, float]] = {}
        self.jobs_total = self.jobs_done = self.cases_total = self.cases_done = 0
        self._running: dict[str, float] = {}
        self._finished: dict[str, float] = {}

    def announce(self, cases: Mapping[str, tuple[str, float]]) -> None:
        """Take note of all cases of the study: id to label and estimated seconds."""
        self.cases = dict(cases)

    def begin(self, cases: int, jobs: int) -> None:
        """Take note of how many simulations and jobs will run."""
        self.cases_total, self.jobs_total = cases, jobs

    def label(self, case: str) -> str:
        """Return what a case is, in words."""
        return self.cases[case][0] if case in self.cases else case

    def start(self, case: str) -> None:
        """Note the start of a job, and of its case if it has one."""
        if case:
            self._running[case] = time.monotonic()

    def finish(self, case: str, seconds: float) -> None:
        """Note the end of a job."""
        self.jobs_done += 1
        if case:
            self.cases_done += 1
            self._running.pop(case, None)
            self._finished[case] = seconds

    def give_up(self, case: str) -> None:
        """Note that a case failed: nothing is left to do for it."""
        if self._running.pop(case, None) is not None:
            self.cases_total -= 1

    def _scale(self, kind: str) -> float:
        """Measured over estimated seconds of the finished cases of a kind, of all kinds, or 1."""
        for chosen in (lambda case: method(case) == kind, lambda case: True):
            known = [case for case in self._finished if case in self.cases and chosen(case)]
            guess = sum(self.cases[case][1] for case in known)
            if guess > 0:
                return sum(self._finished[case] for case in known) / guess
        return 1.0

    def seconds_left(self) -> float:
        """Estimate of the time until the last simulation ends [s]."""
        expected = {case: seconds * self._scale(method(case)) for case, (_, seconds) in self.cases.items()}
        waiting = [case for case in self.cases if case not in self._finished and case not in self._running]
        count = max(self.cases_total - self.cases_done - len(self._running), 0)
        now = time.monotonic()
        work = [max(expected.get(case, 0.0) - (now - begun), 0.0) for case, begun in self._running.items()]
        if waiting:
            work += [sum(expected[case] for case in waiting) / len(waiting)] * count
        return max(sum(work) / self.cores, max(work, default=0.0))

    def left(self) -> str:
        """Return the time left in words, rounded as it deserves."""
        seconds = self.seconds_left()
        if self.cases_done == self.cases_total:
            return "no simulations left"
        rounded = 5 * round(seconds / 5) if seconds < 120 else 30 * round(seconds / 30)
        return f"about {words(max(rounded, 5)).replace('.0', '')} left"
