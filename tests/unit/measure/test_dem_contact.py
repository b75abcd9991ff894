"""Contact of a tool and mean forces of constructed histories."""

import numpy as np
import pytest

from orthocut.measure.dem_contact import reduce, touching


def test_the_tool_is_in_the_air_where_the_resultant_vanishes():
    cutting, thrust = np.array([0.0, 10.0, 0.0, 0.05]), np.array([0.0, 0.0, -10.0, 0.0])
    assert list(touching(cutting, thrust)) == [False, True, True, False]
    assert not touching(np.zeros(5), np.zeros(5)).any()


def test_means_over_the_travel_and_in_contact():
    force = np.where(np.arange(500) % 5 == 0, 10.0, 0.0)
    found = reduce(force, force > 0, 0.8, 0.1)
    assert found.mean == pytest.approx(2.0)
    assert found.contact == pytest.approx(10.0)
    assert found.rms == pytest.approx(np.sqrt(20.0))
    assert found.error == pytest.approx(0.0, abs=0.05)
    assert np.isnan(reduce(force, force < 0, 0.8, 0.1).contact)


@pytest.mark.parametrize(("depth", "blocks"), [(0.1, 8), (0.2, 4), (0.01, 10), (0.8, 4)])
def test_error_comes_from_blocks_of_a_depth_of_cut(depth, blocks):
    force = np.random.default_rng(1).exponential(1.0, 480)
    means = np.array([part.mean() for part in np.array_split(force, blocks)])
    found = reduce(force, force > 0, 0.8, depth)
    assert found.error == pytest.approx(means.std(ddof=1) / np.sqrt(blocks))
