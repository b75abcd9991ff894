"""Two discs and a joint against exact values: stiffness, strength, bending, shear, friction, oscillation."""

import math

import numpy as np
import pytest

from orthocut.dem.setup import build
from orthocut.dem.solver import DONE, advance
from orthocut.kernels.dem.joint_measure import measure_joints
from orthocut.measure.dem_cracks import count_cracks, cracks
from orthocut.measure.dem_energy import energies
from orthocut.params.dem import FlatJoint

R = 10e-6
JOINT = FlatJoint()
MODULUS, RATIO = JOINT.modulus, JOINT.stiffness_ratio
TANGENT = math.tan(JOINT.friction_angle)


def joint(**values):
    return FlatJoint.model_construct(**{**JOINT.__dict__, **values})


def two_discs(first=R, second=R, overlap=0.0, driven=True, **values):
    x = np.array([0.0, (first + second) * (1 - overlap)])
    fixed = np.array([0, 1]) if driven else np.zeros(0, dtype=np.int64)
    return build(x, np.zeros(2), np.array([first, second]), joint(**values), driven=fixed, group=fixed)


def run(scene, steps):
    assert advance(scene, steps) == DONE


def measured(scene):
    """Force on the first disc, moment, fraction intact of the only joint."""
    values = np.zeros((4, 1))
    measure_joints(*values, scene.joints, scene.position, scene.law)
    return values[:, 0]


def stresses(scene):
    """Normal and shear stress of the only joint, in its own frame."""
    axis = scene.places[1] - scene.places[0]
    axis = axis / np.hypot(*axis)
    force = measured(scene)[:2] / (2 * R)
    return force @ axis, force @ [-axis[1], axis[0]]


def step_until_crack(scene, limit=20_000):
    before = stresses(scene)
    for _ in range(limit):
        run(scene, 1)
        if scene.cracks.count[0]:
            return before
        before = stresses(scene)
    pytest.fail("no crack")


@pytest.mark.parametrize("second", [R, 1.3 * R])
@pytest.mark.parametrize("overlap", [0.0, 0.05])
@pytest.mark.parametrize("elements", [1, 2, 3, 4])
def test_axial_stiffness_forgets_the_overlap_of_the_packing(second, overlap, elements):
    scene = two_discs(second=second, overlap=overlap, elements=elements)
    scene.speeds[1, 0] = 0.01
    start = scene.places[1, 0]
    run(scene, 500)
    stretch = scene.places[1, 0] - start
    assert measured(scene)[0] == pytest.approx(MODULUS * 2 * R / (R + second) * stretch, rel=1e-9)
    assert measured(scene)[1:3] == pytest.approx([0, 0], abs=1e-9)


@pytest.mark.parametrize("elements", [1, 2, 4])
def test_joint_breaks_in_tension_at_its_strength(elements):
    scene = two_discs(elements=elements)
    scene.speeds[1, 0] = 0.01
    before, _ = step_until_crack(scene)
    step = MODULUS / (2 * R) * 0.01 * scene.time_step
    assert JOINT.strength_tensile - step < before <= JOINT.strength_tensile
    assert count_cracks(scene) == (elements, 0)
    assert measured(scene) == pytest.approx([0, 0, 0, 0], abs=1e-12)


def test_broken_joint_releases_its_elastic_energy():
    scene = two_discs()
    scene.speeds[1, 0] = 0.01
    step_until_crack(scene)
    expected = JOINT.strength_tensile**2 / (2 * MODULUS / (2 * R)) * 2 * R
    balance = energies(scene)
    assert balance.energy_fracture == pytest.approx(expected, rel=2e-3)
    assert balance.total == pytest.approx(0, abs=2e-3 * expected)


@pytest.mark.parametrize("elements", [1, 2, 3, 4])
def test_bending_stiffness_is_that_of_the_whole_face(elements):
    scene = two_discs(elements=elements)
    scene.speeds[1, 2] = 100.0
    run(scene, 400)
    angle = scene.position[6]
    stiffness = MODULUS / (2 * R)
    assert measured(scene)[2] == pytest.approx(-stiffness * 2 / 3 * R**3 * angle, rel=1e-9)


@pytest.mark.parametrize("elements", [2, 3, 4])
@pytest.mark.parametrize("spin", [400.0, -400.0])
def test_bending_breaks_the_outermost_element_on_the_opening_side(elements, spin):
    scene = two_discs(elements=elements, cohesion=1e12)
    scene.speeds[1, 2] = spin
    step_until_crack(scene)
    stiffness, outermost = MODULUS / (2 * R), (elements - 1) * R / elements
    angle = abs(scene.position[6])
    step = abs(spin) * scene.time_step
    assert stiffness * (angle - step) * outermost <= JOINT.strength_tensile < stiffness * angle * outermost
    assert count_cracks(scene) == (1, 0)
    assert cracks(scene).crack_y[0] == pytest.approx(-math.copysign(outermost, spin), rel=1e-9)


@pytest.mark.parametrize("pressed", [0.0, 50e6, 300e6])
@pytest.mark.parametrize("direction", [1, -1])
@pytest.mark.parametrize("elements", [1, 2, 3, 4])
def test_shear_strength_and_residual_friction(pressed, direction, elements):
    scene = two_discs(elements=elements)
    steps = 200
    scene.speeds[1, 0] = -pressed / (MODULUS / (2 * R)) / (steps * scene.time_step)
    run(scene, steps)
    scene.speeds[1, 0] = 0.0
    scene.speeds[1, 1] = 0.02 * direction
    normal, shear = step_until_crack(scene)
    strength = JOINT.cohesion - normal * TANGENT
    step = MODULUS / (2 * R) / RATIO * 0.02 * scene.time_step
    assert normal == pytest.approx(-pressed, rel=0.02, abs=4e6)
    assert strength - 2 * step < direction * shear <= strength
    assert count_cracks(scene) == (0, elements)
    run(scene, 20)
    normal, shear = stresses(scene)
    assert direction * shear == pytest.approx(max(JOINT.friction * -normal, 0.0), rel=1e-9, abs=1.0)


def test_rigid_rotation_by_a_full_turn_gives_no_force():
    angle = np.radians(np.arange(0, 360, 60))
    x, y = np.append(0, 2 * R * np.cos(angle)), np.append(0, 2 * R * np.sin(angle))
    everything = np.arange(7)
    radius = np.full(7, R)
    scene = build(x, y, radius, joint(), driven=everything, group=everything)
    assert len(scene.joints.first) == 12
    steps = 4000
    turns = 2 * np.pi * np.arange(steps + 1) / steps
    path = (np.array([np.cos(turns), -np.sin(turns)]), np.array([np.sin(turns), np.cos(turns)]))
    dt = scene.time_step
    scene = scene._replace(speed_limit=np.inf, skin=1.0)
    for k in range(steps):
        place = np.column_stack([part[:, k + 1] @ np.array([x, y]) for part in path])
        scene.speeds[:, :2] = (place - scene.places) / dt
        scene.speeds[:, 2] = 2 * np.pi / steps / dt
        run(scene, 1)
    assert scene.position[2] == pytest.approx(2 * np.pi)
    values = np.zeros((4, 12))
    measure_joints(*values, scene.joints, scene.position, scene.law)
    assert np.abs(values[:2]).max() / (2 * R) < 1e-10 * MODULUS
    assert np.abs(values[2]).max() / (2 * R * R) < 1e-10 * MODULUS
    assert values[3].min() == 1


def oscillator(damping, time_step=None):
    """Two free discs at rest, their joint stretched by a tenth of its strength."""
    scene = two_discs(driven=False, damping=damping)
    stretch = 0.1 * JOINT.strength_tensile / (MODULUS / (2 * R))
    scene.position[0] -= stretch / 2
    scene.position[4] += stretch / 2
    mass = JOINT.density * math.pi * R**2
    frequency = math.sqrt(2 * MODULUS / mass)
    return (scene if time_step is None else scene._replace(time_step=time_step / frequency)), stretch, frequency


def gaps(scene, steps):
    found = []
    for _ in range(steps):
        run(scene, 1)
        found.append(scene.places[1, 0] - scene.places[0, 0] - 2 * R)
    return np.array(found)


def test_undamped_oscillator_has_the_exact_frequency_of_leap_frog():
    scene, stretch, frequency = oscillator(0.0, 0.1)
    found = gaps(scene, 4000)
    dt = scene.time_step
    exact = 2 / dt * math.asin(frequency * dt / 2)
    # Velocities are half a step behind, and start at zero: the first step keeps the stretch.
    times = dt * np.arange(4000)
    phase = exact * dt / 2
    assert found == pytest.approx(stretch * np.cos(exact * times + phase) / math.cos(phase), abs=2e-6 * stretch)


@pytest.mark.parametrize(("product", "stable"), [(1.99, True), (2.01, False)])
def test_stability_limit_is_two_over_the_frequency(product, stable):
    scene, stretch, _ = oscillator(0.0, product)
    unbreakable = scene.law._replace(strength_tensile=1e30, cohesion=1e30)
    scene = scene._replace(law=unbreakable, speed_limit=np.inf, skin=1.0)
    largest = np.abs(gaps(scene, 60)).max() / stretch
    assert (largest < 20) == stable


def test_local_damping_shrinks_every_half_swing_by_the_exact_ratio():
    damping = 0.3
    scene, stretch, _ = oscillator(damping, 0.01)
    found = gaps(scene, 2500) / stretch
    turns = [abs(found[k]) for k in range(1, 2499) if (found[k] - found[k - 1]) * (found[k + 1] - found[k]) < 0]
    expected = math.sqrt((1 - damping) / (1 + damping))
    assert len(turns) >= 5
    assert np.array(turns[1:5]) / turns[:4] == pytest.approx(expected, rel=0.01)


def test_removed_joint_leaves_a_contact_at_its_own_distance():
    """An overlap of five per cent stays forgotten after the joint is broken, opened and removed."""
    scene = two_discs(overlap=0.05)
    start = scene.places[1, 0]
    scene.speeds[1, 0] = 1.0
    run(scene, 3000)
    assert scene.joints.live[0] == 0
    scene.speeds[1, 0] = -1.0
    scene.reaction[:] = 0.0
    opened = scene.places[1, 0] - start
    while scene.places[1, 0] > start + 2e-9:
        run(scene, 1)
    assert opened > 3e-6
    assert scene.reaction[0] == 0
    for _ in range(5):
        run(scene, 1)
        closed = min(scene.places[1, 0] - start, 0.0)
        assert scene.reaction[0] == pytest.approx(MODULUS * closed, rel=1e-9, abs=1e-6)
        scene.reaction[:] = 0.0
    assert closed < -4e-9


def test_sliding_joint_loses_the_work_of_friction_and_is_removed_when_its_faces_have_parted():
    """Both discs turn the same way under a fixed approach; a linear contact takes over with the same force."""
    scene = two_discs()
    approach, spin, steps = 2e-8, 1e5, 200
    scene.speeds[1, 0] = -approach / (steps * scene.time_step)
    run(scene, steps)
    scene.speeds[1, 0] = 0.0
    push = MODULUS * approach
    assert measured(scene)[0] == pytest.approx(-push, rel=1e-6)

    scene.speeds[:, 2] = spin
    while not scene.cracks.count[0]:
        run(scene, 1)
    cracked, turned = energies(scene), scene.position[2]
    removed = None
    while scene.position[2] < 1.2:
        run(scene, 100)
        if removed is None and not scene.joints.live[0]:
            removed = scene.position[2]
    # The broken joint turns with its faces until they have shifted by their length, 2 R, at one radian.
    slipped = 2 * R * (scene.position[2] - turned)
    last = energies(scene)
    assert removed == pytest.approx(1.0, rel=0.05)
    assert last.energy_friction - cracked.energy_friction == pytest.approx(JOINT.friction * push * slipped, rel=0.01)
    scene.reaction[:] = 0.0
    run(scene, 1)
    assert scene.reaction[:2] == pytest.approx([-push, -JOINT.friction * push], rel=1e-6)


def test_pressed_joint_with_short_faces_stays_until_the_contact_after_it_holds_no_more_energy():
    """Faces of a fifth of the discs are a fifth as stiff: to remove them under pressure would make energy."""
    scene = two_discs(radius_multiplier=0.2)
    steps = 200
    scene.speeds[1, 0] = -2e-8 / (steps * scene.time_step)
    run(scene, steps)
    scene.speeds[1, 0] = 0.0
    scene.speeds[:, 2] = 1e5
    while not scene.cracks.count[0]:
        run(scene, 1)
    broken = energies(scene).energy_fracture
    while scene.position[2] < 0.8:
        run(scene, 100)
    assert scene.joints.live[0] == 1
    scene.speeds[:, 2] = 0.0
    scene.speeds[1, 0] = 1.0
    run(scene, 500)
    assert scene.joints.live[0] == 0
    assert energies(scene).energy_fracture >= broken > 0
