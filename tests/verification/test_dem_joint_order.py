"""Sorting of joints into whole, broken and removed ones: nothing measurable changes, and little is computed."""

import numpy as np
import pytest

from orthocut.dem.packing import pack
from orthocut.dem.solver import advance
from orthocut.experiments.dem_cutting import make_scene
from orthocut.kernels.dem import layout
from orthocut.kernels.dem.joint_measure import measure_joints
from orthocut.kernels.dem.joint_order import IN_USE, NEEDLESS, PATIENCE, WHOLE, keep_tidy, sort_joints
from orthocut.measure.dem_cracks import cracks
from orthocut.params.case import validate

CASE = {
    "kind": "dem_cutting",
    "cut_depth": "0.08 mm",
    "travel": "0.2 mm",
    "cut_speed": "5 m/s",
    "packing": {"width": "0.4 mm", "height": "0.3 mm"},
}
NEVER = -(10**12)
"""Needless work from which it takes for ever to the next sort."""


def cut_untidily(steps=40000, elements=2):
    """Scene of a cut whose joints were never sorted."""
    case = validate({**CASE, "joint": {"elements": elements}})
    scene = make_scene(case, pack(case.packing))
    scene.joints.tidiness[NEEDLESS] = NEVER
    assert advance(scene, steps) == 0
    return scene


@pytest.fixture(scope="module")
def untidy():
    return cut_untidily()


def measured(scene):
    """Force, moment and bonded fraction of every joint, and their energy."""
    values = np.zeros((4, len(scene.joints.first)))
    return values, measure_joints(*values, scene.joints, scene.position, scene.law)


def copy_of(scene):
    case = validate(CASE)
    twin = make_scene(case, pack(case.packing))
    twin.thaw({name: values.copy() for name, values in scene.freeze().items()})
    return twin


def test_sort_leaves_what_is_measured_to_the_bit(untidy):
    scene = copy_of(untidy)
    before, energy = measured(scene)
    assert scene.cracks.count[0] > 50
    assert (scene.joints.live == 0).sum() > 20
    sort_joints(scene.joints, scene.law.elements)
    after, again = measured(scene)
    assert np.array_equal(before, after)
    assert energy == again


def test_sorted_joints_have_one_lane_each_and_removed_ones_none(untidy):
    scene = copy_of(untidy)
    sort_joints(scene.joints, scene.law.elements)
    joints = scene.joints
    live = np.flatnonzero(joints.live)
    assert (joints.place[joints.live == 0] == -1).all()
    assert np.array_equal(joints.owner[joints.place[live]], live)
    assert (joints.owner >= 0).sum() == len(live) == joints.lanes.sum()
    used = joints.owner >= 0
    assert np.array_equal(joints.lane_first[used], joints.first[joints.owner[used]])
    assert np.array_equal(joints.lane_second[used], joints.second[joints.owner[used]])
    intact = measured(scene)[0][3]
    whole = joints.place[live] < joints.tidiness[WHOLE] * layout.LANES
    assert np.array_equal(whole, intact[live] == 1)
    assert 0 < joints.tidiness[WHOLE] < joints.tidiness[IN_USE]
    assert -(-whole.sum() // layout.LANES) == joints.tidiness[WHOLE]


def test_a_step_after_a_sort_gives_the_same_velocities_to_rounding(untidy):
    tidy = copy_of(untidy)
    sort_joints(tidy.joints, tidy.law.elements)
    tidy.joints.tidiness[NEEDLESS] = NEVER
    other = copy_of(untidy)
    for scene in (tidy, other):
        assert advance(scene, 1) == 0
    scale = np.abs(other.velocity.reshape(-1, layout.ROW)).max(axis=0) + 1e-300
    assert (np.abs(tidy.velocity - other.velocity).reshape(-1, layout.ROW) / scale).max() < 1e-11
    assert tidy.tally == pytest.approx(other.tally, rel=1e-12)
    assert tidy.cracks.count[0] == other.cracks.count[0]


def test_a_tidy_cut_computes_few_joints_by_the_general_path_and_logs_cracks_at_their_joints():
    case = validate(CASE)
    scene = make_scene(case, pack(case.packing))
    start = scene.places.copy()
    assert advance(scene, 40000) == 0
    joints, found = scene.joints, cracks(scene)
    assert len(found.crack_bond) > 50
    middle = 0.5 * (start[joints.first // layout.ROW] + start[joints.second // layout.ROW])
    early = found.crack_time < found.crack_time[20]
    apart = np.hypot(found.crack_x - middle[found.crack_bond, 0], found.crack_y - middle[found.crack_bond, 1])
    assert apart[early].max() < 2 * scene.radius.max()
    broken = measured(scene)[0][3] < 1
    assert (found.crack_bond[:, None] == np.flatnonzero(broken)).any(axis=0).all()
    general = joints.lanes[joints.broken != 0].sum()
    assert general < 0.5 * len(joints.first)
    assert joints.tidiness[IN_USE] * layout.LANES < joints.live.sum() + PATIENCE + 2 * layout.LANES


def test_joints_are_sorted_when_the_needless_work_has_added_up(untidy):
    scene = copy_of(untidy)
    dead = int((scene.joints.live == 0).sum())
    scene.joints.tidiness[NEEDLESS] = NEVER
    keep_tidy(scene.joints, scene.law.elements)
    assert scene.joints.tidiness[NEEDLESS] >= NEVER + dead
    assert (scene.joints.place >= 0).all()
    scene.joints.tidiness[NEEDLESS] = PATIENCE - 1
    keep_tidy(scene.joints, scene.law.elements)
    assert scene.joints.tidiness[NEEDLESS] == 0
    assert (scene.joints.place < 0).sum() == dead


@pytest.mark.parametrize("elements", [1, 3])
def test_other_numbers_of_elements_are_sorted_alike(elements):
    scene = cut_untidily(20000, elements)
    before, _ = measured(scene)
    sort_joints(scene.joints, elements)
    assert np.array_equal(before, measured(scene)[0])
