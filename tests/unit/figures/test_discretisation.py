"""The finest run of each cut and its limit at zero particle size: exact on exact data, holes where there is none."""

import math

import numpy as np
import pytest
from synthetic import dem_cut_run, make_case, mpm_run

from orthocut.figures import registry
from orthocut.figures.discretisation import DIFFERS, finest, hangs_on_resolution, has_partners
from orthocut.figures.forces_over_depth import SYMBOLS
from orthocut.io.collect import case_of, collect
from orthocut.io.datasets import failed

FIGURES = [f"nairn2015_fig{number}" for number in ("08", 11, 12, 13, 14, 15)]
DEPTHS = ("0.5 mm", "1 mm", "2.5 mm", "4 mm")


def cut(points, depth="1 mm", force=None, touching=0, **values):
    run = mpm_run(
        snapshots=0,
        cut_depth=depth,
        force=force,
        touching=touching,
        modulus_tangent="0 MPa",
        points_per_depth=points,
        **values,
    )
    return run.assign(force_rubbing_error=((), 0.02 * float(run["force_rubbing_mean"])))


def sweep(points, change=2):
    """One series, the first `change` of whose depths touch, with a force of 5000 + 9000/n."""
    return [cut(points, depth, 5e3 + 9e3 / points, touching=int(index < change)) for index, depth in enumerate(DEPTHS)]


def points_of(dataset):
    return [case_of(dataset.isel(case=index)).numerics.points_per_depth for index in range(dataset.sizes["case"])]


def test_the_finest_of_each_cut_stays_in_order():
    runs = [cut(8), cut(5), cut(5, "2 mm"), cut(12, "3 mm"), cut(8, "3 mm"), cut(8, friction=0.1)]
    found = finest(collect(runs))
    assert points_of(found) == [8, 5, 12, 8]
    assert np.isfinite(found[DIFFERS].values).tolist() == [True, False, True, False]


def test_the_limit_is_that_of_the_straight_line():
    coarse, fine = cut(5, force=6900.0), cut(8, force=6200.0)
    found = finest(collect([coarse, fine]), "force_cutting_mean", "force_rubbing_mean").isel(case=0)
    by_hand = 6200 + (6200 - 6900) * (1 / 8) / (1 / 5 - 1 / 8)
    assert float(found["force_cutting_mean_limit"]) == pytest.approx(by_hand)
    errors = [float(run["force_cutting_error"]) for run in (coarse, fine)]
    assert float(found["force_cutting_mean_limit_error"]) == pytest.approx(
        math.hypot(errors[0] * 5 / 3, errors[1] * 8 / 3)
    )
    assert float(found["force_rubbing_mean_limit"]) == pytest.approx(0.1 * by_hand)
    assert not hangs_on_resolution(found)


def test_more_sizes_than_two_are_fitted():
    runs = [cut(points, force=5e3 + 9e3 / points) for points in (5, 8, 12)]
    found = finest(collect(runs), "force_cutting_mean")
    assert points_of(found) == [12]
    assert float(found["force_cutting_mean_limit"][0]) == pytest.approx(5e3)


def test_no_limit_without_a_partner_or_across_regimes():
    alone = finest(collect([cut(8)]), "force_cutting_mean")
    assert math.isnan(float(alone["force_cutting_mean_limit"][0]))
    assert not has_partners(alone)
    crossed = finest(collect([cut(5, touching=1), cut(8, touching=0)]), "force_cutting_mean")
    assert math.isnan(float(crossed["force_cutting_mean_limit"][0]))
    assert hangs_on_resolution(crossed.isel(case=0))
    assert has_partners(crossed)


def test_a_coarser_run_does_not_stand_in_for_a_failed_one():
    lost = failed(make_case("mpm_cutting", cut_depth="1 mm", modulus_tangent="0 MPa", points_per_depth=8), "why", 1.0)
    found = finest(collect([cut(5), lost]), "force_cutting_mean")
    assert points_of(found) == [8]
    assert found["failure"].values.tolist() == ["why"]
    coarse = failed(make_case("mpm_cutting", cut_depth="1 mm", modulus_tangent="0 MPa", points_per_depth=5), "why", 1.0)
    found = finest(collect([coarse, cut(8)]), "force_cutting_mean")
    assert points_of(found) == [8]
    assert math.isnan(float(found[DIFFERS][0]))


def test_a_force_of_nothing_has_a_limit_of_nothing():
    runs = [cut(points) for points in (5, 8)]
    for run in runs:
        run["force_rubbing_mean"][...], run["force_rubbing_error"][...] = 0.0, 0.0
    assert float(finest(collect(runs), "force_rubbing_mean")["force_rubbing_mean_limit"][0]) == 0.0


def test_other_kinds_single_runs_and_nothing_pass():
    glass = dem_cut_run(cracks=3, **{"packing.radius_min": "40 um"})
    assert finest(collect([glass, cut(5), cut(8)])).sizes["case"] == 2
    assert finest(cut(5), "force_cutting_mean").equals(cut(5))
    assert finest(None) is None
    assert finest(collect([]), "force_cutting_mean").sizes["case"] == 0


def symbols(ax):
    return [float(bar.lines[0].get_ydata()[0]) for bar in ax.containers]


def marked(ax, marker, size):
    return [line for line in ax.get_lines() if line.get_marker() == marker and line.get_markersize() == size]


@pytest.mark.parametrize("name", FIGURES)
def test_force_figures_draw_the_finest_runs_and_lines_to_their_limits(name):
    alone, both = (registry.draw(name, collect(runs)) for runs in (sweep(8), sweep(5) + sweep(8)))
    assert symbols(both.axes[0]) == symbols(alone.axes[0])
    assert marked(alone.axes[0], "_", 7) == []
    ticks = marked(both.axes[0], "_", 7)
    assert [line.get_ydata()[0] for line in ticks] == pytest.approx([2.5] * len(DEPTHS))
    named = [text.get_text() for text in both.legends[0].get_texts()]
    assert "to zero particle size" in named
    assert "to zero particle size" not in [text.get_text() for text in alone.legends[0].get_texts()]
    assert SYMBOLS in registry.caption(name)


@pytest.mark.parametrize("name", ["nairn2015_fig08", "nairn2015_fig10", "nairn2015_fig16"])
def test_a_regime_that_hangs_on_resolution_is_ringed_and_has_no_line(name):
    ax = registry.draw(name, collect(sweep(5, change=1) + sweep(8, change=2))).axes[0]
    assert len(marked(ax, "o", 6.5)) == 1
    assert len(marked(ax, "_", 7)) == len(DEPTHS) - 1


def test_models_turn_where_the_finest_runs_do():
    alone, both = (
        registry.draw("nairn2015_fig08", collect(runs)).axes[0] for runs in (sweep(8, 2), sweep(5, 1) + sweep(8, 2))
    )
    ends = [
        [line.get_xdata()[-1] for line in ax.get_lines() if line.get_linestyle() == "--" and len(line.get_xdata()) > 2]
        for ax in (alone, both)
    ]
    assert ends[0] == ends[1]


def test_rubbing_has_the_bars_that_runs_tell():
    told, silent = sweep(8), [run.drop_vars("force_rubbing_error") for run in sweep(8)]
    bars = [
        [bool(bar.lines[2]) for bar in registry.draw("nairn2015_fig10", collect(runs)).axes[0].containers]
        for runs in (told, silent)
    ]
    assert bars == [[True] * len(DEPTHS), [False] * len(DEPTHS)]


@pytest.mark.parametrize("name", ["nairn2015_fig08", "nairn2015_fig10", "nairn2015_fig16"])
def test_a_failed_coarser_run_is_named_and_is_no_hole(name):
    lost = failed(make_case("mpm_cutting", cut_depth="1 mm", modulus_tangent="0 MPa", points_per_depth=5), "burst", 1.0)
    figure = registry.draw(name, collect([*sweep(8), lost]))
    assert "burst" in " ".join(text.get_text() for text in figure.texts)
    assert [line for line in figure.axes[0].get_lines() if line.get_marker() == "x"] == []


def test_regimes_count_each_cut_once():
    table = registry.tabulate("nairn2015_regimes", collect(sweep(5, change=1) + sweep(8, change=2)))
    assert [(row[3], row[4], row[5]) for row in table.rows] == [(pytest.approx(1.0), pytest.approx(2.5), 0)]
