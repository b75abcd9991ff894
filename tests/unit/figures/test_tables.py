import csv
import math

import pytest
from synthetic import dem_cut_run, failed, mpm_run

from orthocut.figures import registry, tables
from orthocut.figures.yang2018_paper import EXPERIMENT, SIMULATION, WIDTHS
from orthocut.io.collect import collect

BIG = {"packing.radius_min": "40 um"}


def test_both_files_hold_the_same_rows(tmp_path):
    table = tables.Table("A title", ["depth [mm]", "force [N/mm]"], [["0.1", 1.23456789], ["total", math.nan]])
    paths = tables.write(table, tmp_path / "table")
    assert [path.name for path in paths] == ["table.csv", "table.md"]
    assert list(csv.reader(paths[0].open())) == [["depth [mm]", "force [N/mm]"], ["0.1", "1.23457"], ["total", ""]]
    assert paths[1].read_text().splitlines() == [
        "# A title",
        "",
        "| depth [mm] | force [N/mm] |",
        "| --- | --- |",
        "| 0.1 | 1.235 |",
        "| total | - |",
    ]


def test_run_times_name_each_case_its_size_and_sum_up():
    cut, other = mpm_run(snapshots=0, wall_time=2.5), dem_cut_run(wall_time=4.0, **BIG)
    cut.attrs |= {"particles": 700, "steps": 9000}
    table = tables.run_times([cut, other], {cut.attrs["case_id"]: "soft", other.attrs["case_id"]: "brittle"})
    assert table.rows[1] == [cut.attrs["case_id"], "soft", "done", 700, 9000, 2.0, 2.5]
    assert table.rows[0][-1] == 4.0
    assert math.isnan(table.rows[0][3])
    assert table.rows[-1][:2] == ["2 cases", "total"]
    assert table.rows[-1][-1] == 6.5


def test_table_4_compares_means_of_replicates_with_the_paper():
    runs = [dem_cut_run(**BIG, **{"packing.seed": seed}) for seed in (1, 2)]
    lost = failed(dem_cut_run(**BIG, **{"packing.seed": 3}))
    table = registry.tabulate("yang2018_table4", collect([*runs, lost]))
    assert len(table.rows) == 8
    row = next(row for row in table.rows if row[:3] == ["0.1", "regular", "main"])
    mean = sum(float(run["force_cutting_mean"]) for run in runs) / 2 / 1e3
    paper = sum(SIMULATION[0.1, False]["force_cutting"]) / 3
    found = dict(zip(table.header, row, strict=True))
    assert found["number"] == 2
    assert found["mean [N/mm]"] == pytest.approx(mean)
    assert found["paper: mean [N/mm]"] == pytest.approx(paper)
    assert found["mean over paper's mean [-]"] == pytest.approx(mean / paper)
    assert math.isnan(table.rows[-1][table.header.index("mean [N/mm]")])


def test_the_papers_means_are_those_it_states():
    stated = {
        (0.1, False): (14.98, 9.98),
        (0.1, True): (2.05, 2.95),
        (0.2, False): (17.70, 12.63),
        (0.2, True): (3.52, 2.33),
    }
    for cut, means in stated.items():
        found = [sum(SIMULATION[cut][name]) / 3 for name in ("force_cutting", "force_thrust")]
        assert found == pytest.approx(means, abs=0.006)


def test_measured_forces_are_those_of_table_6_and_compared_for_the_same_width():
    stated = {
        (0.1, False): (16.50, 13.53),
        (0.1, True): (2.50, 3.43),
        (0.2, False): (19.07, 14.97),
        (0.2, True): (4.27, 5.80),
    }
    for cut, means in stated.items():
        found = [sum(EXPERIMENT[cut][name]) / 3 for name in ("force_cutting", "force_thrust")]
        assert found == pytest.approx(means, abs=0.006)
    table = registry.tabulate("yang2018_table6", collect([dem_cut_run(**BIG)]))
    row = dict(zip(table.header, table.rows[0], strict=True))
    assert WIDTHS["experiment"] == 25.4
    assert row["experiment [N/mm]"] == pytest.approx(16.5 / 25.4)
    assert row["paper's over experiment [-]"] == pytest.approx(23.06, abs=0.01)
    assert row["paper's deviation, raw [%]"] == pytest.approx(-9.2, abs=0.05)


def test_figures_without_a_table_have_none():
    assert registry.tabulate("nairn2015_fig04", collect([])) is None
