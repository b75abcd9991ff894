"""A process that runs scenes one after the other and may crash or hang without harm to what has been done."""

from __future__ import annotations

import contextlib
import multiprocessing
import signal
import time
import warnings
from multiprocessing.connection import Connection
from typing import Any, NamedTuple

from stress_checks import SNAPSHOTS, checks
from stress_scenes import Scene, cut_down, describe

from orthocut.params.block import CaseFailed, ConfigError
from orthocut.run import run_case

DONE, REFUSED, FAILED = "done", "refused", "failed with a diagnosis"
LIE, CRASHED, LATE = "quiet lie", "crash", "no end in time"
PATIENCE = 50
"""Wall time over CPU time after which a process counts as one that hangs."""
OUTCOMES = (DONE, REFUSED, FAILED, LIE, CRASHED, LATE)


class Outcome(NamedTuple):
    """What became of a scene."""

    outcome: str
    why: str
    seconds: float
    """CPU time; the first scene of a process pays for its start, those with new laws for their compilation [s]."""
    ran: dict[str, Any]
    """What was run, after the scene was cut down."""
    found: dict[str, float]
    """Value of each check."""


def try_scene(scene: Scene) -> Outcome:
    """Run a scene and check it."""
    began = time.process_time()
    ran: dict[str, Any] = {}
    found: dict[str, float] = {}
    try:
        case = cut_down(scene)
        ran = describe(case)
        run = run_case(case, snapshots=SNAPSHOTS)
        looked = checks(case, run)
        found = {check.name: check.value for check in looked}
        bad = [f"{check.name}: {check.value:.3g} (allowed: {check.limit:g})" for check in looked if not check.passed]
        outcome, why = (LIE, "; ".join(bad)) if bad else (DONE, "")
    except ConfigError as error:
        outcome, why = REFUSED, str(error)
    except CaseFailed as error:
        outcome, why = FAILED, str(error)
    except Exception as error:
        outcome, why = CRASHED, f"{type(error).__name__}: {error}"
    return Outcome(outcome, " ".join(why.split()), time.process_time() - began, ran, found)


def _serve(pipe: Connection, limit: float) -> None:
    """Run what comes; a scene that takes more CPU time than the limit ends the process by a signal."""
    warnings.simplefilter("ignore")
    with contextlib.suppress(EOFError):
        while True:
            scene = pipe.recv()
            signal.setitimer(signal.ITIMER_VIRTUAL, limit)
            outcome = try_scene(scene)
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
            pipe.send(outcome)


class Worker:
    """One process, started anew when it has died.

    Parameters
    ----------
    limit : float
        CPU time that a scene may take [s].
    """

    def __init__(self, limit: float) -> None:
        self.limit = limit
        self._process: multiprocessing.process.BaseProcess | None = None

    def run(self, scene: Scene) -> Outcome:
        """Run a scene; a crash or a run beyond the limit is an outcome."""
        if self._process is None:
            context = multiprocessing.get_context("spawn")
            self._pipe, other = context.Pipe()
            self._process = context.Process(target=_serve, args=(other, self.limit), daemon=True)
            self._process.start()
            other.close()
        self._pipe.send(scene)
        try:
            if self._pipe.poll(PATIENCE * self.limit):
                return self._pipe.recv()
            code = -signal.SIGVTALRM
        except EOFError:
            self._process.join()
            code = self._process.exitcode
        self.stop()
        if code == -signal.SIGVTALRM:
            return Outcome(LATE, f"stopped after {self.limit:g} s of CPU time", self.limit, {}, {})
        return Outcome(CRASHED, f"the process ended with code {code}", 0.0, {}, {})

    def stop(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._process = None
