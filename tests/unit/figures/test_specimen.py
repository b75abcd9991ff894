import numpy as np
import pytest
from synthetic import dem_cut_run, dem_test_run

from orthocut.figures import registry
from orthocut.figures.specimen import extent
from orthocut.io.collect import collect

BIG = {"packing.radius_min": "40 um"}


@pytest.mark.parametrize("turned", [1, -1])
@pytest.mark.parametrize(("kind", "figure"), [("dem_tension", "yang2018_fig07"), ("dem_compression", "yang2018_fig08")])
def test_curves_are_positive_along_the_loading(kind, figure, turned):
    run = dem_test_run(kind, **BIG)
    for name in ("stress_axial", "strain_gauge", "stress_grip"):
        run[name] = turned * run[name]
    curve = registry.draw(figure, collect([run])).axes[1].lines[0]
    np.testing.assert_allclose(curve.get_ydata(), np.abs(run["stress_axial"]) * 1e-6)
    np.testing.assert_allclose(curve.get_xdata(), np.abs(run["strain_gauge"]) * 100)


def test_runs_without_strain_of_the_region_show_that_of_the_specimen():
    run = dem_test_run("dem_tension", **BIG)
    for runs, name in (([run], "strain_gauge"), ([run.drop_vars("strain_gauge")], "strain_axial")):
        axes = registry.draw("yang2018_fig07", collect(runs)).axes[1]
        np.testing.assert_allclose(axes.lines[0].get_xdata(), np.abs(run[name]) * 100)
        assert ("measurement region" in axes.get_xlabel()) == (name == "strain_gauge")


def test_runs_of_the_other_test_are_not_drawn():
    both = collect([dem_test_run("dem_tension", **BIG), dem_test_run("dem_compression", **BIG)])
    for figure, largest in (("yang2018_fig07", 50), ("yang2018_fig08", 400)):
        curves = [line for line in registry.draw(figure, both).axes[1].lines if len(line.get_xdata()) > 2]
        assert len(curves) == 2
        assert all(0.5 * largest < np.nanmax(curve.get_ydata()) < largest for curve in curves)


def test_discs_that_flew_off_do_not_shrink_the_picture():
    run = dem_cut_run(**BIG)
    run["disc_x"][-1, 0] = 1.0
    run["disc_y"][-1, 1] = -1.0
    (left, right), (bottom, top) = extent(run, 1)
    assert -0.34 < left < right < 1.34
    assert -0.34 < bottom < top < 1.34
