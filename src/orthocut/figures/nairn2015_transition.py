"""Depth of cut at which the tool loses the crack tip, over particle size, for several ways to compute the same cut."""

from __future__ import annotations

from collections import defaultdict

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import cases, nothing, page, styled
from orthocut.figures.extrapolation import extrapolate
from orthocut.figures.holes import failed, mark
from orthocut.figures.palette import SERIES
from orthocut.figures.regimes import Transition, transition
from orthocut.figures.sweep import cut_depth, group_name, group_of, touches
from orthocut.figures.symbols import draw_limit
from orthocut.figures.tables import Table, plain
from orthocut.figures.varied import words
from orthocut.io.collect import case_of

CAPTION = (
    "Depth of cut between the deepest run that touches the crack tip and the shallowest that bends, over particle "
    "size. Bars: from the one to the other; arrows: one regime only, the transition lies beyond. Dashed: straight fit "
    "through three sizes or more, each known to its interval over the square root of twelve; diamond: its end at size "
    "zero, with standard error. Dotted: the paper, 2.0-2.1 mm at a rake angle of 30° with 15 points through the chip, "
    "perfectly plastic and without friction. Symbols of one size that differ in contact rule, time step, place of the "
    "grid or loop stand side by side. Crosses on the axis: failed runs."
)
DIMS = ()
PAPER = 2.05e-3
"""Middle of the paper's interval at a rake angle of 30 degrees, perfectly plastic, without friction [m]."""

METHODS = ("affine", "scheme", "contact", "courant", "grid_offset")
"""Fields in which series of the same cut may differ."""
ASIDE = 0.02
"""Distance of the symbols of neighbouring series over the particle size."""

Key = tuple


def transitions(dataset: xr.Dataset) -> dict[Key, dict[int, Transition]]:
    """Transition of each series and scheme with two depths or more, by points through the depth of cut."""
    found: dict[Key, dict[int, list[xr.Dataset]]] = defaultdict(lambda: defaultdict(list))
    for run in cases(dataset, "touching", kind="mpm_cutting"):
        numerics = case_of(run).numerics
        method = tuple(getattr(numerics, name) for name in METHODS)
        found[group_of(run), method][numerics.points_per_depth].append(run)
    return {
        key: {
            points: transition([(cut_depth(run), touches(run)) for run in runs])
            for points, runs in sorted(sizes.items())
            if len(runs) > 1
        }
        for key, sizes in sorted(found.items())
        if any(len(runs) > 1 for runs in sizes.values())
    }


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One colour a series."""
    figure = page(3.4)
    ax = figure.subplots()
    ax.set_xlabel("particle size over depth of cut $1/n$ [-]")
    ax.set_ylabel("depth of cut at the transition [mm]")
    mark(ax, [1.0 / case_of(run).numerics.points_per_depth for run in failed(dataset, "mpm_cutting")])
    found = transitions(dataset)
    if not found:
        nothing(ax)
        return figure
    for number, (colour, (key, sizes)) in enumerate(zip(SERIES * 9, found.items(), strict=False)):
        for points, change in sizes.items():
            place = (1 + ASIDE * (number - 0.5 * (len(found) - 1))) / points
            if change.found:
                ax.errorbar(
                    place, 1e3 * change.middle, 1e3 * change.half_width, fmt="o", color=colour, capsize=2, zorder=3
                )
            elif change.low:
                ax.plot(place, 1e3 * change.low, "^", mfc="white", color=colour)
            else:
                ax.plot(place, 1e3 * change.high, "v", color=colour)
        known = {1 / points: change for points, change in sizes.items() if change.found}
        if len(known) > 2:
            fit = extrapolate(
                list(known),
                [1e3 * one.middle for one in known.values()],
                [1e3 * one.standard_error for one in known.values()],
            )
            ends = [0.0, max(known)]
            ax.plot(ends, fit.at(ends), "--", color=colour, lw=0.8)
            draw_limit(ax, fit.limit, fit.error, colour)
        ax.plot([], [], "o", color=colour, label=_name(key, found))
    ax.axhline(1e3 * PAPER, color="0.4", ls=":", lw=0.9, label="Nairn (2015), 30°")
    ax.set_xlim(left=min(ax.get_xlim()[0], 0))
    ax.set_ylim(bottom=0)
    figure.legend(handles=ax.get_legend_handles_labels()[0], loc="outside upper center", fontsize="x-small")
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Both ends of each interval."""
    header = ["series", "points through the chip", "deepest touching [mm]", "shallowest bending [mm]"]
    header += ["runs of the other regime"]
    found = transitions(dataset)
    rows = [
        [plain(_name(key, found)), points, 1e3 * change.low or float("nan"), 1e3 * change.high, change.strays]
        for key, sizes in found.items()
        for points, change in sizes.items()
    ]
    return Table("Transition from touching to bending", header, rows)


def _name(key: Key, found: dict[Key, dict[int, Transition]]) -> str:
    """What tells a series from the others; methods from that of the series with the most sizes."""
    group, method = key
    _, usual = max(found, key=lambda other: len(found[other]))
    name = group_name(group, {other: [] for other, _ in found})
    said = [words(field, value) for field, value, other in zip(METHODS, method, usual, strict=True) if value != other]
    return ", ".join([name, *filter(None, said)])
