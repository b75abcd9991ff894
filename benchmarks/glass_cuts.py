"""Cuts of glass that tell what the speed of the tool adds to the mean forces: those of the paper, and new ones.

The cuts of the paper are run at the speeds at which no study has many of their packings; the others, drawn from a box
(Sobol), test what presets and tolerances promise.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from scipy.stats import qmc

from orthocut.params.case import Case, override, validate
from orthocut.params.study import load_study

STUDY = Path(__file__).parents[1] / "workflow" / "config" / "yang2018.yaml"
SEED = 2018
"""Seed of the sequence that new cuts are drawn from."""
NEW = 2
LOW, HIGH = (0.1, -30.0, 0.1), (0.2, 0.0, 0.5)
"""Depth of cut [mm], rake angle [degree], friction of the tool."""
PAPER = {
    "0.1 mm regular": "regular_shallow",
    "0.1 mm grooved": "grooved_shallow",
    "0.2 mm regular": "regular_deep",
    "0.2 mm grooved": "grooved_deep",
}
"""Cut to the sweep that holds it at 1 m/s."""
PACKINGS = {
    "0.1 mm regular": {2.0: 32},
    "0.1 mm grooved": {2.0: 24, 0.2: 16},
    "0.2 mm regular": {2.0: 24, 0.2: 12, 0.05: 3},
    "0.2 mm grooved": {2.0: 24, 0.2: 12, 0.05: 3},
}
"""Cut to speed of the tool [m/s] to the number of packings that are run here, beside those of the study."""
PACKINGS_NEW = {2.0: 8, 1.0: 8, 0.2: 10}


class GlassCut(NamedTuple):
    """A run that is wanted."""

    cut: str
    speed: float
    """Speed of the tool [m/s]."""
    seed: int
    """Seed of the packing."""

    def case(self) -> Case:
        """Case of the run."""
        base = _bases()[self.cut]
        return validate(override(base, {"cut_speed": f"{self.speed} m/s", "packing.seed": self.seed}, self.cut))


@cache
def _bases() -> dict[str, dict[str, Any]]:
    """Cut to the raw fields of its case."""
    sweeps = load_study(STUDY).sweeps
    found = {cut: sweeps[name].base for cut, name in PAPER.items()}
    points = qmc.scale(qmc.Sobol(len(LOW), rng=SEED).random(NEW), LOW, HIGH)
    for number, (depth, rake, friction) in enumerate(points):
        plain = sweeps[list(PAPER.values())[number % 2]].base
        depth, rake, friction = f"{depth:.3g} mm", f"{rake:.3g} deg", round(float(friction), 2)
        fields = {"cut_depth": depth, "rake_angle": rake, "tool.friction": friction}
        words = f"{depth} {'grooved' if number % 2 else 'regular'}, rake {rake}, friction {friction}"
        found[words] = override(plain, fields, "new cut")
    return found


def new_cuts() -> list[str]:
    """Names of the cuts that no study holds."""
    return [cut for cut in _bases() if cut not in PAPER]


def wanted() -> Iterator[GlassCut]:
    """All runs, the first packings of all cuts first."""
    counts = PACKINGS | dict.fromkeys(new_cuts(), PACKINGS_NEW)
    runs = [
        GlassCut(cut, speed, seed)
        for cut, speeds in counts.items()
        for speed, count in speeds.items()
        for seed in range(1, count + 1)
    ]
    yield from sorted(runs, key=lambda run: (run.seed, run.speed))
