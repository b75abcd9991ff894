"""Say what runs, how many tests are done and how much time is left."""

import sys
import time

import pytest


class Progress:
    """Lines such as ``[ 120/480] 24 s, about 70 s left: tests/unit/test_cli.py`` every few seconds."""

    def __init__(self, config):
        self.config = config
        self.total = self.done = 0
        self.start = self.last = time.monotonic()

    def pytest_collection_finish(self, session):
        self.total = len(session.items)

    def pytest_xdist_node_collection_finished(self, node, ids):
        self.total = len(ids)

    def pytest_runtest_logreport(self, report):
        if report.when != "teardown":
            return
        self.done += 1
        now = time.monotonic()
        if self.total and (now - self.last > 5 or self.done == self.total):
            self.last = now
            spent = now - self.start
            left = f"about {spent * (self.total - self.done) / self.done:.0f} s left"
            if self.done < self.total / 5:
                left = "the slow ones come first"
            where = report.nodeid.split("::")[0]
            line = f"[{self.done:>4}/{self.total}] {spent:.0f} s, {left}: {where}"
            self.config.get_terminal_writer().line("")
            self.config.get_terminal_writer().line(line)


@pytest.hookimpl(trylast=True)
def pytest_configure(config):
    if not hasattr(config, "workerinput") and not config.option.collectonly and "-q" not in sys.argv:
        config.pluginmanager.register(Progress(config), "progress_lines")


def pytest_collection_modifyitems(items):
    """Start with the tests of the workflow: they run one after another and take longest."""
    items.sort(key=lambda item: "tests/workflow/" not in item.nodeid)


def pytest_collection_finish(session):
    """Stop where pytest-xdist cannot keep the tests of a group on one worker, as it could not with pytest 9.2.0.

    Two of Slurm's tests at a time would take each other's cluster away.
    """
    grouped = [item for item in session.items if item.get_closest_marker("xdist_group")]
    if getattr(session.config.option, "loadgroup", False) and not all("@" in item.nodeid for item in grouped):
        raise pytest.UsageError("pytest-xdist does not see the groups of tests: install pytest < 9.2")
