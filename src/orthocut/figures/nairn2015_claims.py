"""The claims of Nairn (2015) and what the cuts of a study say of them: a table, and a picture of it."""

from __future__ import annotations

import math
from typing import NamedTuple

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures import nairn2015_rules_bending as bending
from orthocut.figures import nairn2015_rules_method as method
from orthocut.figures import nairn2015_rules_touching as touching
from orthocut.figures import nairn2015_rules_transition as transition
from orthocut.figures import nairn2015_rules_zone as zone
from orthocut.figures.canvas import PAGE, page, styled
from orthocut.figures.nairn2015_cuts import condense, cuts_of
from orthocut.figures.nairn2015_finding import ARTEFACT, NOT_REPRODUCED, NOT_TESTED, REPRODUCED, Finding, Rule
from orthocut.figures.palette import GREEN, ORANGE, PURPLE
from orthocut.figures.tables import Table

__all__ = ["CAPTION", "DIMS", "condense", "draw", "tabulate"]

CAPTION = (
    "Claims of Nairn (2015) and the verdicts that fixed rules give on them from the runs of this study. Symbols: "
    "deviation from the value of the paper where the claim is a number; those beyond the axis stand at its ends. "
    "Rules take the finest resolution that is common among the runs, and straight lines over particle size to zero "
    "where runs at other resolutions differ in nothing else. Artefact: seen at this resolution, but not at zero "
    "particle size. Not tested: runs are missing. The table holds the numbers, the rules and the figures that show "
    "them."
)
DIMS = ()
COLOURS = {
    REPRODUCED: GREEN,
    NOT_REPRODUCED: ORANGE,
    ARTEFACT: PURPLE,
    NOT_TESTED: "0.55",
}
RANGE = 100.0
"""Largest deviation that the axis shows [%]."""


class Claim(NamedTuple):
    """What the paper says."""

    text: str
    source: str
    """Where it says so."""
    paper: str
    """Its value, in words."""
    rule: Rule


CLAIMS = (
    Claim("force is constant for d ≥ 3", "Fig. 3A", "constant", method.force_does_not_depend_on_base),
    Claim("force declines with particle size", "Fig. 3B", "declines", method.force_declines_with_size),
    Claim(
        "PIC does not change the force",
        "section 2.2",
        "no change against FLIP",
        method.transfers_do_not_change_the_force,
    ),
    Claim("cutting is steady from 4 ms on", "Fig. 4", "5.6 depths of cut of travel", method.steady_from_four_ms),
    Claim(
        "touching agrees with eq. (15), no friction",
        "Fig. 8",
        "agrees",
        touching.touching_agrees_without_friction,
    ),
    Claim("touching agrees with eq. (14), friction", "Fig. 11", "agrees well", touching.touching_agrees_with_friction),
    Claim(
        "thin cuts touch though bending needs less",
        "Fig. 8, section 4",
        "always",
        touching.thin_cuts_touch_against_the_lower_force,
    ),
    Claim("transition at 30°", "Figs 8, 9", "2.0-2.1 mm", transition.transition_at_thirty_degrees),
    Claim(
        "rubbing grows with depth and rake angle",
        "Fig. 10",
        "grows with both",
        bending.rubbing_grows_with_rake_and_depth,
    ),
    Claim(
        "friction moves the transition deeper",
        "Fig. 11",
        "to thicker cuts",
        transition.friction_moves_the_transition_deeper,
    ),
    Claim(
        "hardening moves the transition thinner",
        "Fig. 12",
        "to thinner cuts",
        transition.hardening_moves_the_transition_thinner,
    ),
    Claim("no drop at a tangent modulus of 25 MPa", "Fig. 12", "nearly gone", transition.drop_vanishes_at_25_mpa),
    Claim("always bending at 100 MPa", "Fig. 13", "all", transition.hard_cuts_always_bend),
    Claim("force exceeds bending model", "Fig. 13", "10-90 %", bending.forces_exceed_bending_by_10_to_90_percent),
    Claim("no peak of force at large depth", "Fig. 13", "none", bending.deep_cuts_have_no_peak),
    Claim("cohesive law changes the force", "Fig. 14, section 4", "differs", zone.law_changes_the_force),
    Claim(
        "transition thinner at 10 MPa cohesive stress",
        "Fig. 15",
        "to thinner cuts",
        transition.weak_interface_moves_the_transition_thinner,
    ),
    Claim(
        "bending model fits better at 10 MPa",
        "Fig. 15",
        "better than at 40 MPa",
        zone.weak_interface_fits_bending_better,
    ),
    Claim("mode I in bending", "Fig. 16", "above 90 %", zone.bending_is_mode_one),
    Claim(
        "mode I in bending at 10 MPa cohesive stress",
        "section 4",
        "about 75 %",
        zone.weak_bending_is_75_percent_mode_one,
    ),
    Claim(
        "mode I falls with Z in touching",
        "Fig. 16",
        "correlated",
        touching.touching_mode_falls_with_thrust_ratio,
    ),
    Claim("shear strains reach 80 %", "section 4", "80 %", bending.shear_strain_reaches_80_percent),
)


def judged(dataset: xr.Dataset) -> list[tuple[Claim, Finding]]:
    """Every claim with what its rule finds."""
    cuts = cuts_of(dataset)
    missing = Finding("", math.nan, NOT_TESTED, "runs are missing")
    return [(claim, (claim.rule(cuts) if cuts else None) or missing) for claim in CLAIMS]


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One row a claim: deviation from the paper, and verdict."""
    found = judged(dataset)
    figure = page(0.21 * len(found) + 0.7, PAGE)
    ax = figure.subplots()
    for row, (_, finding) in enumerate(found):
        colour = COLOURS[finding.verdict]
        if math.isfinite(finding.error):
            ax.plot(min(max(finding.error, -RANGE), RANGE), row, "o", color=colour)
        ax.text(1.02, row, finding.verdict, color=colour, va="center", transform=ax.get_yaxis_transform())
    ax.axvline(0, color="0.4", lw=0.6, zorder=1)
    ax.set_xlim(-1.05 * RANGE, 1.05 * RANGE)
    ax.set_yticks(range(len(found)), [claim.text for claim, _ in found])
    ax.set_ylim(len(found) - 0.5, -0.5)
    ax.set_xlabel("deviation from the value of the paper [%]")
    ax.set_ylabel("claim of the paper")
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """Claims, values and verdicts."""
    header = ["claim", "source", "paper value", "ours", "error [%]", "verdict", "evidence"]
    rows = [[claim.text, f"Nairn (2015), {claim.source}", claim.paper, *finding] for claim, finding in judged(dataset)]
    return Table("Claims of Nairn (2015)", header, rows)
