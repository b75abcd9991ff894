"""Cuts with options of the workpiece and of their end: paths, bottoms, early ends."""

import numpy as np
import pytest

from orthocut.experiments.mpm_cutting import LEAST_WINDOW, simulate
from orthocut.mpm import setup
from orthocut.params.block import ConfigError
from orthocut.params.case import load

COARSE = {"points_per_depth": 5}
DEPTH = 0.9e-3


@pytest.fixture(scope="module")
def whole():
    return simulate(load("mpm", COARSE), snapshots=0)


@pytest.fixture(scope="module")
def early():
    return simulate(load("mpm", {**COARSE, "window_ratio": 4.0, "error_target": 0.02}), snapshots=3)


def test_steady_cut_ends_early_with_the_force_of_the_whole_one(whole, early):
    travel = float(early.tool_travel[-1]) / DEPTH
    assert 4.0 + LEAST_WINDOW <= travel < 10.9
    assert float(early.force_cutting_error) <= 0.02 * float(early.force_cutting_mean)
    assert float(early.force_cutting_mean) == pytest.approx(float(whole.force_cutting_mean), rel=0.05)
    assert early.attrs["steps"] < whole.attrs["steps"]


def test_early_end_changes_no_sample_before_it(whole, early):
    """The run is the same, it only stops."""
    count = early.sizes["sample"]
    np.testing.assert_array_equal(early.force_cutting.values, whole.force_cutting.values[:count])


def test_last_snapshot_of_an_early_end_is_taken_there(early):
    assert float(early.time_snapshot[-1]) == pytest.approx(float(early.time[-1]))


def test_path_over_part_of_the_width_cuts_like_the_whole_one(whole):
    """Chip and base are one beyond its end, which the tool does not come near."""
    part = simulate(load("mpm", {**COARSE, "path_ratio": 14.0}), snapshots=0)
    assert float(part.force_cutting_mean) == pytest.approx(float(whole.force_cutting_mean), rel=0.03)
    assert abs(float(part.energy_closure)) < 5e-3


@pytest.mark.parametrize("offset", [0.0, 0.25, 0.5, 0.75])
def test_rows_of_nodes_lie_where_the_case_says(offset):
    """The next row above the cut is so many cells above it; the last one held is next to the bottom."""
    case = load("mpm", {"points_per_depth": 6, "grid_offset": offset})
    frame = setup.build(case).frame
    rows_below = offset - frame.origin_y / frame.cell
    assert rows_below == pytest.approx(round(rows_below))
    bottom = -case.workpiece.base_ratio * case.cut_depth
    held = frame.origin_y + frame.last_clamped_row * frame.cell
    assert abs(held - bottom) <= 0.5001 * frame.cell


@pytest.mark.parametrize(("points", "per_cell"), [(8, 3), (10, 4)])
def test_more_points_in_a_cell_cut_alike_with_a_balance_that_closes(whole, points, per_cell):
    """Cells of about the same size: the force is that of two points along a cell, within a tenth."""
    run = simulate(load("mpm", {**COARSE, "points_per_depth": points, "points_per_cell": per_cell}), snapshots=0)
    ratio = float(run.force_cutting_mean / whole.force_cutting_mean)
    print(f"{per_cell} points along a cell: force x {ratio:.3f}, closure {float(run.energy_closure):+.1e}")
    assert 0.9 < ratio < 1.1
    assert abs(float(run.energy_closure)) < 5e-3


def test_silent_bottom_lets_the_workpiece_go():
    """Nairn (2015), section 2.2: it does not hold the workpiece. The balance closes; dashpots take energy."""
    short = {**COARSE, "travel_ratio": 5.0, "window_ratio": 3.0, "reach_ratio": 0.0}
    held, silent = (simulate(load("mpm", {**short, "bottom": bottom})) for bottom in ("clamped", "silent"))
    sunk = [float((run.point_y[-1] - run.point_y[0]).values.min()) for run in (held, silent)]
    moved = [float(np.abs((run.point_x[-1] - run.point_x[0]).values).min()) for run in (held, silent)]
    assert moved[0] < 1e-3 * DEPTH < moved[1]
    assert sunk[1] < sunk[0]
    assert abs(float(silent.energy_closure)) < 0.02
    assert float(silent.energy_damping[-1]) > 10 * float(held.energy_damping[-1])


def test_path_must_reach_beyond_the_travel():
    with pytest.raises(ConfigError, match=r"path_ratio = 9 .* more than travel_ratio = 11"):
        load("mpm", {"path_ratio": 9.0})
