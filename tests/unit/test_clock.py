"""Progress of the workflow: counts and the time left."""

import logging
from types import SimpleNamespace

import pytest
from snakemake_interface_logger_plugins.common import LogEvent

import snakemake_logger_plugin_orthocut as plugin
from snakemake_logger_plugin_orthocut.clock import Clock, words


@pytest.fixture
def now(monkeypatch):
    """Return a clock that tests set."""
    state = SimpleNamespace(seconds=0.0)
    monkeypatch.setattr("time.monotonic", lambda: state.seconds)
    return state


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(3.21, "3.2 s"), (42.4, "42 s"), (61, "1 min 01 s"), (3599.6, "1 h 00 min"), (7260, "2 h 01 min")],
)
def test_words(seconds, text):
    assert words(seconds) == text


def clock(cores=1):
    made = Clock()
    made.cores = cores
    made.announce({"mpm-a": ("a", 10.0), "mpm-b": ("b", 10.0), "dem-c": ("c", 100.0)})
    made.begin(3, 8)
    return made


def test_time_left_starts_from_the_estimates(now):
    assert clock().seconds_left() == pytest.approx(120)


def test_time_left_learns_by_kind(now):
    made = clock()
    made.start("mpm-a")
    made.finish("mpm-a", 20.0)
    assert made.seconds_left() == pytest.approx(2 * 10 + 2 * 100)
    made.start("dem-c")
    made.finish("dem-c", 50.0)
    assert made.seconds_left() == pytest.approx(20)


def test_running_cases_count_down_and_the_longest_bounds(now):
    made = clock(cores=2)
    for case in ("mpm-a", "mpm-b", "dem-c"):
        made.start(case)
    now.seconds = 4.0
    assert made.seconds_left() == pytest.approx(96)
    now.seconds = 500.0
    assert made.seconds_left() == 0


def test_only_stale_cases_count(now):
    made = clock()
    made.begin(1, 3)
    assert made.seconds_left() == pytest.approx(40)
    made.begin(0, 3)
    assert made.left() == "no simulations left"


@pytest.fixture
def handler(now):
    settings = SimpleNamespace(
        quiet=None,
        show_failed_logs=False,
        dryrun=False,
        verbose=False,
        debug_dag=False,
        nocolor=True,
        printshellcmds=False,
    )
    return plugin.LogHandler(settings, None)


def send(handler, message="", level=logging.INFO, **fields):
    record = logging.LogRecord("snakemake", level, "", 0, message, (), None)
    record.__dict__.update(fields)
    handler.emit(record)


def test_handler_tells_one_line_a_job(handler, now, capsys):
    send(handler, cases={"mpm-a": ("depths: cut_depth 1 mm", 10.0), "mpm-b": ("other", 10.0)})
    send(handler, event=LogEvent.RUN_INFO, stats={"simulate": 2, "figure": 1, "total": 3})
    send(handler, event=LogEvent.JOB_INFO, jobid=7, rule_name="simulate", wildcards={"case_id": "mpm-a"})
    now.seconds = 20.0
    send(handler, event=LogEvent.JOB_FINISHED, job_id=7)
    send(handler, event=LogEvent.JOB_INFO, jobid=8, rule_name="figure", wildcards={"figure": "fig08"})
    now.seconds = 21.0
    send(handler, event=LogEvent.JOB_FINISHED, job_id=8)
    assert capsys.readouterr().err.splitlines() == [
        "3 jobs, 2 of them simulations; about 20 s left",
        "[  1/3] depths: cut_depth 1 mm  (20 s; cases 1/2, about 20 s left)",
        "[  2/3] figure, fig08  (1.0 s; about 20 s left)",
    ]


def test_handler_drops_chatter_and_keeps_the_rest(handler, capsys):
    for message in ("Select jobs to execute...", "Building DAG of jobs...", ""):
        send(handler, message)
    assert capsys.readouterr().err == ""
    send(handler, "Nothing to be done (all requested files are present and up to date).")
    send(handler, "something new")
    send(handler, "it is broken", logging.ERROR, event=LogEvent.ERROR)
    assert capsys.readouterr().err.splitlines() == [
        "Nothing to do: all results are there and up to date.",
        "something new",
        "it is broken",
    ]


def test_handler_names_a_failed_case_and_its_reason(handler, tmp_path, capsys):
    log = tmp_path / "a.log"
    log.write_text("Traceback\nDiverged: energy is not finite\n\n")
    send(handler, cases={"mpm-a": ("depths: cut_depth 1 mm", 10.0)})
    send(handler, event=LogEvent.RUN_INFO, stats={"simulate": 1, "total": 2})
    send(handler, event=LogEvent.JOB_INFO, jobid=7, rule_name="simulate", wildcards={"case_id": "mpm-a"})
    send(handler, level=logging.ERROR, event=LogEvent.JOB_ERROR, jobid=7, rule_name="simulate", log=[str(log)])
    assert capsys.readouterr().err.splitlines()[1:] == [
        f"FAILED depths: cut_depth 1 mm: Diverged: energy is not finite  (log: {log})"
    ]
    assert handler.clock.seconds_left() == 0
