"""One disc at rigid walls against exact values: faces, the tip of a wedge, friction, no force twice."""

import math

import numpy as np
import pytest

from orthocut.dem.setup import build, wall
from orthocut.dem.solver import DONE, advance
from orthocut.kernels.dem import layout
from orthocut.params.dem import FlatJoint

R = 10e-6
JOINT = FlatJoint()
STIFFNESS = 2 * JOINT.modulus
"""Force per overlap of a disc at a wall, for unit width [Pa]: E A/L with A = 2 R and L = R."""
RAKE, CLEARANCE = math.radians(-15), math.radians(15)
FACES = ((-math.cos(RAKE), math.sin(RAKE)), (math.sin(CLEARANCE), -math.cos(CLEARANCE)))
ONE = np.array([0])


def disc_at(place, faces, friction=0.577, velocity=(0.0, 0.0)):
    """A disc held at a place, and a wedge with its tip at the origin."""
    scene = build(
        np.array([place[0]]), np.array([place[1]]), np.array([R]), JOINT,
        walls=[wall((0.0, 0.0), faces, velocity, friction, JOINT.modulus)], driven=ONE, group=ONE,
    )  # fmt: skip
    return scene._replace(skin=0.4 * R)


def force_on_disc(scene):
    """Force of the walls on the disc in one more step [N/m]."""
    scene.reaction[:] = 0.0
    assert advance(scene, 1) == DONE
    return scene.reaction.copy()


@pytest.mark.parametrize("overlap", [1e-4, 1e-3, 1e-2])
@pytest.mark.parametrize("face", [0, 1])
def test_face_pushes_along_its_normal_with_the_stiffness_of_a_wall(face, overlap):
    normal = np.array(FACES[face])
    # Along the face, away from the tip: perpendicular to the normal, on the inner side of the other face.
    along = np.array([-normal[1], normal[0]])
    along *= -np.sign(along @ FACES[1 - face])
    scene = disc_at(3 * R * along + (1 - overlap) * R * normal, FACES)
    assert force_on_disc(scene) == pytest.approx(STIFFNESS * overlap * R * normal, rel=1e-9)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_tip_pushes_towards_the_centre_of_the_disc(share):
    """Directions between the normals of both faces belong to the tip, and only one force acts."""
    angles = [math.atan2(normal[1], normal[0]) for normal in FACES]
    first, second = angles[0] % (2 * math.pi), angles[1] % (2 * math.pi)
    angle = first + share * (second - first)
    direction = np.array([math.cos(angle), math.sin(angle)])
    scene = disc_at(0.999 * R * direction, FACES)
    assert force_on_disc(scene) == pytest.approx(STIFFNESS * 1e-3 * R * direction, rel=1e-9)


@pytest.mark.parametrize("face", [0, 1])
def test_force_is_continuous_from_the_face_over_the_tip(face):
    normal = np.array(FACES[face])
    along = np.array([-normal[1], normal[0]])
    found = [force_on_disc(disc_at(shift * R * along + 0.999 * R * normal, FACES)) for shift in (-1e-6, 1e-6)]
    assert found[0] == pytest.approx(found[1], abs=3e-6 * STIFFNESS * R)


def test_wall_that_slides_drags_by_the_shear_stiffness_and_then_by_friction():
    up = (0.0, 1.0)
    scene = disc_at((0.0, 0.999 * R), (up, up), velocity=(1.0, 0.0))
    push = STIFFNESS * 1e-3 * R
    # The list of discs near walls is made in the first step.
    first = force_on_disc(scene)
    assert first == pytest.approx([STIFFNESS / JOINT.stiffness_ratio * scene.time_step, push], rel=1e-9)
    assert advance(scene, 200) == DONE
    assert force_on_disc(scene) == pytest.approx([JOINT.friction * push, push], rel=1e-9)
    row = scene.walls.rows[0]
    assert (row[layout.WALL_FORCE_X], row[layout.WALL_FORCE_Y]) == pytest.approx((-JOINT.friction * push, -push))


def test_disc_that_rolls_on_a_wall_is_not_dragged():
    up = (0.0, 1.0)
    scene = disc_at((0.0, 0.999 * R), (up, up), velocity=(1.0, 0.0))
    scene.speeds[0, 0] = 2.0
    scene.speeds[0, 2] = -1.0 / (0.999 * R)
    assert force_on_disc(scene)[0] == pytest.approx(0.0, abs=1e-9 * STIFFNESS * R)


def test_disc_between_two_walls_feels_both():
    walls = [wall((0.0, 0.0), (normal, normal), (0.0, 0.0), 0.0, JOINT.modulus) for normal in ((0.0, 1.0), (1.0, 0.0))]
    scene = build(np.array([0.999 * R]), np.array([0.998 * R]), np.array([R]), JOINT, walls, ONE, ONE)
    assert force_on_disc(scene) == pytest.approx([STIFFNESS * 1e-3 * R, STIFFNESS * 2e-3 * R], rel=1e-9)
