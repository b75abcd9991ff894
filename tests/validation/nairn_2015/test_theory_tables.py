"""Both cutting models against tables of an independent program; the data file says what the columns are."""

import csv
import math
from pathlib import Path

import pytest

from orthocut.params.cohesive import CohesiveZone
from orthocut.params.material import ElasticPlastic
from orthocut.params.tool import Tool
from orthocut.theory import bending, touching

with open(Path(__file__).with_name("theory_tables.csv"), encoding="utf-8") as file:
    ROWS = list(csv.DictReader(line for line in file if not line.startswith("#")))


def half_unit(text):
    """Half a unit of the last printed digit, at least 1e-6 relative, plus round-off of the last digit."""
    digits = len(text.partition(".")[2])
    return max(0.5001 * 10.0**-digits, 1e-6 * abs(float(text))) if digits < 8 else 1e-9 * abs(float(text))


def solve(row):
    material = ElasticPlastic(modulus_tangent=f"{row['modulus_tangent']} MPa")
    interface = CohesiveZone()
    tool = Tool(rake_angle=f"{row['rake_angle']} deg", friction=float(row["friction"]))
    depth = float(row["cut_depth"]) * 1e-3
    rubbing = float(row["rubbing"]) * interface.toughness
    if row["model"] == "touching":
        return touching.solve(material, interface, tool, depth, rubbing, criterion=row["criterion"])
    chi = float(row["root_rotation"])
    return bending.solve(
        material, interface, tool, depth, rubbing, form=row["form"], slope=row["slope"], root_rotation=chi
    )


def test_the_data_file_holds_all_tables():
    assert len(ROWS) > 600
    assert {row["model"] for row in ROWS} == {"touching", "bending"}


@pytest.mark.parametrize("model", ["touching", "bending"])
def test_forces_agree_to_the_last_printed_digit(model):
    misses = []
    for row in (row for row in ROWS if row["model"] == model):
        found = solve(row)
        values = {
            "cutting": found.force_over_toughness,
            "thrust": found.thrust_over_toughness,
            "angle_shear": math.degrees(getattr(found, "angle_shear", math.nan)),
            "curvature": getattr(found, "curvature_ratio", math.nan),
        }
        for name, value in values.items():
            if row[name] and not abs(value - float(row[name])) <= half_unit(row[name]):
                misses.append((name, value, row))
    assert not misses


def test_a_wrong_number_would_be_seen():
    row = next(row for row in ROWS if row["model"] == "bending" and row["thrust"])
    assert abs(solve(row).force_over_toughness * 1.001 - float(row["cutting"])) > half_unit(row["cutting"])
