"""What a user sees while the workflow runs: one line a finished job, how many are done, and the time left.

Snakemake finds this package by its name (``--logger orthocut``). The workflow announces its cases by a log record with
the attribute ``cases``: case id to (words, estimated seconds). Dry runs and ``--verbose`` look as Snakemake makes them.
"""

from __future__ import annotations

import logging
import sys
import time
from pathlib import Path
from typing import Any

from snakemake.logging import ColorizingTextHandler, DefaultFilter, DefaultFormatter
from snakemake_interface_logger_plugins.base import LogHandlerBase
from snakemake_interface_logger_plugins.common import LogEvent

from snakemake_logger_plugin_orthocut.clock import Clock, words

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
        self.jobs: dict[int, tuple[str, str, float]] = {}
        self.bar: Any = None

    def emit(self, record: logging.LogRecord) -> None:
        """Show a record, or take note of it."""
        event = getattr(record, "event", None)
        if hasattr(record, "cases"):
            self.clock.announce(record.cases)
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
        self.clock.begin(stats.get("simulate", 0), stats.get("total", 0))
        self._say(f"{self.clock.jobs_total} jobs, {self.clock.cases_total} of them simulations; {self.clock.left()}")
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

            columns = (
                TextColumn("jobs"),
                BarColumn(),
                MofNCompleteColumn(),
                TimeElapsedColumn(),
                TextColumn("{task.description}"),
            )
            self.bar = Progress(*columns, console=Console(stderr=True, highlight=False), transient=True)
            self.task = self.bar.add_task(self.clock.left(), total=self.clock.jobs_total)
            self.bar.start()

    def _start(self, record: logging.LogRecord) -> None:
        case = record.wildcards.get("case_id", "") if record.rule_name == "simulate" else ""
        what = self.clock.label(case) or ", ".join([record.rule_name, *map(str, record.wildcards.values())])
        self.jobs[record.jobid] = (what, case, time.monotonic())
        self.clock.start(case)
        if self.bar is not None:
            self.bar.update(self.task, description=f"{self.clock.left()}; now {what}")

    def _finish(self, job: int) -> None:
        what, case, begun = self.jobs.pop(job, ("", "", time.monotonic()))
        seconds = time.monotonic() - begun
        self.clock.finish(case, seconds)
        if not what or what == "all":
            return
        count = f"[{self.clock.jobs_done:>3}/{self.clock.jobs_total}]"
        cases = f"cases {self.clock.cases_done}/{self.clock.cases_total}, " if case else ""
        self._say(f"{count} {what}  ({words(seconds)}; {cases}{self.clock.left()})")
        if self.bar is not None:
            self.bar.update(self.task, completed=self.clock.jobs_done, description=self.clock.left())

    def _fail(self, record: logging.LogRecord) -> None:
        what, case, _ = self.jobs.pop(record.jobid, (record.rule_name, "", 0.0))
        self.clock.give_up(case)
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
        """Remove the bar."""
        if self.bar is not None:
            self.bar.stop()
            self.bar = None
        super().close()
