"""Causes of the miss of cutting forces: each change is compared packing by packing, where nothing else differs."""

import math
from dataclasses import replace

import numpy as np
import pytest
from synthetic import make_case

from orthocut.figures.yang2018_causes import GAP, changes, gaps
from orthocut.figures.yang2018_paper import EXPERIMENT, FORCES, SIMULATION, mean
from orthocut.figures.yang2018_runs import GlassRun

CALIBRATED = {"joint.strength_tensile": "72.77 MPa", "joint.damping": 0.1}
USUAL = {1: 10.0, 2: 12.0, 3: 8.0}


def cuts(factor=1.0, seeds=USUAL, **fields):
    """Cuts whose force is that of their packing times a factor; the thrust is half of it."""
    return [
        GlassRun(
            make_case("dem_cutting", **{**CALIBRATED, "packing.seed": seed, **fields}),
            {"force_cutting_mean": factor * USUAL[seed], "force_thrust_mean": 0.5 * factor * USUAL[seed]},
        )
        for seed in seeds
    ]


@pytest.mark.parametrize(
    ("fields", "choice", "change"),
    [
        ({"joint.damping": 0.7}, "local damping", "0.1 → 0.7"),
        ({"cut_speed": "0.2 m/s"}, "speed of the tool", "1 m/s → 0.2 m/s"),
        ({"packing.radius_min": "20 um"}, "smallest radius", "10 µm → 20 µm"),
        ({"packing.height": "0.5 mm"}, "height of the block", "1 mm → 0.5 mm"),
        (
            {"packing.height": "0.5 mm", "packing.radius_min": "20 um"},
            "block and discs",
            "1 x 1 mm of 10 µm → 1 x 0.5 mm of 20 µm",
        ),
        ({"tool.friction": 0}, "friction at the tool", "0.577 → 0"),
        ({"joint.time_step_factor": 0.25}, "time step factor", "0.5 → 0.25"),
        ({"joint.strength_tensile": "200 MPa"}, "joints", "calibrated → as printed"),
        ({"joint.strength_tensile": "145.54 MPa"}, "joints", "calibrated → 2 times as strong"),
    ],
)
def test_a_change_has_the_factor_of_the_same_packings(fields, choice, change):
    (row,) = changes(cuts() + cuts(0.25, (2, 3), **fields))
    assert (row.choice, row.change, row.packings) == (choice, change, 2)
    assert [one.mean for one in row.factors] == pytest.approx([0.25, 0.25])
    assert row.factors[0].half == pytest.approx(0.0, abs=1e-12)


def test_grooves_are_compared_with_those_of_the_paper():
    runs = cuts(grooves={}) + cuts(0.5, grooves={"distance": "0.14 mm"}) + cuts(2.0)
    found = {row.change: row.factors[0].mean for row in changes(runs)}
    usual = "rectangles 0.2 mm apart"
    assert found == pytest.approx({f"{usual} → rectangles 0.14 mm apart": 0.5, f"{usual} → none": 2.0})


def test_the_first_three_quarters_of_the_travel_stand_beside():
    whole = [replace(run, parts={FORCES[0]: np.repeat([2.0, 94.0], [6, 2])}) for run in cuts(grooves={})]
    others = [replace(run, parts={FORCES[0]: np.repeat([3.0, 0.0], [6, 2])}) for run in cuts(2.0)]
    (row,) = changes(whole + others)
    assert row.factors[0].mean == pytest.approx(2.0)
    assert row.early.mean == pytest.approx(1.5)


def test_cuts_that_differ_in_more_are_not_compared():
    assert not list(changes(cuts() + cuts(0.5, **{"joint.damping": 0.7, "cut_speed": "0.2 m/s"})))


def test_one_packing_makes_no_row():
    assert not list(changes(cuts() + cuts(0.5, (1,), **{"joint.damping": 0.7})))


def test_gaps_are_simulated_over_measured_forces_for_the_same_width():
    rows = list(gaps(cuts() + cuts(0.25, **{"joint.damping": 0.7})))
    assert {row.choice for row in rows} == {GAP}
    paper = [row for row in rows if row.change == "paper"]
    cut = (0.1, False)
    expected = 25.4 * mean(SIMULATION[cut][FORCES[0]]) / mean(EXPERIMENT[cut][FORCES[0]])
    assert paper[0].factors[0].mean == pytest.approx(expected)
    ours = [row.factors[0].mean for row in rows if row.change == "this work"]
    assert ours == pytest.approx([10 * 25.4 / mean(EXPERIMENT[cut][FORCES[0]]) * scale for scale in (1.0, 0.25)])
    assert not math.isnan(rows[-1].factors[0].half)
