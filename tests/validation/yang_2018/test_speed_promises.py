"""What presets promise of cuts of glass against published cuts: those that made the promises, and two others."""

import importlib
from pathlib import Path

import numpy as np
import pytest

from orthocut.figures.yang2018_paper import FORCES
from orthocut.params import accuracy_glass
from orthocut.params.accuracy import evidence
from orthocut.params.quantity import convert

BENCHMARKS = Path(__file__).parents[3] / "benchmarks"
LEAST = 8
"""Fewest packings that tell their scatter."""


@pytest.fixture(scope="module")
def glass_speed():
    """The benchmark that made the evidence."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(BENCHMARKS)
        return importlib.import_module("glass_speed")


@pytest.fixture(scope="module")
def main_forces(glass_speed):
    return [cut for cut in glass_speed.cuts() if cut.force == FORCES[0]]


def test_the_evidence_is_what_the_cuts_say(glass_speed, main_forces):
    evident = [cut for cut in main_forces if not cut.is_new]
    assert len(evident) == 4
    for row in evidence()["glass"]["speed"]:
        speed = convert(row["cut_speed"], "m/s")
        means = [cut.means[speed] for cut in evident]
        assert min(mean.count for mean in means) >= LEAST
        scatter = max(mean.spread / mean.mean for mean in means)
        added = [cut.added(speed)[0] for cut in evident]
        print(f"{speed:g} m/s: added {np.round(added, 2)}, scatter {scatter:.2f}")
        assert row["scatter"] == pytest.approx(scatter, rel=0.05)
        if speed > glass_speed.SLOW:
            assert row["bound"] == pytest.approx(max(added), rel=0.05)
            assert row["typical"] == pytest.approx(np.median(added), rel=0.05)


def test_slower_cuts_are_within_what_is_left_open(glass_speed, main_forces):
    count, ratio, error = glass_speed.slower(main_forces)
    print(f"{count} cuts: {ratio:.2f} +- {error:.2f}")
    row = accuracy_glass.row_of(glass_speed.SLOW)
    assert count >= LEAST
    assert abs(1 / ratio - 1) < row["typical"]
    assert 1.96 * error < row["bound"]


@pytest.mark.parametrize(
    "choice", [("2 m/s", 1), ("2 m/s", 4), ("1 m/s", 2), ("1 m/s", 8), ("0.2 m/s", 1), ("0.2 m/s", 3)]
)
def test_cuts_that_no_study_holds_keep_the_promises(glass_speed, main_forces, choice):
    """Nine of ten means of so many of their packings do."""
    new = [cut for cut in main_forces if cut.is_new]
    assert len(new) == 2
    for cut in new:
        bound, share = glass_speed.kept(cut, accuracy_glass.Choice(*choice))
        print(f"{cut.name}: {share:.1%} within {bound:.0%}")
        assert share > 0.9
