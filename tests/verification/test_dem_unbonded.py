"""Slit and gapped joints of two discs against exact values: compression, friction, rotation, partial closure."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from orthocut.dem.joint_kinds import GAPPED, SLIT
from orthocut.dem.setup import build
from orthocut.dem.solver import DONE, advance
from orthocut.kernels.dem.joint_measure import measure_joints
from orthocut.measure.dem_energy import energies
from orthocut.params.dem import FlatJoint

R = 10e-6
JOINT = FlatJoint()
MODULUS, RATIO, FRICTION = JOINT.modulus, JOINT.stiffness_ratio, JOINT.friction
STIFFNESS = MODULUS / (2 * R)
ENDS = np.array([0, 1])
OPENING = 0.002
KINDS = {SLIT: {"fraction_slit": 1.0}, GAPPED: {"fraction_gapped": 1.0, "gapped_opening": OPENING}}


def two_discs(kind, overlap=0.0, **values):
    law = FlatJoint.model_construct(**{**JOINT.__dict__, **KINDS[kind], **values})
    x = np.array([0.0, 2 * R * (1 - overlap)])
    scene = build(x, np.zeros(2), np.full(2, R), law, driven=ENDS, group=ENDS)
    assert scene.joints.kind.tolist() == [kind]
    return scene


def displace(scene, approach=0.0, turn=0.0, slide=0.0, steps=200):
    """Move the second disc by an approach, turn it, slide it (by turning both), each at a constant rate."""
    time = steps * scene.time_step
    scene.speeds[1, 0] = -approach / time
    scene.speeds[1, 2] = turn / time
    scene.speeds[:, 2] += slide / (scene.places[1, 0] - scene.places[0, 0]) / time
    assert advance(scene, steps) == DONE
    scene.speeds[:] = 0.0


def resultants(scene):
    """Normal and shear force [N/m] and moment [N] of the only joint, along the x axis."""
    values = np.zeros((4, 1))
    measure_joints(*values, scene.joints, scene.position, scene.law)
    assert values[3, 0] == 0
    return values[:3, 0]


@pytest.mark.parametrize("elements", [1, 2, 3, 4])
@pytest.mark.parametrize("overlap", [0.0, 0.05])
def test_slit_carries_compression_as_a_bond_and_no_tension(elements, overlap):
    scene = two_discs(SLIT, overlap, elements=elements)
    displace(scene, approach=3e-9)
    assert resultants(scene) == pytest.approx([-2 * R * MODULUS / (2 * R) * 3e-9, 0, 0], rel=1e-6, abs=1e-9)
    displace(scene, approach=-8e-9)
    assert resultants(scene) == pytest.approx([0, 0, 0], abs=1e-12)
    assert scene.joints.live[0] == 1
    displace(scene, approach=6e-9)
    assert resultants(scene)[0] == pytest.approx(-MODULUS * 1e-9, rel=1e-5)
    assert scene.cracks.count[0] == 0


@pytest.mark.parametrize("elements", [1, 2, 3, 4])
def test_gapped_joint_carries_nothing_until_its_gap_has_closed(elements):
    scene = two_discs(GAPPED, elements=elements)
    displace(scene, approach=0.9 * OPENING * R)
    assert resultants(scene) == pytest.approx([0, 0, 0], abs=1e-12)
    displace(scene, approach=0.3 * OPENING * R)
    assert resultants(scene) == pytest.approx([-MODULUS * 0.2 * OPENING * R, 0, 0], rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("direction", [1, -1])
@pytest.mark.parametrize("elements", [1, 3])
def test_closed_slit_sticks_with_the_shear_stiffness_and_slips_at_friction(direction, elements):
    scene = two_discs(SLIT, elements=elements)
    approach = 2e-8
    displace(scene, approach=approach)
    push = MODULUS * approach
    limit = FRICTION * push / (MODULUS / RATIO)
    displace(scene, slide=0.5 * direction * limit)
    assert resultants(scene)[1] == pytest.approx(-0.5 * direction * FRICTION * push, rel=1e-6)
    displace(scene, slide=direction * 3 * limit)
    assert resultants(scene)[1] == pytest.approx(-direction * FRICTION * push, rel=1e-6)
    slipped = 2.5 * limit
    assert energies(scene).energy_friction == pytest.approx(FRICTION * push * slipped, rel=1e-4)
    displace(scene, approach=-2 * approach)
    assert resultants(scene) == pytest.approx([0, 0, 0], abs=1e-12)


def by_quadrature(gap, turn):
    """Normal force and moment of a face whose gap is gap - turn y, closed parts only."""
    edge = [gap / turn] if turn and abs(gap / turn) < R else None

    def integral(weight):
        value = quad(
            lambda y: weight(y / R) * min((gap - turn * y) / R, 0.0), -R, R, points=edge, epsabs=0, epsrel=1e-10
        )
        return STIFFNESS * R * value[0]

    return integral(lambda place: 1.0), R * integral(lambda place: place)


@pytest.mark.parametrize("elements", [1, 2, 3, 4])
@pytest.mark.parametrize("turn", [1e-3, -1e-3])
@pytest.mark.parametrize("reach", [-0.4, -0.1, 0.2, 0.6, 0.95])
def test_partly_closed_faces_have_the_resultants_of_quadrature(elements, turn, reach):
    """The gap at the centre is `reach` times that at which the faces leave each other."""
    scene = two_discs(SLIT, elements=elements, friction=0.0)
    gap = reach * abs(turn) * R
    displace(scene, approach=-gap, turn=turn)
    force, moment = by_quadrature(gap, turn)
    assert force < 0
    assert resultants(scene) == pytest.approx([force, 0, moment], rel=1e-5, abs=1e-9 * STIFFNESS * R * abs(turn) * R)


@pytest.mark.parametrize("elements", [1, 2, 3, 4])
@pytest.mark.parametrize("side", [1, -1])
def test_forces_are_continuous_where_the_faces_start_to_part_and_where_they_leave_each_other(elements, side):
    turn = 1e-3
    scene = two_discs(SLIT, elements=elements, friction=0.0)
    switch, near = side * turn * R, 1e-6 * R * turn
    displace(scene, approach=-(switch - near), turn=turn, steps=1000)
    before = resultants(scene)
    displace(scene, approach=-2 * near, steps=10)
    change = np.abs(resultants(scene) - before)
    assert change[0] <= 2 * R * STIFFNESS * 2.001 * near
    assert change[2] <= 2 * R * R * STIFFNESS * 2.001 * near


@pytest.mark.parametrize("kind", [SLIT, GAPPED])
def test_closing_and_opening_by_rotation_gives_back_all_energy(kind):
    scene = two_discs(kind, friction=0.0)
    displace(scene, approach=4e-9 + OPENING * R * (kind == GAPPED), steps=4000)
    start = energies(scene)
    displace(scene, turn=2e-3, steps=4000)
    loaded = energies(scene)
    displace(scene, turn=-4e-3, steps=4000)
    mirrored = energies(scene)
    displace(scene, turn=2e-3, steps=4000)
    assert loaded.energy_elastic > 2 * start.energy_elastic
    assert mirrored.energy_elastic == pytest.approx(loaded.energy_elastic, rel=1e-6)
    assert energies(scene).energy_elastic == pytest.approx(start.energy_elastic, rel=1e-6)
    assert energies(scene).work_tool == pytest.approx(start.work_tool, rel=0.02)


@pytest.mark.parametrize("elements", [1, 2, 4])
def test_element_over_both_limits_breaks_in_tension_and_drops_to_zero(elements):
    """A pull beyond the tensile strength under a shear stress beyond the shear strength: tension is tested first."""
    law = FlatJoint.model_construct(**{**JOINT.__dict__, "elements": elements})
    x = np.array([0.0, 2 * R])
    scene = build(x, np.zeros(2), np.full(2, R), law, driven=ENDS, group=ENDS)
    stretch = 1.5 * JOINT.strength_tensile / STIFFNESS
    slide = 2 * JOINT.cohesion * RATIO / STIFFNESS
    displace(scene, approach=-stretch, slide=slide, steps=1)
    values = np.zeros((4, 1))
    measure_joints(*values, scene.joints, scene.position, scene.law)
    rows = scene.cracks.log.reshape(-1, 6)[: int(scene.cracks.count[0])]
    assert len(rows) == elements
    assert (rows[:, 5] % 2 == 0).all()
    assert values[:, 0] == pytest.approx([0, 0, 0, 0], abs=1e-12)


@pytest.mark.parametrize("elements", [1, 2, 3, 4])
def test_crack_log_holds_step_place_normal_and_mode_of_every_element(elements):
    angle = math.radians(30)
    axis = np.array([math.cos(angle), math.sin(angle)])
    law = FlatJoint.model_construct(**{**JOINT.__dict__, "elements": elements})
    x, y = np.outer(axis, [0.0, 2 * R])
    scene = build(x, y, np.full(2, R), law, driven=ENDS, group=ENDS)
    stretch = 1.001 * JOINT.strength_tensile / STIFFNESS
    scene.speeds[1, :2] = stretch / (100 * scene.time_step) * axis
    assert advance(scene, 100) == DONE
    rows = scene.cracks.log.reshape(-1, 6)[: int(scene.cracks.count[0])]
    offsets = (2 * np.arange(elements) + 1 - elements) * R / elements
    middle = axis * (R + 0.5 * stretch)
    tangent = np.array([-axis[1], axis[0]])
    assert rows[:, 0].tolist() == [100] * elements
    assert rows[:, 1:3] == pytest.approx(middle + np.outer(offsets, tangent), rel=1e-6, abs=1e-12)
    assert rows[:, 3:5] == pytest.approx(np.tile(axis, (elements, 1)), rel=1e-9)
    assert rows[:, 5].tolist() == [0] * elements
