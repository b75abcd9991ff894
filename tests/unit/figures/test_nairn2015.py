"""What figures of Nairn (2015) show beside axes: panels, pairs, halves, curves, fits."""

import math

import numpy as np
import pytest
from matplotlib.lines import Line2D
from synthetic import failed, make_case, mpm_run

from orthocut.figures import nairn2015_fig02, nairn2015_fig09, registry
from orthocut.io.collect import case_of, collect
from orthocut.io.datasets import failed as failed_case

COARSE = {"numerics.points_per_depth": 3}


def cut(**values):
    return mpm_run(snapshots=0, **values)


def lines(ax, style):
    return [line for line in ax.get_lines() if line.get_linestyle() == style and len(line.get_xdata()) > 2]


def test_fig02_has_one_panel_an_order(monkeypatch):
    runs = [mpm_run(snapshots=1, courant=courant, **COARSE) for courant in (0.3, 0.1, 0.2)]
    orders = {0.1: 0, 0.2: 1, 0.3: 2}
    monkeypatch.setattr(nairn2015_fig02, "_order", lambda run: orders[case_of(run).numerics.courant])
    figure = registry.draw("nairn2015_fig02", collect(runs))
    assert [ax.get_title(loc="left") for ax in figure.axes] == ["order 0", "order 1", "order 2"]
    assert len({ax.get_xlim() for ax in figure.axes}) == 1


def test_fig02_shows_what_there_is():
    figure = registry.draw("nairn2015_fig02", collect([mpm_run(snapshots=1, **COARSE)]))
    assert [ax.get_title(loc="left") for ax in figure.axes] == ["order 2"]


def test_fig09_takes_the_pair_on_either_side():
    runs = [
        mpm_run(snapshots=1, cut_depth=f"{depth} mm", touching=touching, **COARSE)
        for depth, touching in ((3, 0), (1, 1), (2.1, 0), (2, 1))
    ]
    figure = registry.draw("nairn2015_fig09", collect(runs))
    assert [ax.get_title(loc="left") for ax in figure.axes] == ["$h$ = 2 mm, touching", "$h$ = 2.1 mm, bending"]
    alone = registry.draw("nairn2015_fig09", collect(runs[:1]))
    assert [ax.get_title(loc="left") for ax in alone.axes] == ["$h$ = 3 mm, bending"]


def test_fig09_knows_elastic_yielded_and_yielding_points():
    run = mpm_run(snapshots=1, **COARSE)
    material = case_of(run).material
    stress, strain = np.zeros_like(run["point_stress"].values), np.zeros_like(run["point_stress"].values)
    stress[0, :3] = 20e6, 25e6, 25e6
    strain[0, :4] = 0.0, 0.0, 0.1, 0.1
    stress[0, 3] = 25e6 + 0.1 * material.modulus_plastic
    run["point_stress"][...], run["point_strain_plastic"][...] = stress, strain
    assert nairn2015_fig09.state_of_points(run, 0)[:4].tolist() == [0, 2, 1, 2]


def series(rake="30 deg", tangent="0 MPa", change=2.0, **values):
    return [
        cut(cut_depth=f"{depth} mm", touching=int(depth < change), rake_angle=rake, modulus_tangent=tangent, **values)
        for depth in (0.5, 1, 2, 3, 5)
    ]


def test_fig08_draws_touching_up_to_the_transition_and_bending_beyond():
    ax = registry.draw("nairn2015_fig08", collect(series())).axes[0]
    dashed = sorted(lines(ax, "--"), key=lambda line: line.get_xdata()[0])
    scale = 139.23
    assert [line.get_xdata()[-1] / scale for line in dashed] == pytest.approx([1.5e-3, 5.25e-3], rel=1e-3)
    assert dashed[1].get_xdata()[0] / scale == pytest.approx(1.5e-3, rel=1e-3)
    assert len(lines(ax, "-")) == 1
    assert len(lines(ax, ":")) == 1


def test_fig08_extends_bending_at_thirty_degrees_alone():
    ax = registry.draw("nairn2015_fig08", collect(series(rake="15 deg"))).axes[0]
    assert lines(ax, ":") == []


def test_fig12_joins_points_and_draws_no_model():
    ax = registry.draw("nairn2015_fig12", collect(series() + series(tangent="25 MPa"))).axes[0]
    assert len(lines(ax, ":")) == 2
    assert lines(ax, "--") == []
    assert lines(ax, "-") == []


def test_fig13_draws_bending_alone():
    ax = registry.draw("nairn2015_fig13", collect(series(tangent="100 MPa", change=0))).axes[0]
    assert len(lines(ax, "--")) == 1
    assert lines(ax, "--")[0].get_xdata()[0] < 0.02


def test_fig14_has_one_model_for_all_strengths():
    runs = [run for strength in ("10 MPa", "40 MPa") for run in series(tangent="100 MPa", change=0, strength=strength)]
    ax = registry.draw("nairn2015_fig14", collect(runs)).axes[0]
    assert [line.get_color() for line in lines(ax, "--")] == ["#000000"]


def test_fig10_fits_lines_to_deep_runs_that_bend():
    ax = registry.draw("nairn2015_fig10", collect(series())).axes[0]
    ends = [line.get_xdata() for line in ax.get_lines() if line.get_linestyle() == "-" and len(line.get_xdata()) == 2]
    fits = [end for end in ends if end[0] != end[1] and end[1] < 0.99]
    assert len(fits) == 1
    assert fits[0][0] == pytest.approx(0.28)


def regime_lines(ax):
    return {line.get_fillstyle() for line in ax.get_lines() if line.get_marker() == "o"}


def test_regimes_show_both_starts_and_hysteresis():
    short = series()
    bent = series(change=1.0, notch_ratio=8)
    figure = registry.draw("nairn2015_regimes", collect(short + bent))
    assert regime_lines(figure.axes[0]) == {"left", "right"}
    at_one = [
        (line.get_fillstyle(), line.get_color())
        for line in figure.axes[0].get_lines()
        if line.get_marker() == "o" and line.get_ydata()[0] == pytest.approx(1.0)
    ]
    assert len(set(at_one)) == 2
    assert len({colour for _, colour in at_one}) == 2
    table = registry.tabulate("nairn2015_regimes", collect(short + bent))
    assert [(row[2], row[3], row[4], row[6]) for row in table.rows] == [
        ("short", pytest.approx(1.0), pytest.approx(2.0), 1),
        ("long", pytest.approx(0.5), pytest.approx(1.0), 1),
    ]


def test_regimes_mark_failed_cases_where_they_would_stand():
    lost = failed_case(make_case("mpm_cutting", cut_depth="3 mm", modulus_tangent="0 MPa"), "it blew up", 1.0)
    figure = registry.draw("nairn2015_regimes", collect([*series(change=9)[:3], lost]))
    for ax in figure.axes[:2]:
        crosses = [line for line in ax.get_lines() if isinstance(line, Line2D) and line.get_marker() == "x"]
        assert [line.get_ydata()[0] for line in crosses] == [pytest.approx(3.0)]


def test_transition_table_has_both_ends_at_each_size():
    runs = series(points_per_depth=5) + series(points_per_depth=8, change=1.0) + series(points_per_depth=9, change=0)
    table = registry.tabulate("nairn2015_transition", collect(runs))
    ends = {row[1]: (row[2], row[3]) for row in table.rows}
    assert ends[5] == (pytest.approx(1.0), pytest.approx(2.0))
    assert ends[8] == (pytest.approx(0.5), pytest.approx(1.0))
    assert math.isnan(ends[9][0])


def test_convergence_table_has_limits_of_both_orders_and_the_model():
    runs = [cut(force=2000.0 * (3 + 4 / n), points_per_depth=n) for n in (5, 8, 12)]
    row = registry.tabulate("nairn2015_convergence", collect(runs)).rows[0]
    assert row[1] == "5 8 12"
    assert row[2] == pytest.approx(3.0)
    assert row[5] > row[2]
    assert row[8] == pytest.approx(2.38, abs=0.01)


def test_fig03b_leaves_out_failed_sizes():
    runs = [cut(force=2000.0 * (3 + 4 / n), points_per_depth=n) for n in (5, 8, 12)]
    ax = registry.draw("nairn2015_fig03b", collect([*runs, failed(cut(points_per_depth=16))])).axes[0]
    assert len([line for line in ax.get_lines() if line.get_linestyle() == "--"]) == 1
