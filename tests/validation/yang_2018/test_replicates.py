"""What a share of replicates asks for against published cuts: the scatter, and means of as many packings."""

from pathlib import Path

import numpy as np
import pytest

from orthocut.figures.yang2018_finding import glass_of
from orthocut.io.netcdf import read
from orthocut.params.accuracy_glass import row_of
from orthocut.params.replicates import packings

PUBLISHED = Path(__file__).parents[3] / "results" / "published" / "yang2018" / "table4.nc"
SPEED = 1.0
"""Speed of the tool in the published cuts [m/s]."""


@pytest.fixture(scope="module")
def forces():
    """Main forces of the packings of each of the four cuts [N/mm]."""
    cuts = glass_of(read(PUBLISHED)).conditions
    return [np.array([run["force_cutting_mean"] for run in runs]) for runs in cuts.values()]


def test_the_scatter_is_that_of_the_cut_that_scatters_most(forces):
    scatter = [float(np.std(some, ddof=1) / np.mean(some)) for some in forces]
    print([f"{one:.3f}" for one in scatter])
    assert len(scatter) == 4
    assert max(scatter) == pytest.approx(row_of(SPEED)["scatter"], rel=0.03)


@pytest.mark.parametrize("share", [0.3, 0.2])
def test_means_of_as_many_packings_keep_to_the_share(forces, share):
    """Nineteen of twenty draws from the published packings, with replacement, are within the share of the mean."""
    random, count = np.random.default_rng(1), packings(share, SPEED)
    for some in forces:
        means = random.choice(some, size=(4000, count)).mean(axis=1)
        kept = float(np.mean(np.abs(means / some.mean() - 1) <= share))
        print(f"{count} packings: {kept:.1%} keep to {share:.0%}")
        assert kept > 0.95
