"""The study of the whole of Yang et al. (2018): loads, draws every figure, and takes snapshots of few cases."""

from pathlib import Path

import pytest
import yaml

from orthocut.cost import estimate_seconds
from orthocut.figures.registry import FIGURES
from orthocut.figures.yang2018_runs import CALIBRATED_STRENGTH
from orthocut.params.case import load
from orthocut.params.dem import FlatJoint
from orthocut.plan import load_plan

ROOT = Path(__file__).parents[2]
STUDY = ROOT / "workflow" / "config" / "yang2018.yaml"
CALIBRATED = ROOT / "results" / "published" / "calibration" / "paper_size" / "joint.yaml"


@pytest.fixture(scope="module")
def plan():
    return load_plan(STUDY)


def members(plan, figure, *sweeps):
    return {case for name, cases in plan.sweeps[figure].items() if not sweeps or name in sweeps for case in cases}


def test_every_figure_of_the_paper_is_drawn(plan):
    drawn = {name for name in plan.figures if name.startswith("yang2018_")}
    assert drawn == {name for name in FIGURES if name.startswith("yang2018_")}
    tables = {f"yang2018_{name}" for name in ("table1", "table2", "table4", "table6", "claims", "convergence")}
    assert tables <= set(plan.tables)


def test_pictures_show_three_packings_of_those_that_the_tables_hold(plan):
    pictures = [members(plan, f"yang2018_fig{number}") for number in (11, 12, 13, 14)]
    assert [len(cases) for cases in pictures] == [3, 3, 3, 3]
    assert set().union(*pictures) < members(plan, "yang2018_table4")
    assert members(plan, "yang2018_table4") == members(plan, "yang2018_fig17") | members(plan, "yang2018_fig18")


def test_cuts_of_the_tables_differ_in_depth_grooves_and_packing_alone(plan):
    cases = [plan.cases[case] for case in members(plan, "yang2018_table4")]
    same = {(case.joint, case.tool, case.cut_speed, case.travel, case.packing.radius_min) for case in cases}
    assert len(same) == 1
    assert {case.cut_depth for case in cases} == {0.1e-3, 0.2e-3}
    assert len({case.packing.seed for case in cases}) == 104


def test_printed_specimens_have_the_default_joints(plan):
    cases = [plan.cases[case] for case in members(plan, "yang2018_table2", "printed_tension", "printed_compression")]
    assert {case.joint for case in cases} == {FlatJoint()}


def test_calibrated_joints_are_the_same_everywhere(plan):
    tests = [plan.cases[case].joint for case in members(plan, "yang2018_table2", "calibrated_tension")]
    cuts = [plan.cases[case].joint for case in members(plan, "yang2018_claims", "regular_deep", "trapezoids")]
    damping = {"damping": tests[0].damping}
    assert len({joint.model_copy(update=damping) for joint in (*tests, *cuts)}) == 1


@pytest.mark.skipif(not CALIBRATED.exists(), reason="no published calibration")
def test_calibrated_joints_are_those_of_the_published_calibration(plan):
    (case, *_) = members(plan, "yang2018_table2", "calibrated_tension")
    assert plan.cases[case].joint == load("dem_tension", yaml.safe_load(CALIBRATED.read_text())).joint
    assert plan.cases[case].joint.strength_tensile == CALIBRATED_STRENGTH


def test_three_packings_of_the_four_cuts_fit_the_budget(plan):
    cases = set().union(*(members(plan, f"yang2018_fig{number}") for number in (11, 12, 13, 14)))
    assert sum(estimate_seconds(plan.cases[case]) for case in cases) < 2 * 30 * 60


def test_snapshots_are_taken_of_few_cases(plan):
    assert 0 < sum(count > 0 for count in plan.snapshots.values()) < 0.3 * len(plan.cases)
