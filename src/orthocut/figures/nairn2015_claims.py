"""The claims of Nairn (2015) and what the cuts of a study say of them: a table, and a picture of it."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures import nairn2015_rules_bending as bending
from orthocut.figures import nairn2015_rules_method as method
from orthocut.figures import nairn2015_rules_touching as touching
from orthocut.figures import nairn2015_rules_transition as transition
from orthocut.figures import nairn2015_rules_zone as zone
from orthocut.figures.canvas import styled
from orthocut.figures.claims import (
    Claim,
    judge,
    picture,
    table,
)
from orthocut.figures.nairn2015_cuts import condense, cuts_of
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
RANGE = 100.0
"""Largest deviation that the axis shows [%]."""


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


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One row a claim: deviation from the paper, and verdict."""
    return picture(judge(CLAIMS, cuts_of(dataset)), RANGE)


def tabulate(dataset: xr.Dataset) -> Table:
    """Claims, values and verdicts."""
    return table(judge(CLAIMS, cuts_of(dataset)), "Nairn (2015)")
