"""What presets promise against published cuts: those that made the promises, and those that were held out."""

from pathlib import Path

import pytest

from orthocut.figures import nairn2015_accuracy
from orthocut.io.netcdf import read
from orthocut.params.accuracy import evidence

PUBLISHED = Path(__file__).parents[3] / "results" / "published" / "nairn2015" / "accuracy.nc"


@pytest.fixture(scope="module")
def families():
    return nairn2015_accuracy.families_of(read(PUBLISHED))


def test_the_evidence_is_what_the_cuts_say(families):
    evident = [family for family in families if not family.held_out]
    for row, (count, bound, typical) in zip(evidence()["bias"], nairn2015_accuracy.quantiles(evident), strict=True):
        print(f"up to {row['depth_over_zone']}: {count} families, 9 of 10 {bound:.2f}, every other one {typical:.2f}")
        assert count > 30
        assert row["bound"] == pytest.approx(bound, rel=0.03)
        assert row["typical"] == pytest.approx(typical, rel=0.03)


def test_cuts_that_were_held_out_keep_the_promise(families):
    trials = nairn2015_accuracy.trials_of(families)
    kept = sum(trial.error <= trial.bound for trial in trials)
    print(f"{kept} of {len(trials)} runs keep the promise")
    assert len(trials) > 35
    assert kept >= 0.9 * len(trials)
