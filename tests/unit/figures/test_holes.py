"""Failed cases are seen in every figure and table, and in no mean."""

import numpy as np
import pytest
from matplotlib.lines import Line2D
from synthetic import dem_cut_run, dem_test_run, make_case, mpm_run

from orthocut.figures.holes import reasons
from orthocut.figures.registry import FIGURES, WITHOUT_RUNS, draw, module, tabulate
from orthocut.figures.tables import run_times
from orthocut.io.collect import collect
from orthocut.io.datasets import failed

RUNS = {
    "nairn2015": [mpm_run()],
    "yang2018": [dem_cut_run(), dem_test_run("dem_tension"), dem_test_run("dem_compression")],
}
DRAWN = [name for name in FIGURES if name not in WITHOUT_RUNS and name != "show"]


def hole(name):
    kind = "dem_cutting" if name.startswith("yang") else "mpm_cutting"
    return failed(make_case(kind, cut_depth="0.15 mm" if kind == "dem_cutting" else "2.5 mm"), "it blew up", 1.0)


def texts(figure):
    return " ".join(text.get_text() for text in figure.texts)


@pytest.mark.parametrize("name", DRAWN)
@pytest.mark.parametrize("others", [True, False], ids=["beside others", "alone"])
def test_every_figure_names_a_failed_case_and_its_reason(name, others, tmp_path):
    runs = RUNS.get(name.split("_")[0], RUNS["nairn2015"]) if others else []
    dataset = collect([*runs, hole(name)])
    figure = draw(name, dataset)
    figure.savefig(tmp_path / "a.png")
    assert "it blew up" in texts(figure)
    assert reasons(dataset)[0].split(": ")[1] in texts(figure)


@pytest.mark.parametrize(
    "name", [f"nairn2015_fig{number}" for number in ("03a", "03b", "08", 10, 11, 12, 13, 14, 15, 16)]
)
def test_sweeps_mark_where_a_failed_case_would_stand(name):
    marks = []
    for runs in ([mpm_run()], [mpm_run(), hole(name)]):
        ax = draw(name, collect(runs)).axes[0]
        marks.append([item for item in ax.get_lines() if isinstance(item, Line2D) and item.get_marker() == "x"])
    assert [len(found) for found in marks] == [0, 1]


def test_figures_of_finished_cases_have_no_note():
    assert draw("nairn2015_fig08", collect([mpm_run()])).texts == []


def test_many_failures_are_counted():
    runs = [failed(make_case("mpm_cutting", cut_depth=f"{h} mm"), "it blew up", 1.0) for h in range(1, 9)]
    found = texts(draw("nairn2015_fig08", collect(runs)))
    assert found.count("blew") == 3
    assert "and 5 more failed cases" in found.replace("\n", " ")


def test_tables_say_why_and_leave_failed_cases_out_of_means():
    run = dem_cut_run()
    whole, holed = (tabulate("yang2018_table4", collect(runs)) for runs in ([run], [run, hole("yang2018_table4")]))
    assert [str(row) for row in whole.rows] == [str(row) for row in holed.rows]
    assert "it blew up" in holed.markdown()
    assert whole.notes == []


def test_run_times_have_the_state_of_each_case():
    table = run_times([mpm_run(), hole("nairn")], {})
    assert sorted(row[2] for row in table.rows) == ["", "done", "failed"]
    assert "it blew up" in table.markdown()


def test_nothing_failed_is_averaged():
    joined = collect([mpm_run(), hole("nairn")])
    assert np.isfinite(joined["force_cutting_mean"].values).sum() == 1
    assert len(module("nairn2015_fig08").draw(joined).axes[0].containers) == 1
