"""Contact with the wedge: directions of forces, stick and slip, and who is in contact."""

import math

import numpy as np
import pytest

from orthocut.kernels.mpm import contact, layout
from orthocut.kernels.mpm.frame import Frame, Wedge
from orthocut.mpm.setup import fill_blocks

CELL = 1e-4
FRAME = Frame(-5 * CELL, -5 * CELL, CELL, 1 / CELL, 15, 15, -1, 1e-12, 0.0, 1e-8, 0.0)
NODES = FRAME.count_x * FRAME.count_y


def wedge(rake=30.0, friction=0.0):
    return Wedge(math.radians(rake), math.radians(5.0), friction, 5.0, 1.0, 0.0)


def node(velocity=(0.0, 0.0), mass=1e-5):
    grid = np.zeros(NODES * layout.NODE)
    grid[layout.NM] = mass
    grid[layout.NVX], grid[layout.NVY] = velocity
    grid[layout.NPX], grid[layout.NPY] = mass * velocity[0], mass * velocity[1]
    return grid


def kinetic(grid):
    return 0.5 * grid[layout.NM] * (grid[layout.NVX] ** 2 + grid[layout.NVY] ** 2)


def push(grid, body=layout.CHIP, **options):
    return contact.push_with_tool(grid, np.zeros(1, dtype=np.int64), 1, body, wedge(**options), 5.0, FRAME)


@pytest.mark.parametrize("rake", [-15.0, 0.0, 30.0, 60.0])
def test_frictionless_chip_force_is_normal_to_the_rake_face(rake):
    """Fc = N cos a and Ft = -N sin a, on the tool."""
    grid = node()
    impulse_x, impulse_y, *_ = push(grid, rake=rake)
    assert -impulse_y == pytest.approx(impulse_x * math.tan(math.radians(rake)), abs=1e-12 * abs(impulse_x))
    assert impulse_x < 0.0
    normal = np.array([math.cos(math.radians(rake)), -math.sin(math.radians(rake))])
    velocity = np.array([grid[layout.NVX], grid[layout.NVY]])
    assert (velocity - np.array([-5.0, 0.0])) @ normal == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("friction", [0.1, 0.3])
def test_slipping_chip_force_has_the_ratio_of_eq_12(friction):
    """Ft = Z Fc with Z = (mu - tan a)/(1 + mu tan a), Nairn (2015), eq (12), without rubbing."""
    impulse_x, impulse_y, *_ = push(node(), friction=friction)
    tangent = math.tan(math.radians(30))
    assert impulse_y / impulse_x == pytest.approx((friction - tangent) / (1 + friction * tangent), rel=1e-12)


def test_strong_friction_sticks():
    grid = node()
    push(grid, friction=1.5)
    assert grid[layout.NVX] == pytest.approx(-5.0)
    assert grid[layout.NVY] == pytest.approx(0.0, abs=1e-12)


def test_base_is_pushed_straight_down_and_only_when_it_rises():
    impulse_x, impulse_y, *_ = push(node((0.0, 2.0)), body=layout.BASE)
    assert impulse_x == 0.0
    assert impulse_y == pytest.approx(-2e-5)
    assert push(node((0.0, -2.0)), body=layout.BASE) == (0.0, 0.0, 0.0, 0.0)


def test_separating_chip_is_left_alone():
    assert push(node((-9.0, 0.0))) == (0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize("friction", [0.0, 0.2, 1.5])
def test_work_of_the_tool_is_kinetic_energy_plus_losses(friction):
    """From a node that feels no other force, so that the impulse acts at the mean velocity of the step."""
    grid = node((1.0, 0.5))
    before = kinetic(grid)
    impulse_x, _, impact, slip = push(grid, friction=friction)
    change = kinetic(grid) - before
    assert -impulse_x * 5.0 == pytest.approx(change + impact + slip, rel=1e-12)
    assert impact > 0.0
    assert slip > 0.0 if friction else abs(slip) < 1e-15 * impact


def touches(body, x, y, tip=0.0, rake=30.0, stretch=1.0):
    """Whether a single point is found in contact."""
    points = fill_blocks(np.array([x]), np.array([y]), 1e-5).ravel()
    points[layout.FXX * layout.LANES] = stretch
    near = np.zeros(layout.LANES, dtype=np.int64)
    count = contact.list_near_points(near, points, np.array([0, 1]), body, wedge(rake), tip, 2 * CELL)
    listed, marked = np.zeros(NODES, dtype=np.int64), np.zeros(NODES, dtype=np.int64)
    found = contact.mark_contact_nodes(marked, listed, points, near, count, body, wedge(rake), tip, FRAME)
    assert not listed.any()
    return found > 0


def test_point_touches_when_its_deformed_domain_reaches_the_face():
    half = CELL / 4
    c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
    extent = half * (c + s)
    for distance, expected in ((0.99 * extent, True), (1.01 * extent, False)):
        x, y = 2 * CELL * s - distance * c, 2 * CELL * c + distance * s
        assert touches(layout.CHIP, x, y) is expected
    stretched = 1.2 * extent
    x, y = 2 * CELL * s - stretched * c, 2 * CELL * c + stretched * s
    assert not touches(layout.CHIP, x, y)
    assert touches(layout.CHIP, x, y, stretch=2.0)


def test_point_below_the_tip_does_not_touch_the_rake_face():
    assert not touches(layout.CHIP, 0.0, -CELL)


def test_base_touches_the_clearance_face_behind_the_tip_only():
    half, c, s = CELL / 4, math.cos(math.radians(5)), math.sin(math.radians(5))
    edge = (CELL * s - half * (c + s)) / c
    assert touches(layout.BASE, CELL, edge + 0.02 * half)
    assert not touches(layout.BASE, CELL, edge - 0.02 * half)
    assert not touches(layout.BASE, -CELL, 0.0)
