"""What is awake around the tool, and the nodes held at the seams."""

import math

import numpy as np
import pytest

from orthocut.kernels.mpm import layout
from orthocut.kernels.mpm.frame import Frame
from orthocut.kernels.mpm.rest import AWAKE, BEHIND, PAIRS, rest_behind, wake_ahead
from orthocut.kernels.mpm.shape import nearest_node
from orthocut.mpm.setup import fill_blocks

COLUMNS = 200
FRAME = Frame(-1.0, 0.0, 1.0, 1.0, COLUMNS + 3, 8, -1, 0.0, 0.0, 0.1, 1.0)
LAST = FRAME.count_x - 1


class Strip:
    """Two bodies of four points a unit of length, 16 units a block; the tool comes from the right."""

    def __init__(self, reach):
        x = np.repeat(np.arange(COLUMNS) + 0.5, 4)
        body = fill_blocks(x, np.full(x.size, 3.0), 1.0)
        body[:, layout.VX] = 7.0
        count = body.shape[0]
        self.points = np.concatenate([body, body]).ravel()
        self.blocks = np.array([[0, count], [count, 2 * count]])
        self.pairs = np.arange(COLUMNS) + 0.5
        self.awake = np.array([[count, count], [2 * count, 2 * count], [COLUMNS, COLUMNS]])
        self.free = np.tile([0, LAST, 0, FRAME.count_y - 1], (2, 1))
        self.frame = FRAME._replace(reach=reach)
        assert self.awake.shape[0] == AWAKE

    def follow(self, tip):
        wake_ahead(self.points, self.blocks, self.awake, tip, self.frame)
        rest_behind(self.points, self.blocks, self.pairs, self.awake, self.free, tip, self.frame)

    def fields(self, body, asleep):
        """Fields of the points of a body that are asleep or awake, shape (n_blocks, POINT_FIELDS, LANES)."""
        blocks = self.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)
        chosen = np.zeros(blocks.shape[0], dtype=bool)
        chosen[slice(*self.awake[body])] = True
        inside = np.zeros_like(chosen)
        inside[slice(*self.blocks[body])] = True
        return blocks[inside & (chosen != asleep)]


def test_all_material_is_awake_without_a_reach():
    strip = Strip(math.inf)
    strip.follow(190.0)
    np.testing.assert_array_equal(strip.awake[:2], strip.blocks)
    assert strip.awake[PAIRS].tolist() == [0, COLUMNS]
    np.testing.assert_array_equal(strip.free[:, :2], [[0, LAST], [0, LAST]])


@pytest.mark.parametrize("tip", [199.0, 150.0, 101.3, 60.0, 3.0])
def test_material_within_reach_is_awake_and_no_free_node_serves_a_sleeping_point(tip):
    reach = 40.0
    strip = Strip(reach)
    for place in np.arange(COLUMNS, tip - 1.0, -1.0):
        strip.follow(max(place, tip))
    for body in (layout.CHIP, layout.BASE):
        sleeping = strip.fields(body, asleep=True)
        x = sleeping[:, layout.X][sleeping[:, layout.MASS] > 0]
        behind = BEHIND * reach if body == layout.BASE else math.inf
        assert not ((x > tip - reach) & (x < tip + behind)).any()
        for place in x:
            node = nearest_node((place - FRAME.origin_x) * FRAME.inv_cell, FRAME.count_x)
            assert node + 1 < strip.free[body, 0] or node - 1 > strip.free[body, 1]
    assert strip.free[layout.CHIP, 0] == strip.free[layout.BASE, 0]
    assert strip.free[layout.CHIP, 1] == LAST
    first = strip.awake[PAIRS, 0]
    if first:
        assert strip.pairs[first - 1] + 1.0 < strip.free[layout.CHIP, 0] + FRAME.origin_x


def test_points_go_to_sleep_at_rest_and_others_keep_their_velocity():
    strip = Strip(20.0)
    for tip in np.arange(190.0, 80.0, -1.0):
        strip.follow(tip)
    behind = strip.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)[strip.awake[layout.BASE, 1] :]
    assert behind.size
    assert (behind[:, [layout.VX, layout.VY]] == 0.0).all()
    assert (strip.fields(layout.BASE, asleep=False)[:, layout.VX] == 7.0).all()
    assert strip.awake[layout.CHIP, 1] == strip.blocks[layout.CHIP, 1]
