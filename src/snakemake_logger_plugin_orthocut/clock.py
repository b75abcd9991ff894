"""Counts of cases and the time left: predictions, corrected by the cases that are done."""

from __future__ import annotations

import time
from collections.abc import Mapping


def words(seconds: float) -> str:
    """Duration in words."""
    if seconds < 60:
        return f"{seconds:.1f} s" if seconds < 10 else f"{seconds:.0f} s"
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest:02d} s" if minutes < 60 else f"{minutes // 60} h {minutes % 60:02d} min"


def kind(case: str) -> str:
    """Return the kind in a case id, such as ``dem-cutting``."""
    return case.rpartition("-")[0]


class Clock:
    """Counts jobs and cases and estimates the time left.

    Attributes
    ----------
    cores : int
        Number of cases that run at once.
    ended : dict
        Case id to run time [s], of all cases that are done or failed.
    failed, lost : set of str
        Cases that failed by their own numbers, and that ended without a result.
    """

    def __init__(self) -> None:
        self.cores = 1
        self.cases: dict[str, tuple[str, float]] = {}
        self.jobs_total = self.jobs_done = 0
        self.failed: set[str] = set()
        self.lost: set[str] = set()
        self.ended: dict[str, float] = {}
        self._running: dict[str, tuple[float, float]] = {}

    def announce(self, cases: Mapping[str, tuple[str, float]]) -> None:
        """Take note of the cases that will be simulated: id to label and predicted seconds."""
        self.cases = dict(cases)

    def begin(self, jobs: int, simulations: int) -> None:
        """Take note of how many jobs will run; without simulations among them, no case will."""
        self.jobs_total = jobs
        if not simulations:
            self.cases = {}

    def label(self, case: str) -> str:
        """Return what a case is, in words."""
        return self.cases[case][0] if case in self.cases else case

    def start(self, case: str) -> None:
        """Note the start of a case."""
        self._running[case] = (time.monotonic(), 0.0)

    def advance(self, case: str, fraction: float) -> None:
        """Note which fraction of a running case is done."""
        begun, _ = self._running.get(case, (time.monotonic(), 0.0))
        self._running[case] = (begun, fraction)

    def finish(self, case: str, seconds: float, failed: bool = False) -> None:
        """Note the end of a case."""
        self._running.pop(case, None)
        self.lost.discard(case)
        self.ended[case] = seconds
        if failed:
            self.failed.add(case)

    def lose(self, case: str) -> None:
        """Note that a case ended without a result."""
        self._running.pop(case, None)
        self.lost.add(case)

    @property
    def counts(self) -> str:
        """Cases done, running, failed and lost, in words."""
        text = f"{len(self.ended)}/{max(len(self.cases), len(self.ended))} cases"
        text += f", {len(self._running)} running" if self._running else ""
        text += f", {len(self.failed)} failed" if self.failed else ""
        return text + (f", {len(self.lost)} lost" if self.lost else "")

    def _scale(self, wanted: str) -> float:
        """Measured over predicted seconds of the finished cases of a kind; 1 before there are any."""
        known = [case for case, seconds in self.ended.items() if seconds > 0 and kind(case) == wanted]
        guess = sum(self.cases[case][1] for case in known if case in self.cases)
        return sum(self.ended[case] for case in known if case in self.cases) / guess if guess > 0 else 1.0

    def seconds_left(self) -> float:
        """Estimate of the time until the last simulation ends [s]."""
        scales = {name: self._scale(name) for name in {kind(case) for case in self.cases}}
        now, work = time.monotonic(), []
        for case, (_, seconds) in self.cases.items():
            if case in self.ended or case in self.lost:
                continue
            expected = seconds * scales[kind(case)]
            if case in self._running:
                begun, fraction = self._running[case]
                spent = now - begun
                expected = spent * (1 - fraction) / fraction if fraction > 0.05 else max(expected - spent, 0.0)
            work.append(expected)
        return max(sum(work) / self.cores, max(work, default=0.0))

    def left(self) -> str:
        """Return the time left in words, rounded as it deserves."""
        if len(self.ended) + len(self.lost) >= len(self.cases):
            return "no simulations left"
        seconds = self.seconds_left()
        rounded = 5 * round(seconds / 5) if seconds < 120 else 30 * round(seconds / 30)
        return f"about {words(max(rounded, 5)).replace('.0', '')} left"
