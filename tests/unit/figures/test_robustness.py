"""Cuts with extreme parameters: every case has a row, failed ones with their reason; shares of the work."""

import math

import pytest
from synthetic import dem_cut_run, make_case, mpm_run

from orthocut.experiments.mpm_cutting import CLOSURE_LIMIT, GAIN_LIMIT
from orthocut.figures import registry
from orthocut.figures.nairn2015_robustness import LOSS, STOPS, condense, names
from orthocut.io.collect import collect
from orthocut.io.datasets import failed

NAME = "nairn2015_robustness"


def cut(touching=0, **values):
    return mpm_run(snapshots=0, touching=touching, **values)


def dataset():
    runs = [cut(), cut(1, cut_depth="0.05 mm"), cut(cut_depth="10 mm", friction=1), cut(strength="160 MPa")]
    runs.append(failed(make_case("mpm_cutting", rake_angle="-30 deg", points_per_depth=4), "it burst", 1.0))
    return collect([condense(run) for run in runs], dims=registry.dims(NAME))


def test_condensed_runs_know_the_share_that_is_lost_and_failed_ones_pass():
    run = cut()
    run["energy_numerical"][-1], run["energy_contact"][-1], run["work_tool"][-1] = -5.0, 2.0, 200.0
    assert float(condense(run)[LOSS]) == pytest.approx(-0.015)
    lost = failed(make_case("mpm_cutting"), "it burst", 1.0)
    assert condense(lost) is lost


def test_every_case_has_a_row_with_units_and_outcome():
    table = registry.tabulate(NAME, dataset())
    assert table.header[:4] == [
        "depth of cut [mm]",
        "rake angle [deg]",
        "friction coefficient [-]",
        "cohesive stress [MPa]",
    ]
    assert [row[:6] for row in table.rows] == [
        [0.05, 30.0, 0.0, 40.0, "done", "touching"],
        [0.9, -30.0, 0.0, 40.0, "failed: it burst", ""],
        [0.9, 30.0, 0.0, 40.0, "done", "bending"],
        [0.9, 30.0, 0.0, 160.0, "done", "bending"],
        [10.0, 30.0, 1.0, 40.0, "done", "bending"],
    ]
    assert table.rows[2][6:] == pytest.approx([4.2, 0.126, 11.0, 2.0])
    assert all(math.isnan(number) for number in table.rows[1][6:])


def test_rows_are_named_by_all_that_varies():
    runs = [cut(), cut(cut_depth="0.05 mm"), cut(cut_depth="10 mm", friction=1)]
    assert names(runs) == [
        "$h$ = 0.9 mm, $\\mu$ = 0",
        "$h$ = 0.05 mm, $\\mu$ = 0",
        "$h$ = 10 mm, $\\mu$ = 1",
    ]


def test_symbols_tell_the_outcome():
    left, right = registry.draw(NAME, dataset()).axes
    for ax, name in ((left, LOSS), (right, "energy_closure")):
        marks = [(line.get_marker(), line.get_ydata()[0]) for line in ax.get_lines() if line.get_marker() in ("o", "x")]
        assert marks == [("o", 0), ("x", 1), ("o", 2), ("o", 3), ("o", 4)], name
    faces = [line.get_markerfacecolor() for line in left.get_lines() if line.get_marker() == "o"]
    assert [face == "white" for face in faces] == [True, False, False, False]


def test_runs_stop_where_the_figure_says():
    assert STOPS == 100 * CLOSURE_LIMIT == 100 * GAIN_LIMIT


def test_other_kinds_are_left_out():
    glass = dem_cut_run(cracks=3, **{"packing.radius_min": "40 um"})
    assert registry.tabulate(NAME, collect([glass])).rows == []
