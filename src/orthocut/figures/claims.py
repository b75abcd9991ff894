"""Claims of a paper beside what rules find of them: what both are, a picture and a table."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, page
from orthocut.figures.palette import AMBER, GREEN, ORANGE, PURPLE
from orthocut.figures.tables import Table

REPRODUCED, NOT_REPRODUCED, ARTEFACT = "reproduced", "not reproduced", "artefact"
UNDECIDED, NOT_TESTED = "undecided", "not tested"
COLOURS: Mapping[str, str] = {
    REPRODUCED: GREEN,
    NOT_REPRODUCED: ORANGE,
    ARTEFACT: PURPLE,
    UNDECIDED: AMBER,
    NOT_TESTED: "0.55",
}


class Finding(NamedTuple):
    """What a rule found."""

    ours: str
    """Our value, in words."""
    error: float
    """Deviation from the paper's value [%]; NaN where the claim is no number."""
    verdict: str
    """Reproduced (at zero particle size, where that is known of most cuts); not reproduced; artefact: seen at this
    resolution, but not at zero particle size; undecided: the confidence interval is too wide to tell."""
    evidence: str
    """Which cuts, which rule."""


class Claim(NamedTuple):
    """What a paper says."""

    text: str
    source: str
    """Where it says so."""
    paper: str
    """Its value, in words."""
    rule: Callable[[Any], Finding | None]
    """Takes the runs of a study; gives nothing where some that it needs are missing."""


Judged = Sequence[tuple[Claim, Finding]]


def judge(claims: Sequence[Claim], runs: Any) -> Judged:
    """Every claim with what its rule finds in the runs; without any runs, none is tested."""
    missing = Finding("", math.nan, NOT_TESTED, "runs are missing")
    return [(claim, (claim.rule(runs) if runs else None) or missing) for claim in claims]


def picture(judged: Judged, largest: float) -> Figure:
    """One row a claim: deviation from the paper, up to a largest one [%], and verdict."""
    figure = page(0.21 * len(judged) + 0.7, PAGE)
    ax = figure.subplots()
    for row, (_, finding) in enumerate(judged):
        colour = COLOURS[finding.verdict]
        if math.isfinite(finding.error):
            ax.plot(min(max(finding.error, -largest), largest), row, "o", color=colour)
        ax.text(1.02, row, finding.verdict, color=colour, va="center", transform=ax.get_yaxis_transform())
    ax.axvline(0, color="0.4", lw=0.6, zorder=1)
    ax.set_xlim(-1.05 * largest, 1.05 * largest)
    ax.set_yticks(range(len(judged)), [claim.text for claim, _ in judged])
    ax.set_ylim(len(judged) - 0.5, -0.5)
    ax.set_xlabel("deviation from the value of the paper [%]")
    ax.set_ylabel("claim of the paper")
    return figure


def table(judged: Judged, paper: str) -> Table:
    """Claims of a paper, values and verdicts."""
    header = ["claim", "source", "paper value", "ours", "error [%]", "verdict", "evidence"]
    rows = [[claim.text, f"{paper}, {claim.source}", claim.paper, *finding] for claim, finding in judged]
    return Table(f"Claims of {paper}", header, rows)
