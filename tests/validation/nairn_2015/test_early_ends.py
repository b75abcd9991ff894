"""When cuts that may end early end: predicted steps against those of the published study."""

import csv
from pathlib import Path

import numpy as np

from orthocut.cost import expected_steps
from orthocut.params.study import load_study

ROOT = Path(__file__).parents[3]


def test_steps_are_predicted_within_a_quarter():
    cases = {}
    for members in load_study(ROOT / "workflow" / "config" / "nairn2015.yaml").cases().values():
        cases |= members
    ratios = []
    with open(ROOT / "results" / "published" / "nairn2015" / "run_times.csv", newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            case = cases.get(row["case"])
            if case and case.error_target and row["status"] == "done":
                ratios.append(expected_steps(case) / int(row["steps"]))
    near = float(np.mean(np.abs(np.array(ratios) - 1) < 0.25))
    print(f"{len(ratios)} cuts, {near:.1%} within 25 %; median {np.median(ratios):.2f}")
    assert len(ratios) > 900
    assert near > 0.95
