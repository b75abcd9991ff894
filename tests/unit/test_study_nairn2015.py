"""The study of the whole of Nairn (2015): loads, has the cases and figures that it says, computes each case once."""

from pathlib import Path

import pytest

from orthocut.figures.registry import FIGURES
from orthocut.plan import load_plan

STUDY = Path(__file__).parents[2] / "workflow" / "config" / "nairn2015.yaml"
MAP = 66
MAIN = 891


@pytest.fixture(scope="module")
def plan():
    return load_plan(STUDY)


def members(plan, figure, sweeps=()):
    return {case for name, cases in plan.sweeps[figure].items() if not sweeps or name in sweeps for case in cases}


def test_number_of_cases(plan):
    extra = members(plan, "nairn2015_regimes", ("map_short", "map_rakes", "map_moduli"))
    assert len(extra) == MAP
    assert len(set(plan.cases) - extra) == MAIN


def test_every_figure_of_the_paper_is_drawn(plan):
    drawn = {name for name in plan.figures if name.startswith("nairn2015_")}
    assert drawn == {name for name in FIGURES if name.startswith("nairn2015_")}
    assert {"nairn2015_claims", "nairn2015_convergence", "nairn2015_regimes"} <= set(plan.tables)


def test_figures_share_cases(plan):
    assert members(plan, "nairn2015_fig08") == members(plan, "nairn2015_fig10")
    thirty = members(plan, "nairn2015_fig08", ("plastic_thirty",))
    for figure in ("nairn2015_fig09", "nairn2015_transition", "nairn2015_convergence"):
        assert members(plan, figure) & thirty


def test_all_cases_of_the_depth_sweeps_share_their_numerics(plan):
    figures = [f"nairn2015_fig{number}" for number in ("08", "10", "11", "12", "13", "14", "15", "16")]
    cases = [plan.cases[case] for figure in figures for case in plan.figures[figure]]
    numerics = {case.numerics.model_copy(update={"points_per_depth": 8}) for case in cases}
    assert len(numerics) == 1
    assert len({(case.workpiece, case.cut_speed, case.travel_ratio) for case in cases}) == 1
    assert max(case.numerics.points_per_depth for case in cases) == 8


def test_snapshots_are_taken_of_few_cases(plan):
    assert 0 < sum(count > 0 for count in plan.snapshots.values()) < 12
