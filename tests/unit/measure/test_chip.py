"""Shape of a chip from deformation gradients."""

import math

import numpy as np
import pytest

from orthocut.measure.chip import shape

DEPTH, TIP = 1e-3, 5e-3


def chip(gradient, rake=30.0, count=50):
    places = TIP + np.linspace(1.1, 2.9, count) * DEPTH
    return shape(places, np.tile(gradient, (count, 1)), TIP, DEPTH, math.radians(rake))


@pytest.mark.parametrize("angle", [45.0, 60.0])
def test_shear_plane_gives_its_own_angle_and_thickness(angle):
    """Simple shear by cot(phi) + tan(phi - alpha) along a plane at phi; lines along the cut become cos/sin shorter."""
    phi, alpha = math.radians(angle), math.radians(30.0)
    gamma = 1 / math.tan(phi) + math.tan(phi - alpha)
    along, across = np.array([-math.cos(phi), math.sin(phi)]), np.array([math.sin(phi), math.cos(phi)])
    gradient = np.eye(2) + gamma * np.outer(along, across)
    found = chip(gradient.ravel())
    assert found.angle_shear == pytest.approx(phi, rel=1e-9)
    assert found.thickness_ratio == pytest.approx(math.cos(phi - alpha) / math.sin(phi), rel=1e-9)


def test_undeformed_chip_has_the_depth_of_cut_and_no_shear():
    found = chip([1.0, 0.0, 0.0, 1.0])
    assert found.thickness_ratio == 1.0
    assert found.shear_largest == 0.0


def test_simple_shear_is_found():
    assert chip([1.0, 0.8, 0.0, 1.0]).shear_largest == pytest.approx(0.8)


def test_no_chip_no_numbers():
    found = shape(np.array([0.0]), np.array([[1.0, 0.0, 0.0, 1.0]]), TIP, DEPTH, 0.5)
    assert all(map(math.isnan, found))
