"""Progress of the workflow: counts and the time left."""

import logging
from types import SimpleNamespace

import pytest
from snakemake_interface_logger_plugins.common import LogEvent

import snakemake_logger_plugin_orthocut as plugin
from snakemake_logger_plugin_orthocut.clock import Clock, words
from snakemake_logger_plugin_orthocut.feed import Feed


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
    made.begin(8, 2)
    return made


def test_time_left_starts_from_the_predictions(now):
    assert clock().seconds_left() == pytest.approx(120)


def test_time_left_learns_by_kind(now):
    made = clock()
    made.start("mpm-a")
    made.finish("mpm-a", 20.0)
    assert made.seconds_left() == pytest.approx(2 * 10 + 100)
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


def test_a_case_that_tells_how_far_it_is_is_believed(now):
    made = clock(cores=2)
    made.start("dem-c")
    now.seconds = 30.0
    made.advance("dem-c", 0.1)
    assert made.seconds_left() == pytest.approx(270)


def test_failed_cases_are_counted_apart(now):
    made = clock()
    made.start("mpm-a")
    made.finish("mpm-a", 1.0, failed=True)
    made.start("mpm-b")
    assert made.counts == "1/3 cases, 1 running, 1 failed"


def test_nothing_is_left_without_simulations(now):
    made = clock()
    made.begin(3, 0)
    assert made.left() == "no simulations left"


@pytest.fixture
def feed(tmp_path):
    return Feed(tmp_path)


def tell(folder, batch, *lines):
    with open(folder / f"{batch}.jsonl", "a", encoding="utf-8") as file:
        file.write("".join(lines))


def test_feed_reads_what_is_new_of_the_batches_it_follows(feed, tmp_path):
    tell(tmp_path, "a", '{"event": "done", "case": "of an earlier run"}\n')
    feed.follow("a")
    feed.follow("b")
    assert feed.news() == []
    tell(tmp_path, "a", '{"event": "start", "case": "x"}\n', "nonsense\n", "[1]\n", '{"event": "do')
    tell(tmp_path, "b", '{"event": "start", "case": "y"}\n')
    tell(tmp_path, "c", '{"event": "start", "case": "z"}\n')
    assert [event["case"] for event in feed.news()] == ["x", "y"]
    tell(tmp_path, "a", 'ne", "case": "x"}\n')
    assert feed.news() == [{"event": "done", "case": "x"}]
    assert feed.news() == []


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


def begin(handler, folder, **cases):
    send(handler, "to do", cases={case: (words, 10.0) for case, words in cases.items()}, progress=folder)
    send(handler, event=LogEvent.RUN_INFO, stats={"simulate": 1, "figure": 1, "total": 3})
    send(handler, event=LogEvent.JOB_INFO, jobid=7, rule_name="simulate", wildcards={"batch": "batch-mpm-1"})


def test_handler_tells_cases_and_jobs(handler, now, tmp_path, capsys):
    begin(handler, tmp_path, **{"mpm-a": "depths: cut_depth 1 mm", "mpm-b": "other"})
    tell(tmp_path, "batch-mpm-1", '{"event": "dashboard", "address": "http://127.0.0.1:1/status"}\n')
    tell(tmp_path, "batch-mpm-1", '{"event": "start", "case": "mpm-a"}\n')
    tell(tmp_path, "batch-mpm-1", '{"event": "done", "case": "mpm-a", "seconds": 20.0, "reason": ""}\n')
    now.seconds = 20.0
    send(handler, event=LogEvent.JOB_FINISHED, job_id=7)
    send(handler, event=LogEvent.JOB_INFO, jobid=8, rule_name="figure", wildcards={"figure": "fig08"})
    now.seconds = 21.0
    send(handler, event=LogEvent.JOB_FINISHED, job_id=8)
    handler.close()
    assert capsys.readouterr().err.splitlines() == [
        "to do",
        "3 jobs; about 20 s left",
        "workers: http://127.0.0.1:1/status",
        "depths: cut_depth 1 mm  (20 s; 1/2 cases, about 20 s left)",
        "[  2/3] figure, fig08  (1.0 s; about 20 s left)",
    ]


def test_handler_is_brief_about_many_quick_cases_but_names_each_failure(handler, now, tmp_path, capsys):
    begin(handler, tmp_path, **{f"mpm-{k}": f"case {k}" for k in range(50)})
    for k in range(50):
        state = "failed" if k in (20, 30) else "done"
        tell(tmp_path, "batch-mpm-1", f'{{"event": "{state}", "case": "mpm-{k}", "seconds": 0.1, "reason": "why"}}\n')
    send(handler, event=LogEvent.JOB_FINISHED, job_id=7)
    handler.close()
    lines = capsys.readouterr().err.splitlines()[2:]
    assert lines[0].startswith("case 0  (0.1 s; 1/50 cases")
    assert lines[1:3] == ["FAILED case 20: why", "FAILED case 30: why"]
    assert lines[3].startswith("2 cases failed")
    assert len(lines) == 4


def test_handler_names_cases_that_were_lost_and_goes_on_without_them(handler, now, tmp_path, capsys):
    begin(handler, tmp_path, **{"mpm-a": "case a", "mpm-b": "case b"})
    for case in ("mpm-a", "mpm-b"):
        tell(tmp_path, "batch-mpm-1", f'{{"event": "start", "case": "{case}"}}\n')
    tell(tmp_path, "batch-mpm-1", '{"event": "lost", "case": "mpm-a", "reason": "OSError: no room"}\n')
    tell(tmp_path, "batch-mpm-1", '{"event": "done", "case": "mpm-b", "seconds": 20.0, "reason": ""}\n')
    send(handler, event=LogEvent.JOB_FINISHED, job_id=7)
    handler.close()
    lines = capsys.readouterr().err.splitlines()
    assert "LOST case a: OSError: no room" in lines
    assert "case b  (20 s; 1/2 cases, 1 lost, no simulations left)" in lines


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


def test_handler_names_a_failed_job_and_its_reason(handler, tmp_path, capsys):
    log = tmp_path / "a.log"
    log.write_text("Traceback\nOSError: disk full\n\n")
    begin(handler, tmp_path, **{"mpm-a": "depths"})
    send(handler, level=logging.ERROR, event=LogEvent.JOB_ERROR, jobid=7, rule_name="simulate", log=[str(log)])
    handler.close()
    assert capsys.readouterr().err.splitlines()[2:] == [
        f"FAILED simulate, batch-mpm-1: OSError: disk full  (log: {log})"
    ]
