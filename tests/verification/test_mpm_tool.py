"""A body on the rigid faces of the tool: sliding, sticking and the direction of forces (T9, T10)."""

import math

import numpy as np
import pytest
from bodies import Bodies, Wedge, rectangle

from orthocut.kernels.mpm import layout, step

CELL = 1e-3
GRAVITY = 1e5
AT_ONCE = 1e-300


def slide(face, slope, friction, support):
    """A block on the rake face under gravity for 600 steps.

    Parameters
    ----------
    face : float
        Rake angle [deg]; with 90 degrees the face lies along the grid.
    slope : float
        Angle between gravity and the normal of the face [deg].

    Returns
    -------
    acceleration : float
        Mean acceleration along the face over gravity.
    pressed, rubbed : float
        Mean normal force and friction over weight.
    slid, sunk : float
        Way along and into the face, in cells.
    """
    c, s = math.cos(math.radians(face)), math.sin(math.radians(face))
    normal, along = np.array([c, -s]), np.array([s, c])
    tangent_place, outward = rectangle(4, 10, 0, 4, CELL)
    block = Bodies(
        tangent_place * along[:, None] - outward * normal[:, None],
        cell=CELL,
        room=10,
        support=support,
        wedge=Wedge(math.radians(face), 0.0, friction, 0.0, AT_ONCE, 0.0),
        tip=0.0,
    )
    pull = GRAVITY * (math.cos(math.radians(slope)) * normal + math.sin(math.radians(slope)) * along)

    def gravity(nodes, body):
        if body == layout.CHIP:
            nodes[..., layout.NFX] += pull[0] * nodes[..., layout.NM]
            nodes[..., layout.NFY] += pull[1] * nodes[..., layout.NM]

    start = block.place.mean(axis=1)
    block.run(600, gravity)
    way = (block.place.mean(axis=1) - start) / CELL
    weight = block.mass.sum() * GRAVITY * block.time
    impulse = block.state.totals[[step.CHIP_X, step.CHIP_Y]] / weight
    return block.momentum @ along / weight, -impulse @ normal, -impulse @ along, way @ along, way @ normal


@pytest.mark.parametrize("support", [0.0, 0.1])
@pytest.mark.parametrize("face", [90.0, 60.0, 30.0])
@pytest.mark.parametrize(("slope", "friction"), [(30.0, 0.3), (45.0, 0.0)])
def test_block_slides_down_a_rough_face(face, slope, friction, support):
    """Exact: acceleration g (sin - mu cos), normal force m g cos, friction mu of it."""
    acceleration, pressed, rubbed, slid, sunk = slide(face, slope, friction, support)
    down, across = math.sin(math.radians(slope)), math.cos(math.radians(slope))
    print(f"face {face}, support {support}: a/g {acceleration:.5f}, exact {down - friction * across:.5f}")
    assert acceleration == pytest.approx(down - friction * across, abs=2e-4)
    assert pressed == pytest.approx(across, abs=2e-4)
    assert rubbed == pytest.approx(friction * pressed, rel=1e-3, abs=1e-12)
    assert slid > 0.7
    assert abs(sunk) < 1e-3


@pytest.mark.parametrize("support", [0.0, 0.1])
@pytest.mark.parametrize("face", [90.0, 60.0, 30.0])
def test_block_sticks_to_a_face_that_is_rough_enough(face, support):
    """Exact: at rest, with friction m g sin below mu m g cos; it settles elastically by a thousandth of a cell."""
    acceleration, pressed, rubbed, slid, _ = slide(face, 30.0, 1.0, support)
    assert abs(acceleration) < 2e-4
    assert abs(slid) < 2e-3
    assert rubbed / pressed == pytest.approx(math.tan(math.radians(30)), rel=5e-3 if support else 5e-4)


def push(rake, friction):
    """Impulses of a wedge at 5 m/s on an elastic strip, in intervals in which it touches."""
    angle = math.radians(rake)
    strip = Bodies(
        rectangle(-12, -0.2, 0.3, 4.3, CELL),
        cell=CELL,
        room=12,
        support=0.1,
        wedge=Wedge(angle, math.radians(5), friction, 5.0, AT_ONCE, 0.0),
        tip=max(0.0, -math.tan(angle)) * 5 * CELL,
    )
    impulses = []
    for _ in range(20):
        strip.run(10)
        impulses.append(strip.state.totals[[step.CHIP_X, step.CHIP_Y]].copy())
    changes = np.diff(impulses, axis=0, prepend=0.0)
    return changes[abs(changes[:, 0]) > 1e-6 * abs(changes[:, 0]).max()].T


@pytest.mark.parametrize("rake", [-15.0, 0.0, 15.0, 30.0, 45.0])
def test_smooth_wedge_pushes_along_its_normal(rake):
    """Exact: Fc = N cos a, Ft = -N sin a in every interval, to round-off."""
    x, y = push(rake, 0.0)
    assert x.size > 3
    np.testing.assert_allclose(y, -math.tan(math.radians(rake)) * x, rtol=1e-12, atol=1e-12 * abs(x).max())


@pytest.mark.parametrize(("rake", "friction"), [(30.0, 0.1), (45.0, 0.1), (45.0, 0.3)])
def test_chip_that_slips_loads_a_rough_wedge_in_the_ratio_of_eq_12(rake, friction):
    """Exact: Ft/Fc = Z = (mu - tan a)/(1 + mu tan a) while all nodes slip, to round-off."""
    x, y = push(rake, friction)
    tangent = math.tan(math.radians(rake))
    np.testing.assert_allclose(y / x, (friction - tangent) / (1 + friction * tangent), rtol=1e-11)
