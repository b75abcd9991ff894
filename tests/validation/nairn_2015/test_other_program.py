"""Paper mode against the paper's own program; the data file says how its numbers were made.

Cuts of the hardening material, which bend, agree. Cuts of the perfectly plastic one do not, and these are runs that say
why, each with one difference to paper mode (force over that of the program):

    depth of cut [mm]                                                 0.5     1       3       0.9, hardening
    paper mode                                                        1.31    1.23    1.70    0.93
    momentum not restored after the first contact pass (program)      1.26    1.18    1.65    0.90
      and without the chip's nodes in the row of the cut              0.94    0.95    1.65    0.90
    the same with momentum restored                                   0.98    0.98    1.70    0.93

By its source, the program reads the force on its tool from one of the velocity fields that a node has near a crack,
though the tool acts on all: what it does to the chip at nodes that see both bodies is not reported. Its energies say so
too: at 0.5 mm the work of its tool is 128 N/m less than what material and interface took, whereas transfers and impacts
lose (here 2,100 N/m). That explains the forces that it reports at 0.5 and 1 mm, not its rubbing forces there (0.5 and
2.3 kN/m, here 3.0 and 5.2). The energy that the material takes agrees within 10 and 13 %.

At 3 mm, where the cohesive zone is 1.4 cells long, and in part at 1 mm, the force hangs on when chip and base count as
closed again ahead of the tool, which is a matter of a twentieth of a cell:

    where pairs of the interface overlap (paper mode)                 1.31    1.23    1.70    0.93
    where they are open by less than 0.05 cells                       1.30    1.03    0.36    0.83
    where mean positions at a node are nearer than 0.75 cells         1.19    0.91    1.65    0.94
    nearer than 0.8 cells                                             failed  0.58    0.82    0.75

The last rule is the program's for its tool, and gives within 12 % what its version of 2026 does at 1 mm and with
hardening (9.8 and 6.1 kN/m; here 11.0 and 6.5). So this rule may be what parts its versions.

What else was tried changes the forces by less than 10 %, mostly: the sign of the PIC term in eq (10), yield by the
Cauchy stress, interface weights by distance, contact only at volume fractions of 0.001 to 0.999, a tool of 2 m/s, 10
points through the chip, a path of 26h, a base of 6h, as many steps as the program takes, tractions along fixed
directions, contact by exact geometry (1.01 at 1 mm with the momentum not restored).
"""

import csv
from pathlib import Path

import pytest

from orthocut.experiments.mpm_cutting import simulate
from orthocut.params.case import load

with open(Path(__file__).with_name("other_program.csv"), encoding="utf-8") as file:
    ROWS = {row["name"]: row for row in csv.DictReader(line for line in file if not line.startswith("#"))}
PAPER = {"scheme": "usavg", "contact": "cells", "grid_offset": 0.0, "affine": 0.0, "support": 0.0, "reach_ratio": 0.0}
TOUGHNESS = 2000.0  # of the interface, for unit width [N/m]


def cut(name):
    """Run a row: the run, and the energy that the material took and that was lost, over travel [N/m]."""
    row = ROWS[name]
    options = {name: float(row[name]) for name in ("length_ratio", "travel_ratio")}
    options |= {"window_ratio": 6.0, "points_per_depth": int(row["points_per_depth"])}
    options |= {"cut_depth": f"{row['cut_depth']} mm", "cut_speed": f"{row['cut_speed']} m/s"}
    case = load("mpm", {**PAPER, **options, "modulus_tangent": f"{row['modulus_tangent']} MPa"})
    run = simulate(case, snapshots=0)
    window = (run.tool_travel >= 6.0 * case.cut_depth).values

    def gained(*names):
        return sum(float(run[name][window][-1] - run[name][window][0]) for name in names)

    travel, material = gained("tool_travel"), gained("energy_elastic", "energy_plastic")
    lost = gained("work_tool") - material - gained("energy_cohesive")
    return run, material / travel, lost / travel


@pytest.mark.parametrize("name", ["a1_v5", "b_n5", "v10"])
def test_bending_cuts_agree(name):
    """Force within 10 %, thrust, lost energy and mode I nearly so; rubbing is half of the program's or less."""
    row = ROWS[name]
    run, _, lost = cut(name)
    print(f"{name}: {float(run.force_cutting_mean):.0f}, program {row['force_cutting']} N/m")
    print(f"lost: {lost:.0f}, program {row['lost_energy']} N/m")
    assert float(run.force_cutting_mean) == pytest.approx(float(row["force_cutting"]), rel=0.10)
    assert float(run.force_thrust_mean) == pytest.approx(float(row["force_thrust"]), rel=0.15)
    assert lost == pytest.approx(float(row["lost_energy"]), rel=0.10)
    assert 100 * float(run.mode_one_fraction) == pytest.approx(float(row["mode_one"]), abs=3.0)
    assert 0.0 < float(run.force_rubbing_mean) < float(row["force_rubbing"])


@pytest.mark.parametrize("name", ["e0_h05", "e0_h1"])
def test_perfectly_plastic_material_takes_as_much_energy(name):
    """Within 15 %; the program does not report all that is lost besides, nor the force that does it."""
    row = ROWS[name]
    run, material, lost = cut(name)
    reported = float(row["lost_energy"])
    wanted = float(row["force_cutting"]) - TOUGHNESS - reported
    print(f"{name}: {material:.0f}, program {wanted:.0f} N/m; lost {lost:.0f}, program {reported:.0f} N/m")
    assert material == pytest.approx(wanted, rel=0.15)
    assert lost > reported + 1500.0
    assert 1.15 < float(run.force_cutting_mean) / float(row["force_cutting"]) < 1.35


@pytest.mark.xfail(reason="hangs on when the interface counts as closed, see the head of this file", strict=True)
def test_perfectly_plastic_cut_of_few_cells_agrees():
    run, _, _ = cut("e0_h3")
    print(f"{float(run.force_cutting_mean):.0f}, program {ROWS['e0_h3']['force_cutting']} N/m")
    assert float(run.force_cutting_mean) == pytest.approx(float(ROWS["e0_h3"]["force_cutting"]), rel=0.10)
