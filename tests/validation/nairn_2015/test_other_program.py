"""Paper mode against the paper's own program; the data file says how its numbers were made.

Cuts of the hardening material, which bend, agree. Cuts of the perfectly plastic one do not, and these are the runs that
say why, each with one difference to paper mode (force over that of the program at h = 0.5, 1 and 3 mm):

    paper mode                                                        1.31    1.22    1.69
    momentum not restored after the first contact pass (program)      1.24    0.98    1.60
      and the other sign of the PIC term in eq (10)                   1.26    1.13
      and yield by the Cauchy stress (program)                        1.23    0.99    1.60
      and interface weights by distance, not by mass                  1.25    1.08    1.67
      and contact only at volume fractions of 0.001 to 0.999          1.24    0.99
      and a tool of 2 m/s instead of 5 m/s                            1.16            1.52
      and 10 points through the chip instead of 6                     1.24            1.43
      and a cutting path of 26h instead of 16h or 18h                 1.24            1.63
      and a base of 6h instead of 3h                                  1.24            1.54
      and the number of steps of the program at 3 mm                                  1.56
    contact by exact geometry                                         1.27    1.01    1.65

So the momentum explains h = 1 mm, where the tool touches the crack tip. What remains at 0.5 and 3 mm is not found.
"""

import csv
from pathlib import Path

import pytest

from orthocut.experiments.mpm_cutting import simulate
from orthocut.params.case import load

with open(Path(__file__).with_name("other_program.csv"), encoding="utf-8") as file:
    ROWS = {row["name"]: row for row in csv.DictReader(line for line in file if not line.startswith("#"))}
PAPER = {"scheme": "usavg", "contact": "cells", "grid_offset": 0.0, "affine": 0.0, "support": 0.0, "reach_ratio": 0.0}


def cut(row):
    """Run a row: force, and energy that went neither into material nor into interface over travel [N/m]."""
    options = {name: float(row[name]) for name in ("length_ratio", "travel_ratio")}
    options |= {"window_ratio": 6.0, "points_per_depth": int(row["points_per_depth"])}
    options |= {"cut_depth": f"{row['cut_depth']} mm", "cut_speed": f"{row['cut_speed']} m/s"}
    case = load("mpm", {**PAPER, **options, "modulus_tangent": f"{row['modulus_tangent']} MPa"})
    run = simulate(case, snapshots=0)
    window = (run.tool_travel >= 6.0 * case.cut_depth).values
    change = {
        name: float(run[name][window][-1] - run[name][window][0])
        for name in ("tool_travel", "work_tool", "energy_elastic", "energy_plastic", "energy_cohesive")
    }
    lost = change["work_tool"] - sum(value for name, value in change.items() if name.startswith("energy"))
    return run, lost / change["tool_travel"]


@pytest.mark.parametrize("name", ["a1_v5", "b_n5", "v10"])
def test_bending_cuts_agree(name):
    """Force within 10 %, thrust, lost energy and mode I nearly so; rubbing is half of the program's or less."""
    row = ROWS[name]
    run, lost = cut(row)
    print(f"{name}: {float(run.force_cutting_mean):.0f}, program {row['force_cutting']} N/m")
    print(f"lost: {lost:.0f}, program {row['lost_energy']} N/m")
    assert float(run.force_cutting_mean) == pytest.approx(float(row["force_cutting"]), rel=0.10)
    assert float(run.force_thrust_mean) == pytest.approx(float(row["force_thrust"]), rel=0.15)
    assert lost == pytest.approx(float(row["lost_energy"]), rel=0.10)
    assert 100 * float(run.mode_one_fraction) == pytest.approx(float(row["mode_one"]), abs=3.0)
    assert 0.0 < float(run.force_rubbing_mean) < float(row["force_rubbing"])


@pytest.mark.parametrize("name", ["e0_h05", "e0_h1", "e0_h3"])
@pytest.mark.xfail(reason="see the head of this file", strict=True)
def test_perfectly_plastic_cuts_agree(name):
    row = ROWS[name]
    run, _ = cut(row)
    print(f"{name}: {float(run.force_cutting_mean):.0f}, {row['force_cutting']} N/m")
    assert float(run.force_cutting_mean) == pytest.approx(float(row["force_cutting"]), rel=0.10)
