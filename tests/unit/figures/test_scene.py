import math

import numpy as np
import pytest
from matplotlib.figure import Figure
from synthetic import dem_cut_run, make_case, mpm_run

from orthocut.figures import scene
from orthocut.figures.palette import SHEAR, TENSION


def area(corners):
    x, y = corners[..., 0], corners[..., 1]
    return 0.5 * np.abs((x * np.roll(y, -1, -1) - np.roll(x, -1, -1) * y).sum(-1))


def test_parallelograms_follow_the_deformation():
    run = mpm_run(snapshots=2, **{"numerics.points_per_depth": 3})
    shear, stretch = 0.4, 1.5
    run["point_deformation"][0, 0] = [stretch, shear, 0.0, 1.0]
    corners, stress = scene.parallelograms(run, 0)
    width = 2e3 * float(run["point_half_width"])
    assert corners.shape == (run.sizes["point"], 4, 2)
    assert stress.shape == (run.sizes["point"],)
    assert area(corners[0]) == pytest.approx(stretch * width**2)
    assert corners[0, 1] - corners[0, 0] == pytest.approx([stretch * width, 0.0])
    assert corners[0, 3] - corners[0, 0] == pytest.approx([shear * width, width])
    assert area(corners[1]) == pytest.approx(width**2)


def test_points_that_are_padding_are_left_out():
    run = mpm_run(snapshots=1, **{"numerics.points_per_depth": 3})
    run["point_x"][0, :7] = np.nan
    assert len(scene.parallelograms(run, 0)[0]) == run.sizes["point"] - 7


@pytest.mark.parametrize("rake", [-15, 0, 30])
def test_the_wedge_has_the_angles_of_the_tool(rake):
    tool = make_case("mpm_cutting", **{"tool.rake_angle": f"{rake} deg", "tool.clearance_angle": "10 deg"}).tool
    tip, up, _, back = scene.wedge(tool, 2.0, -1.0, 5.0)
    assert list(tip) == [2.0, -1.0]
    face, heel = up - tip, back - tip
    assert math.degrees(math.atan2(face[0], face[1])) == pytest.approx(rake)
    assert math.degrees(math.atan2(heel[1], heel[0])) == pytest.approx(10)


def test_cracks_are_counted_and_coloured_by_mode_and_time():
    run = dem_cut_run(cracks=12, **{"packing.radius_min": "40 um"})
    run["crack_mode"][:] = [0] * 7 + [1] * 5
    run["crack_time"][:] = np.arange(12.0)
    ax = Figure().subplots()
    assert scene.draw_cracks(ax, run) == (7, 5)
    assert scene.draw_cracks(ax, run, before=8.0) == (7, 2)
    colours = [tuple(collection.get_colors()[0]) for collection in ax.collections[:2]]
    from matplotlib.colors import to_rgba

    assert colours == [to_rgba(TENSION), to_rgba(SHEAR)]


def test_broken_joints_are_not_drawn():
    run = dem_cut_run(**{"packing.radius_min": "40 um"})
    run["bond_intact"][0, :10] = 0.0
    run["bond_intact"][0, 10:] = 0.5
    assert scene.draw_bonds(Figure().subplots(), run, 0) == run.sizes["bond"] - 10
