"""Table of the toughness: means over packings and lengths of the crack, energy release with the modulus in tension."""

import pytest
from synthetic import dem_test_run

from orthocut.figures.yang2018_toughness import GLASS, tabulate
from orthocut.io.collect import collect


def test_toughness_and_energy_release_are_those_of_the_same_discs():
    cracked = [
        dem_test_run("dem_toughness", crack_ratio=ratio, **{"packing.radius_min": size, "packing.seed": seed})
        for size in ("10 um", "20 um")
        for ratio in (0.3, 0.5)
        for seed in (1, 2)
    ]
    table = tabulate(collect([*cracked, dem_test_run("dem_tension")]))
    assert [(row[1], row[2], row[3]) for row in table.rows] == [
        (size, ratio, count) for size in (10.0, 20.0) for ratio, count in ((0.3, 2), (0.5, 2), ("all", 4))
    ]
    mean = 0.45 * 1.03
    assert [row[4] for row in table.rows] == pytest.approx([mean] * 6)
    assert table.rows[0][6] == pytest.approx(mean / GLASS)
    assert table.rows[-1][7] == pytest.approx(1e6 * 1e6 * mean**2 / 71e9)
    assert table.rows[0][7] != table.rows[0][7]  # no modulus is known for discs of this size
