"""Packings reach their pressure, fill their vessel, repeat."""

import numpy as np
import pytest

from orthocut.dem.packing import EQUILIBRIUM, TOLERANCE, PackingError, pack
from orthocut.dem.pairs import close_pairs
from orthocut.params.case import load


def packing(**values):
    return load("dem_tension", {f"packing.{name}": value for name, value in values.items()}).packing


SMALL = {"width": "0.3 mm", "height": "0.4 mm"}


@pytest.mark.parametrize("pressure", [0.002, 0.03])
def test_packing_reaches_its_pressure_in_equilibrium(pressure):
    packed = pack(packing(**SMALL, pressure_ratio=pressure))
    assert abs(packed.pressure_ratio / pressure - 1) <= TOLERANCE
    assert packed.unbalanced_ratio <= 1.01 * EQUILIBRIUM


def test_pressure_agrees_with_the_push_on_the_walls():
    case = packing(**SMALL)
    packed = pack(case)
    ends = {"x": (packed.x, case.width, case.height), "y": (packed.y, case.height, case.width)}
    ratios = []
    for place, length, breadth in ends.values():
        for gap in (place, length - place):
            ratios.append(2 * np.clip(packed.radius - gap, 0, None).sum() / breadth)
    assert np.mean(ratios) == pytest.approx(packed.pressure_ratio, rel=0.02)


def test_denser_packing_has_more_contacts():
    loose, dense = (pack(packing(**SMALL, pressure_ratio=p)) for p in (0.002, 0.03))
    assert loose.porosity > dense.porosity
    assert loose.coordination < dense.coordination


def test_same_seed_same_bits_other_seed_other_discs():
    first, again, other = (pack(packing(**SMALL, seed=seed)) for seed in (1, 1, 2))
    assert all(a.tobytes() == b.tobytes() for a, b in zip(first[:3], again[:3], strict=True))
    assert not np.array_equal(first.x[:50], other.x[:50])


def test_discs_lie_in_the_vessel_with_the_stated_spread_of_radii():
    case = packing(**SMALL)
    packed = pack(case)
    assert packed.x.min() > 0
    assert packed.x.max() < case.width
    assert packed.y.max() < case.height
    assert packed.radius.max() / packed.radius.min() == pytest.approx(case.radius_ratio, rel=0.02)
    assert packed.radius.min() == pytest.approx(case.radius_min, rel=0.03)


def test_description_counts_contacts():
    packed = pack(packing(**SMALL))
    pairs = close_pairs(packed.x, packed.y, packed.radius)
    assert packed.coordination == pytest.approx(2 * len(pairs) / len(packed.x))


def test_vessel_too_small_for_two_discs_is_refused():
    with pytest.raises(PackingError, match="fewer than two discs"):
        pack(packing().model_copy(update={"width": 10e-6, "height": 10e-6}))
