"""Swept parameters as dimensions."""

import numpy as np
import pytest
from synthetic import mpm_run

from orthocut.io.collect import collect
from orthocut.io.unstack import unstacked

GRID = [(0.5, 15), (1.0, 15), (1.0, 30)]


@pytest.fixture(scope="module")
def sweep():
    """Return three of the four cases of a small grid."""
    return collect([mpm_run(cut_depth=f"{depth} mm", rake_angle=f"{rake} deg") for depth, rake in GRID])


def test_values_stand_at_their_parameters_and_holes_are_not_numbers(sweep):
    grid = unstacked(sweep)
    assert grid.force_cutting_mean.dims == ("cut_depth", "rake_angle")
    for index, (depth, rake) in enumerate(GRID):
        found = grid.sel(cut_depth=depth * 1e-3, rake_angle=np.radians(rake), method="nearest")
        assert float(found.force_cutting_mean) == float(sweep.force_cutting_mean[index])
        assert found.case_id.item() == sweep.case_id[index].item()
    hole = grid.isel(cut_depth=0, rake_angle=1)
    assert np.isnan(hole.force_cutting_mean)
    assert (hole.case_id.item(), int(hole.status)) == ("", -1)
    assert grid.cut_depth.attrs["units"] == "m"


def test_one_parameter_becomes_the_only_dimension(sweep):
    line = unstacked(sweep.isel(case=[1, 0]), "cut_depth")
    assert line.force_cutting_mean.dims == ("cut_depth",)
    np.testing.assert_allclose(line.cut_depth, [0.5e-3, 1e-3])
    assert float(line.force_cutting_mean[0]) == float(sweep.force_cutting_mean[0])


def test_parameters_that_do_not_tell_cases_apart_are_refused(sweep):
    with pytest.raises(ValueError, match=r"cut_depth does not tell all cases apart .*rake_angle"):
        unstacked(sweep, "cut_depth")
    with pytest.raises(ValueError, match="colour is no parameter of all cases"):
        unstacked(sweep, "colour")
