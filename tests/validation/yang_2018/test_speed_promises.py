"""What presets promise of cuts of glass against published cuts: those that made the promises, and two others."""

import numpy as np
import pytest
from glass_speed import SLOW, cuts, kept, slower

from orthocut.figures.yang2018_paper import FORCES
from orthocut.params import accuracy_glass
from orthocut.params.accuracy import evidence
from orthocut.params.quantity import convert

LEAST = 8
"""Fewest packings that tell their scatter."""


@pytest.fixture(scope="module")
def main_forces():
    return [cut for cut in cuts() if cut.force == FORCES[0]]


def test_the_evidence_is_what_the_cuts_say(main_forces):
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
        if speed > SLOW:
            assert row["bound"] == pytest.approx(max(added), rel=0.05)
            assert row["typical"] == pytest.approx(np.median(added), rel=0.05)


def test_slower_cuts_are_within_what_is_left_open(main_forces):
    count, ratio, error = slower(main_forces)
    print(f"{count} cuts: {ratio:.2f} +- {error:.2f}")
    row = accuracy_glass.row_of(SLOW)
    assert count >= LEAST
    assert abs(1 / ratio - 1) < row["typical"]
    assert 1.96 * error < row["bound"]


@pytest.mark.parametrize(
    "choice", [("2 m/s", 1), ("2 m/s", 4), ("1 m/s", 2), ("1 m/s", 8), ("0.2 m/s", 1), ("0.2 m/s", 3)]
)
def test_cuts_that_no_study_holds_keep_the_promises(main_forces, choice):
    """Nine of ten means of so many of their packings do."""
    new = [cut for cut in main_forces if cut.is_new]
    assert len(new) == 2
    for cut in new:
        bound, share = kept(cut, accuracy_glass.Choice(*choice))
        print(f"{cut.name}: {share:.1%} within {bound:.0%}")
        assert share > 0.9
