"""What is watched while discs move: scenes of the random stress test that used to end as if nothing had happened."""

import numpy as np
import pytest

from orthocut.dem.setup import build, wall
from orthocut.experiments.dem_run import closure
from orthocut.kernels.dem.layout import TIP_X
from orthocut.measure.dem_energy import Energies, energies
from orthocut.measure.dem_watch import OVERLAP_LIMIT, overlap, watch
from orthocut.measure.guard import Diverged
from orthocut.params.case import load
from orthocut.params.dem import FlatJoint
from orthocut.run import run_case

R = 10e-6
SMALL = {"packing.width": "0.25 mm", "packing.height": "0.25 mm", "cut_depth": "0.06 mm"}


def pair(distance, walls=()):
    """Two discs installed where they touch, then set at a distance of their centres, in radii."""
    scene = build(np.array([0.0, 2 * R]), np.zeros(2), np.full(2, R), FlatJoint(), walls=list(walls))
    scene.places[1, 0] = distance * R
    return scene


@pytest.mark.parametrize("distance", [2.1, 2.0, 1.8, 1.3])
def test_overlap_is_that_of_the_two_discs_since_their_installation(distance):
    assert overlap(pair(distance)) == pytest.approx(max(2 - distance, 0.0), abs=1e-12)


def test_overlap_with_a_wall_counts():
    floor = wall((0.0, -0.4 * R), ((0.0, 1.0), (0.0, 1.0)), (0.0, 0.0), 0.0, 107e9)
    scene = pair(2.0, [floor])
    scene.walls.start[:] = [0, 2]
    scene.walls.disc[:2] = [0, 1]
    assert overlap(scene) == pytest.approx(0.6)


@pytest.mark.parametrize("half_angle", [0.1, 0.7])
def test_disc_that_touches_the_tip_of_a_thin_wedge_is_not_in_it(half_angle):
    """Both faces reach into the disc where they are longer than the tool; its tip does not."""
    sine, cosine = np.sin(half_angle), np.cos(half_angle)
    wedge = wall((3.0 * R, 0.0), ((-sine, cosine), (-sine, -cosine)), (0.0, 0.0), 0.0, 107e9)
    scene = pair(2.0, [wedge])
    scene.walls.start[:] = [0, 1]
    scene.walls.disc[0] = 1
    assert overlap(scene) == pytest.approx(0.0, abs=1e-12)
    scene.walls.rows[0, TIP_X] = 2.8 * R
    assert overlap(scene) == pytest.approx(0.2)


def test_discs_pressed_into_each_other_stop_the_run():
    scene = pair(2.0)
    start = energies(scene)
    watch(scene, start, start)
    scene.places[1, 0] = (2 - 1.01 * OVERLAP_LIMIT) * R
    pressed = energies(scene)
    with pytest.raises(Diverged, match=r"by 0\.5\d of their radius \(allowed: 0\.5\).*strengths"):
        watch(scene, pressed._replace(work_tool=pressed.energy_elastic), start)


@pytest.mark.parametrize("made", [-0.06, 0.06])
def test_energy_from_nowhere_or_to_nowhere_stops_the_run(made):
    scene = pair(2.0)
    start = energies(scene)
    spent = Energies(1.0, 0.0, 0.5, 0.2, 0.2, 0.1 + made)
    with pytest.raises(Diverged, match=r"of the work is not accounted for.*time_step_factor"):
        watch(scene, spent, start)
    watch(scene, spent._replace(energy_fracture=0.1 + made / 2), start)


def test_a_number_that_is_none_stops_the_run():
    scene = pair(2.0)
    start = energies(scene)
    with pytest.raises(Diverged):
        watch(scene, start._replace(energy_elastic=float("nan")), start)


def test_bonds_stronger_than_their_modulus_are_not_cut_quietly():
    """Soft and unbreakable: the tool squeezed discs through each other, and the run was done."""
    soft = {"joint.modulus": "1 GPa", "strength_tensile": "100 GPa", "cohesion": "100 GPa", "travel": "0.1 mm"}
    with pytest.raises(Diverged, match="discs overlap"):
        run_case(load("dem", {**SMALL, **soft}))


def test_a_steep_tool_meets_the_block_at_once():
    """Its rake face would touch discs below the tip from far away; the tool used to end its travel in the air."""
    steep = {"rake_angle": "68 deg", "clearance_angle": "10 deg", "travel": "2 um"}
    run = run_case(load("dem", {**SMALL, **steep}))
    assert float(run.force_cutting[:5].mean()) > 0
    assert float(run.work_tool[-1]) > 0


def test_closure_of_a_run_without_work_is_zero():
    nothing = Energies(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert closure(nothing, nothing) == 0.0
