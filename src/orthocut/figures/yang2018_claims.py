"""The claims of Yang et al. (2018) and what the runs of a study say of them: a table, and a picture of it."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures import yang2018_rules_damage as damage
from orthocut.figures import yang2018_rules_forces as force
from orthocut.figures import yang2018_rules_material as material
from orthocut.figures.canvas import styled
from orthocut.figures.claims import (
    Claim,
    judge,
    picture,
    table,
)
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_finding import glass_of
from orthocut.figures.yang2018_paper import FORCES, NAMES, SIMULATION, TABLE_2, mean, words
from orthocut.figures.yang2018_runs import condense

__all__ = ["CAPTION", "DIMS", "condense", "draw", "tabulate"]

CAPTION = (
    "Claims of Yang et al. (2018) and the verdicts that fixed rules give on them from the runs of this study. Symbols: "
    "deviation from the value of the paper where the claim is a number; those beyond the axis stand at its ends. "
    "Undecided: the 95 % confidence interval is too wide to tell. Not tested: runs are missing. The table holds the "
    "numbers, the rules and the figures that show them."
)
DIMS = ("sample",)
RANGE = 200.0
"""Largest deviation that the axis shows [%]."""


CLAIMS = (
    *(
        Claim(
            f"{row.words} of the parameters of Table 1",
            "Tables 1, 2",
            f"{row.model:g}{'' if row.unit == '-' else f' {row.unit}'}",
            material.printed_gives(row),
        )
        for row in TABLE_2
    ),
    Claim(
        "calibrated joints have all properties of glass",
        "Table 2",
        "71 GPa, 0.23, 41 MPa, 330 MPa",
        material.calibration_reaches_glass,
    ),
    Claim("cracks in tension and in shear", "Figs 7, 8, 11-14", "both", material.both_kinds_of_cracks),
    *(
        Claim(
            f"mean {NAMES[name]} force, {words(cut)}",
            "Table 4",
            f"{mean(SIMULATION[cut][name]):.2f} N/mm",
            force.mean_is(cut, name),
        )
        for cut in sorted(SIMULATION)
        for name in FORCES
    ),
    Claim("forces rise with depth of cut", "section 4, Table 4", "rise", force.forces_rise_with_depth),
    Claim("exponent of main force over depth of cut", "Table 4", "0.24", force.exponent_of_depth),
    Claim("grooves lower main forces", "section 4, Table 4", "to 0.14 and 0.20", force.grooves_lower_forces),
    Claim("thrust over main force, regular", "Table 4", "0.67 and 0.71", force.thrust_over_main),
    Claim("random peaks and valleys of force", "section 4, Figs 11-14", "numerous", force.peaks_are_random),
    Claim("regular cuts are more repeatable", "section 6, Table 4", "more", force.grooved_cuts_scatter_more),
    Claim("thrust of 1.06 N among the replicates", "Table 4", "1.06 N/mm", force.odd_replicate),
    Claim("simulation agrees with experiment", "section 5, Figs 17, 18", "within 7-26 %", force.agrees_with_experiment),
    Claim("fewer broken bonds with grooves", "section 4", "fewer", damage.grooves_leave_fewer_cracks),
    Claim("shallower cracks below with grooves", "section 4", "shallower", damage.grooves_leave_shallower_cracks),
    Claim("hardly any cracks below with grooves", "section 4", "almost none", damage.grooves_leave_no_cracks_below),
    Claim("deeper cracks below deeper cuts", "section 4", "deeper", damage.deep_cuts_damage_deeper),
    Claim("larger chips from deeper cuts", "section 4", "larger", damage.deep_cuts_have_larger_chips),
    Claim(
        "trapezoid grooves explain the thrust that is missed",
        "section 5",
        "x 2.49",
        damage.trapezoids_explain_the_thrust,
    ),
)


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One row a claim: deviation from the paper, and verdict."""
    return picture(judge(CLAIMS, glass_of(dataset)), RANGE)


def tabulate(dataset: xr.Dataset) -> Table:
    """Claims, values and verdicts."""
    return table(judge(CLAIMS, glass_of(dataset)), "Yang et al. (2018)")
