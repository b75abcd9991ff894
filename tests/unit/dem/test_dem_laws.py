"""Laws of flat joints and linear contacts, each alone; the plain Python functions behind the compiled ones."""

import numpy as np
import pytest
from scipy.integrate import quad

from orthocut.kernels.laws import flat_joint
from orthocut.kernels.laws.linear_contact import linear_contact

closure = flat_joint.element_closure.py_func
failure = flat_joint.element_failure.py_func
slip = flat_joint.element_slip.py_func
intact = flat_joint.joint_intact.py_func
contact = linear_contact.py_func

STIFFNESS, HALF = 5.0, 0.7
GAPS = [-0.9, -0.2, -0.05, 0.0, 0.05, 0.2, 0.9]
ROTATIONS = [-0.8, -0.1, 0.0, 0.1, 0.8]


def by_quadrature(bonded, gap, rotation, weight):
    """Integral over the element of weight(y, stress)."""

    def integrand(y):
        opening = gap - rotation * y
        return weight(y, STIFFNESS * (opening if bonded else min(opening, 0.0)), opening)

    edge = [gap / rotation] if rotation and abs(gap / rotation) < HALF else None
    return quad(integrand, -HALF, HALF, points=edge, epsabs=1e-13, epsrel=1e-12)[0]


@pytest.mark.parametrize("bonded", [0.0, 1.0])
@pytest.mark.parametrize("gap", GAPS)
@pytest.mark.parametrize("rotation", ROTATIONS)
def test_normal_response_is_the_integral_over_the_closed_part(bonded, gap, rotation):
    force, moment, energy = closure(bonded, gap, rotation, HALF, STIFFNESS)
    assert force == pytest.approx(by_quadrature(bonded, gap, rotation, lambda y, s, g: s), abs=1e-12)
    assert moment == pytest.approx(by_quadrature(bonded, gap, rotation, lambda y, s, g: y * s), abs=1e-12)
    assert energy == pytest.approx(by_quadrature(bonded, gap, rotation, lambda y, s, g: 0.5 * s * g), abs=1e-12)


@pytest.mark.parametrize("gap", [-0.9, -0.21, -0.03, 0.04, 0.31])
@pytest.mark.parametrize("rotation", [-0.8, -0.13, 0.2, 0.7])
def test_force_and_moment_derive_from_the_energy(gap, rotation):
    step = 1e-6
    force, moment, _ = closure(0.0, gap, rotation, HALF, STIFFNESS)
    by_gap = [closure(0.0, gap + s, rotation, HALF, STIFFNESS)[2] for s in (-step, step)]
    by_rotation = [closure(0.0, gap, rotation + s, HALF, STIFFNESS)[2] for s in (-step, step)]
    assert force == pytest.approx((by_gap[1] - by_gap[0]) / (2 * step), abs=1e-8)
    assert moment == pytest.approx(-(by_rotation[1] - by_rotation[0]) / (2 * step), abs=1e-8)


@pytest.mark.parametrize("rotation", [0.3, -0.3])
@pytest.mark.parametrize("side", [-1, 1])
def test_partial_closure_is_continuous_where_it_starts_and_ends(rotation, side):
    switch = side * abs(rotation) * HALF
    inner, outer = (np.array(closure(0.0, switch + d, rotation, HALF, STIFFNESS)) for d in (-1e-9, 1e-9))
    assert inner == pytest.approx(outer, abs=2e-8)


@pytest.mark.parametrize("elements", [1, 2, 3, 4])
def test_whole_joint_is_the_sum_of_its_elements(elements):
    gap, rotation, shear = 0.03, -0.2, 4.0
    normal, tangential, moment, largest = intact(gap, rotation, shear, HALF, STIFFNESS, (elements - 1) / elements)
    half = HALF / elements
    total = np.zeros(2)
    stresses = []
    for e in range(elements):
        y = (2 * e + 1 - elements) * half
        force, own, _ = closure(1.0, gap - rotation * y, rotation, half, STIFFNESS)
        total += force, y * force + own
        stresses.append(force / (2 * half))
    assert (normal, moment) == pytest.approx(tuple(total), rel=1e-13)
    assert tangential == pytest.approx(2 * HALF * shear)
    assert largest == pytest.approx(max(stresses), rel=1e-13)


@pytest.mark.parametrize(
    ("normal", "shear", "mode"),
    [
        (199.0, 0.0, 0),
        (201.0, 0.0, 1),
        (201.0, 500.0, 1),
        (0.0, 112.9, 0),
        (0.0, 113.1, 2),
        (0.0, -113.1, 2),
        (-100.0, 162.9, 0),
        (-100.0, 163.1, 2),
        (100.0, 62.9, 0),
        (100.0, 63.1, 2),
    ],
)
def test_strength_is_a_tension_limit_and_a_coulomb_line(normal, shear, mode):
    assert failure(normal, shear, 200.0, 113.0, 0.5) == mode


def test_slip_keeps_the_shear_stress_within_friction():
    assert slip(3.0, -10.0, 0.5) == 3.0
    assert slip(7.0, -10.0, 0.5) == 5.0
    assert slip(-7.0, -10.0, 0.5) == -5.0
    assert slip(7.0, 0.0, 0.5) == 0.0


def test_linear_contact_loses_exactly_the_work_of_friction():
    stiffness, ratio, friction = 100.0, 3.1, 0.4
    shear, work, lost = 0.0, 0.0, 0.0
    random = np.random.default_rng(1)
    for step in random.normal(scale=2e-3, size=400):
        push, after, loss = contact(-0.01, shear, step, stiffness, ratio, friction)
        assert push == pytest.approx(1.0)
        assert abs(after) <= friction * push
        assert loss >= 0
        work -= 0.5 * (shear + after) * step
        lost += loss
        shear = after
    assert lost > 0.1 * friction * 2e-3
    assert work == pytest.approx(lost + 0.5 * shear**2 * ratio / stiffness, rel=1e-12)


def test_linear_contact_does_not_pull():
    assert contact(1e-9, 5.0, 1e-3, 100.0, 3.1, 0.4)[:2] == (0.0, 0.0)
