"""What the speed of the tool adds to the mean forces of cuts of glass: means over packings, beside those of slow cuts.

Runs are those of `glass_runs.py` and those of the study of Yang et al. (2018) that differ in speed and packing alone.
"""

from __future__ import annotations

import argparse
import csv
import math
from collections import defaultdict
from pathlib import Path
from typing import NamedTuple

import numpy as np
from glass_cuts import PAPER, GlassCut
from glass_runs import read_rows
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from orthocut.figures.canvas import PAGE, page, styled
from orthocut.figures.confidence import Interval, interval
from orthocut.figures.palette import AMBER, BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY
from orthocut.figures.save import save
from orthocut.figures.yang2018_paper import FORCES, NAMES
from orthocut.figures.yang2018_runs import cuts_of
from orthocut.io.netcdf import read
from orthocut.params.accuracy import evidence
from orthocut.params.accuracy_glass import Choice, promise
from orthocut.params.quantity import convert

PUBLISHED = Path(__file__).parents[1] / "results" / "published"
RUNS = PUBLISHED / "benchmarks" / "glass_runs.csv"
TOLD = 3
"""Fewest packings whose interval is drawn: that of two would fill the picture."""
SLOW = 0.2
"""Speed up to which a cut counts as slow [m/s]: slower ones differ from it by less than they scatter."""
HEADER = ["cut", "force", "tool [m/s]", "packings", "mean [N/mm]", "95 % half-width [N/mm]"]
HEADER += ["standard deviation over mean [-]", "mean of slow cuts [N/mm]", "its 95 % half-width [N/mm]"]
HEADER += ["added by the speed [%]", "its 95 % half-width [%]"]
COLOURS = (GREEN, SKY, PURPLE, AMBER, BLUE, ORANGE)
MARKERS = "os^DvP"


class Cut(NamedTuple):
    """One force of a cut at several speeds."""

    name: str
    force: str
    values: dict[float, np.ndarray]
    """Speed of the tool [m/s] to the mean force of each packing [N/mm]."""

    @property
    def is_new(self) -> bool:
        """Whether no study holds it: it tests promises."""
        return self.name not in PAPER

    @property
    def means(self) -> dict[float, Interval]:
        """Speed of the tool [m/s] to the mean over packings [N/mm]."""
        return {speed: interval(values) for speed, values in sorted(self.values.items())}

    @property
    def slow(self) -> Interval:
        """Mean over all slow packings [N/mm]."""
        return interval(np.concatenate([values for speed, values in self.values.items() if speed <= SLOW]))

    def added(self, speed: float) -> tuple[float, float]:
        """What a speed adds to the force of slow cuts, over that force, and the half-width of its interval [-]."""
        mean, slow = self.means[speed], self.slow
        ratio = mean.mean / slow.mean
        return ratio - 1, ratio * math.hypot(mean.relative, slow.relative)


def cuts(runs: Path = RUNS, published: Path = PUBLISHED) -> list[Cut]:
    """Both forces of all cuts."""
    found: dict[tuple[str, str], dict[float, dict[int, float]]] = defaultdict(lambda: defaultdict(dict))
    for run in cuts_of(read(published / "yang2018" / "convergence.nc")):
        for cut in PAPER:
            if run.case == GlassCut(cut, run.case.cut_speed, run.seed).case():
                for name in FORCES:
                    found[cut, name][run.case.cut_speed][run.seed] = run[f"{name}_mean"]
    for (cut, speed, seed), row in read_rows(runs).items():
        for name, value in zip(FORCES, row[3:5], strict=True):
            if value:
                found[cut, name][speed][seed] = float(value)
    return [
        Cut(*key, {speed: np.array([one[seed] for seed in sorted(one)]) for speed, one in speeds.items()})
        for key, speeds in found.items()
    ]


def slower(found: list[Cut], name: str = FORCES[0]) -> tuple[int, float, float]:
    """Cuts slower than the fastest slow ones: their number, their mean force over that of these, its standard error.

    Cuts of several depths and surfaces count by their numbers; the error is that of the scatter of single cuts.
    """
    ratios, errors = [], []
    for cut in found:
        usual = cut.means.get(SLOW)
        for values in (values for speed, values in cut.values.items() if speed < SLOW and cut.force == name):
            ratios += list(values / usual.mean)
            errors += [usual.spread / usual.mean] * len(values)
    spread = math.hypot(*errors) / len(ratios)
    return len(ratios), float(np.mean(ratios)), spread


def main() -> None:
    """Write a table as CSV and draw it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=Path, default=RUNS, help="table of glass_runs.py")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/glass_speed.csv"))
    options = parser.parse_args()
    options.output.parent.mkdir(parents=True, exist_ok=True)
    found = cuts(options.runs)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for cut in found:
            for speed, mean in cut.means.items():
                slow, added = cut.slow, [100 * one for one in cut.added(speed)]
                numbers = [mean.mean, mean.half, mean.spread / mean.mean, slow.mean, slow.half, *added]
                row = [cut.name, NAMES[cut.force], f"{speed:g}", mean.count, *(f"{one:.4g}" for one in numbers)]
                writer.writerow(["" if one == "nan" else one for one in row])
    print(options.output.read_text(encoding="utf-8"))
    count, ratio, error = slower(found)
    print(f"{count} slower cuts have {ratio:.2f} +- {error:.2f} of the main force at {SLOW:g} m/s")
    save(draw(found), options.output.with_suffix(".png"))


@styled
def draw(found: list[Cut]) -> Figure:
    """Forces over speed, with 95 % intervals, and what the speed adds beside what is promised."""
    figure = page(3.2, PAGE)
    panels = figure.subplots(1, 3)
    for ax, name in zip(panels, (*FORCES, FORCES[0]), strict=True):
        some = [cut for cut in found if cut.force == name]
        for cut, colour, marker in zip(some, COLOURS, MARKERS, strict=True):
            style = {"color": colour, "marker": marker, "mfc": "white" if cut.is_new else colour, "lw": 0.8, "ms": 4}
            means = cut.means
            if ax is panels[2]:
                means = {speed: mean for speed, mean in means.items() if speed > SLOW}
                values, halves = 100 * np.array([cut.added(speed) for speed in means]).T
            else:
                values, halves = np.array([(mean.mean, mean.half) for mean in means.values()]).T
                halves[np.array([mean.count for mean in means.values()]) < TOLD] = np.nan
            ax.errorbar(list(means), values, halves, elinewidth=0.6, **style)
        ax.set_xlabel("speed of the tool [m/s]")
        ax.set_title(f"{NAMES[name]} force", loc="left")
        ax.set_xlim(0, 2.1)
    for ax, name in zip(panels, FORCES, strict=False):
        ax.set_ylim(0, 1.2 * max(mean.mean for cut in found if cut.force == name for mean in cut.means.values()))
        ax.set_ylabel("mean force [N/mm]")
    rows = evidence()["glass"]["speed"]
    edges = [0.0, *(convert(row["cut_speed"], "m/s") for row in rows)]
    for name, dash in (("bound", "-"), ("typical", "--")):
        steps = [100 * row[name] for row in rows]
        panels[2].stairs(steps, edges, baseline=None, color=BLACK, ls=dash, lw=0.8)
    panels[2].set_ylabel("added to that of slow cuts [%]")
    first = [cut for cut in found if cut.force == FORCES[0]]
    handles = [
        Line2D([], [], color=colour, marker=marker, mfc="white" if cut.is_new else colour, ls="", label=cut.name)
        for cut, colour, marker in zip(first, COLOURS, MARKERS, strict=True)
    ]
    handles += [
        Line2D([], [], color=BLACK, ls=dash, label=label)
        for dash, label in (("-", "left open for 9 of 10 cuts"), ("--", "for every other one"))
    ]
    figure.legend(handles=handles, loc="outside upper center", ncols=3)
    return figure


def kept(cut: Cut, choice: Choice, draws: int = 4000) -> tuple[float, float]:
    """Bound that a choice promises for a cut, and the share of means of as many packings that keep to it.

    Packings are drawn at random. Those of a slow tool are compared with the slow ones that were not drawn.
    """
    speed = convert(choice.cut_speed, "m/s")
    bound = promise(GlassCut(cut.name, speed, 1).case(), choice).bound
    random, values = np.random.default_rng(1), cut.values[speed]
    if speed > SLOW:
        means = random.choice(values, size=(draws, choice.packings)).mean(axis=1)
        errors = means / cut.slow.mean - 1
    else:
        mixed = random.permuted(np.tile(values, (draws, 1)), axis=1)
        errors = mixed[:, : choice.packings].mean(axis=1) / mixed[:, choice.packings :].mean(axis=1) - 1
    return bound, float(np.mean(np.abs(errors) <= bound))


if __name__ == "__main__":
    main()
