"""What a user sees while the workflow runs: a line for each case and job that ends, counts, and the time left.

Snakemake finds this package by its name (``--logger orthocut``). The workflow announces by a log record which cases it
will simulate (``cases``: case id to words and predicted seconds) and where its batches report (``progress``). Dry runs
and ``--verbose`` look as Snakemake makes them.
"""

from __future__ import annotations

import logging
import sys
import threading
import time
from pathlib import Path
from typing import Any

from snakemake.logging import ColorizingTextHandler, DefaultFilter, DefaultFormatter
from snakemake_interface_logger_plugins.base import LogHandlerBase
from snakemake_interface_logger_plugins.common import LogEvent

from snakemake_logger_plugin_orthocut.clock import Clock, words
from snakemake_logger_plugin_orthocut.feed import Feed

CHATTER = (
    "Assuming unrestricted",
    "Building DAG",
    "Complete log",
    "Conda environments",
    "Provided",
    "Rules claiming",
    "Select jobs",
    "Touching output",
    "Using shell",
)
"""Beginnings of remarks that tell a user nothing."""

REPETITIONS = ("RuleException:\nCalledProcessError", "Exiting because")
"""Beginnings of errors that repeat what the failed job told."""

QUIET = 1.0
"""Least time between two lines on cases that went well [s]; the others are counted in the next line."""


def last_line(path: str) -> str:
    """Last line of a log file: what a failed job said at the end."""
    try:
        lines = Path(path).read_text(encoding="utf-8", errors="replace").split("\n")
    except OSError:
        return "no log"
    return next((line for line in reversed(lines) if line.strip()), "empty log")


class LogHandler(LogHandlerBase):
    """Handler of Snakemake's log records."""

    writes_to_stream = True
    writes_to_file = False
    has_filter = True
    has_formatter = True
    needs_rulegraph = False

    def __post_init__(self) -> None:
        """Prepare; nothing is shown before the first job."""
        settings = self.common_settings
        self.formatter = DefaultFormatter(settings.quiet, settings.show_failed_logs)
        self.plain = None
        if settings.dryrun or settings.verbose:
            chosen = DefaultFilter(
                settings.quiet, settings.debug_dag, settings.verbose, settings.dryrun, settings.printshellcmds
            )
            self.plain = ColorizingTextHandler(settings.nocolor, sys.stderr, self.formatter, chosen)
        self.clock = Clock()
        self.jobs: dict[int, tuple[str, float]] = {}
        self.bar: Any = None
        self.feed: Feed | None = None
        self._told = -QUIET
        self._lock = threading.RLock()
        self._ended = threading.Event()

    def emit(self, record: logging.LogRecord) -> None:
        """Show a record, or take note of it."""
        with self._lock:
            self._emit(record)

    def _emit(self, record: logging.LogRecord) -> None:
        event = getattr(record, "event", None)
        if hasattr(record, "cases"):
            self.clock.announce(record.cases)
            self.feed = Feed(record.progress)
            if self.plain is not None or record.cases:
                self._say(str(record.msg))
        elif self.plain is not None:
            self.plain.handle(record)
        elif event == LogEvent.RESOURCES_INFO and getattr(record, "cores", None):
            self.clock.cores = int(record.cores)
        elif event == LogEvent.RUN_INFO:
            self._begin(record.stats)
        elif event == LogEvent.JOB_INFO:
            self._start(record)
        elif event == LogEvent.JOB_FINISHED:
            self._finish(record.job_id)
        elif event == LogEvent.JOB_ERROR:
            self._fail(record)
        elif record.levelno >= logging.WARNING:
            text = self.formatter.format(record)
            if not text.startswith(REPETITIONS):
                self._say(text)
        elif event is None:
            self._remark(str(record.msg or ""))

    def _remark(self, text: str) -> None:
        if text.startswith("Nothing to be done"):
            self._say("Nothing to do: all results are there and up to date.")
        elif not text.startswith(CHATTER):
            self._say(text)

    def _begin(self, stats: dict[str, int]) -> None:
        self.clock.begin(stats.get("total", 0), stats.get("simulate", 0))
        cases = len(self.clock.cases)
        self._say(f"{self.clock.jobs_total} jobs; {self.clock.left()}")
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

            columns = (BarColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
            self.bar = Progress(*columns, console=Console(stderr=True, highlight=False), transient=True)
            self.task = self.bar.add_task(self.clock.left(), total=max(self.clock.jobs_total + cases, 1))
            self.bar.start()
        if cases:
            threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        """Look for reports of running batches until the workflow ends."""
        while not self._ended.wait(0.3):
            with self._lock:
                self._report()

    def _report(self) -> None:
        """Take note of what running batches have reported since the last time."""
        for event in self.feed.news() if self.feed else ():
            case = str(event.get("case", ""))
            if event["event"] == "start":
                self.clock.start(case)
            elif event["event"] == "fraction":
                self.clock.advance(case, event["fraction"])
            elif event["event"] == "dashboard":
                self._say(f"workers: {event['address']}")
            elif event["event"] == "lost":
                self.clock.lose(case)
                self._say(f"LOST {self.clock.label(case)}: {event['reason']}")
            elif event["event"] in ("done", "failed"):
                self._end(case, event)
        self._refresh()

    def _end(self, case: str, event: dict[str, Any]) -> None:
        """Tell the end of a case: each failure, and the others if there was silence for a while."""
        failed = event["event"] == "failed"
        self.clock.finish(case, event["seconds"], failed)
        if failed:
            self._say(f"FAILED {self.clock.label(case)}: {event['reason']}")
        elif time.monotonic() - self._told >= QUIET:
            self._told = time.monotonic()
            self._say(
                f"{self.clock.label(case)}  ({words(event['seconds'])}; {self.clock.counts}, {self.clock.left()})"
            )

    def _refresh(self) -> None:
        if self.bar is not None:
            done = self.clock.jobs_done + len(self.clock.ended)
            self.bar.update(self.task, completed=done, description=f"{self.clock.counts}, {self.clock.left()}")

    def _start(self, record: logging.LogRecord) -> None:
        values = [str(value) for value in record.wildcards.values()]
        if record.rule_name == "simulate" and self.feed is not None:
            self.feed.follow(values[0])
        self.jobs[record.jobid] = (", ".join([record.rule_name, *values]), time.monotonic())

    def _finish(self, job: int) -> None:
        self._report()
        what, begun = self.jobs.pop(job, ("", time.monotonic()))
        self.clock.jobs_done += 1
        if what and what != "all" and not what.startswith("simulate"):
            seconds = words(time.monotonic() - begun)
            self._say(f"[{self.clock.jobs_done:>3}/{self.clock.jobs_total}] {what}  ({seconds}; {self.clock.left()})")
        self._refresh()

    def _fail(self, record: logging.LogRecord) -> None:
        self._report()
        what, _ = self.jobs.pop(record.jobid, (record.rule_name, 0.0))
        logs = list(record.log or [])
        self._say(f"FAILED {what}: {last_line(logs[0]) if logs else record.msg}  (log: {', '.join(logs)})")

    def _say(self, text: str) -> None:
        if not text:
            return
        if self.bar is not None:
            self.bar.console.print(text, markup=False)
        else:
            print(text, file=sys.stderr, flush=True)

    def close(self) -> None:
        """Remove the bar; count what failed."""
        self._ended.set()
        if self.bar is not None:
            self.bar.stop()
            self.bar = None
        if self.clock.failed:
            print(
                f"{len(self.clock.failed)} cases failed by their own numbers and are holes in the figures; "
                "`orthocut store retry` has them simulated again",
                file=sys.stderr,
            )
            self.clock.failed.clear()
        super().close()
