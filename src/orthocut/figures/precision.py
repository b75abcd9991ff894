"""Error against cost of runs of one scene, and which of them nothing beats: work-precision diagrams."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from typing import NamedTuple

from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from orthocut.figures.palette import BLACK, GREY

LEAST = 1e-4
"""Smallest relative error that a diagram shows."""
OPEN = "Ds^"
"""Markers that are drawn open."""


class Reference(NamedTuple):
    """What results of a scene are compared with."""

    value: float
    """In the unit of the results."""
    error: float
    """Its standard error; 0 for an exact solution."""

    @property
    def floor(self) -> float:
        """Relative error below which the reference tells nothing [-]."""
        return self.error / abs(self.value)


class Setting(NamedTuple):
    """A way to compute the result of a scene, what it cost and how far it was off."""

    knob: str
    """What is set, for the legend."""
    words: str
    """How it is set."""
    cost: float
    """Run time on one core [s]."""
    deviation: float
    """Result over reference less 1 [-]."""
    noise: float
    """Standard error of the result over the reference [-]."""

    @property
    def error(self) -> float:
        """Root of the squares of deviation and noise [-]: a result is no better than its own standard error."""
        return math.hypot(self.deviation, self.noise)


def setting(knob: str, words: str, cost: float, value: float, error: float, reference: Reference) -> Setting:
    """Setting from a result and its standard error, in the unit of the reference; an unknown error counts as none."""
    noise = error if math.isfinite(error) else 0.0
    return Setting(knob, words, cost, value / reference.value - 1, noise / abs(reference.value))


def front(settings: Sequence[Setting]) -> list[Setting]:
    """Settings than which no cheaper one has a smaller error, by cost."""
    best: list[Setting] = []
    for one in sorted(settings, key=lambda one: (one.cost, one.error)):
        if not best or one.error < best[-1].error:
            best.append(one)
    return best


def draw_settings(
    ax: Axes, settings: Sequence[Setting], reference: Reference, styles: Mapping[str, tuple[str, str]]
) -> None:
    """Error [%] over cost [s]: a symbol a setting, the front as steps, the own error of the reference shaded.

    Parameters
    ----------
    ax : Axes
    settings : sequence of Setting
    reference : Reference
    styles : mapping of str to (str, str)
        Knob to marker and colour.
    """
    plain(ax, (1.0, 3.0), (1.0, 2.0, 5.0))
    for one in settings:
        marker, colour = styles[one.knob]
        noise = math.hypot(one.noise, reference.floor)
        low, high = max(one.error - noise, LEAST), one.error + noise
        ax.vlines(one.cost, 100 * low, 100 * high, color=colour, lw=0.5, alpha=0.45, zorder=2)
        face = "none" if marker in OPEN else colour
        ax.plot(one.cost, 100 * max(one.error, LEAST), marker, color=colour, mfc=face, zorder=3)
    best = front(settings)
    if best:
        costs = [one.cost for one in best] + [1.5 * max(one.cost for one in settings)]
        errors = [100 * max(one.error, LEAST) for one in [*best, best[-1]]]
        ax.step(costs, errors, where="post", color=BLACK, lw=0.9, zorder=1.5)
    if reference.floor > LEAST:
        ax.axhspan(100 * LEAST, 100 * reference.floor, color=GREY, alpha=0.18, lw=0, zorder=0)


def plain(ax: Axes, x: Sequence[float] = (1.0,), y: Sequence[float] = (1.0,)) -> None:
    """Logarithmic axes with plain numbers, at these multiples of powers of ten."""
    ax.set_xscale("log")
    ax.set_yscale("log")
    for axis, subs in ((ax.xaxis, x), (ax.yaxis, y)):
        axis.set_major_locator(LogLocator(subs=subs))
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter(NullFormatter())


def handles(styles: Mapping[str, tuple[str, str]], used: Collection[str]) -> list[Line2D]:
    """Entries of a legend: the knobs that are used, and the front."""
    symbols = [
        Line2D([], [], ls="", marker=marker, color=colour, mfc="none" if marker in OPEN else colour, label=knob)
        for knob, (marker, colour) in styles.items()
        if knob in used
    ]
    return [*symbols, Line2D([], [], color=BLACK, lw=0.9, label="nothing better for less")]
