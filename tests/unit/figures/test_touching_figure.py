"""Touching cuts at zero particle size beside the model: exact fits, levels of both equations, holes."""

import math

import numpy as np
import pytest
from synthetic import failed, mpm_run

from orthocut.figures import registry
from orthocut.figures.nairn2015_touching import SPENT, condense, series_of
from orthocut.io.collect import case_of, collect
from orthocut.theory import touching

NAME = "nairn2015_touching"
RUBBING = 900.0


def model_of(run):
    case = case_of(run)
    return touching.solve(case.material, case.interface, case.tool, case.cut_depth, RUBBING)


def cut(points, rake=30, friction=0.0, ratio=1.1, angle=None, state=1):
    """A cut whose force is that of the model times a ratio less the particle size, which chips off a thick chip."""
    run = mpm_run(
        snapshots=0,
        touching=state,
        rake_angle=f"{rake} deg",
        friction=friction,
        modulus_tangent="0 MPa",
        points_per_depth=points,
    )
    model = model_of(run)
    run["force_cutting_mean"][...] = model.force_cutting * (ratio - 1 / points)
    run["force_rubbing_mean"][...] = RUBBING
    angle = model.angle_shear if angle is None else angle
    return run.assign(angle_shear=((), angle), chip_thickness_ratio=((), 1.2))


def sweep(**values):
    return [cut(n, rake, mu, **values) for rake in (15, 30, 45) for mu in (0, 0.3) for n in (8, 12, 16)]


def test_table_has_forces_limits_and_both_equations():
    table = registry.tabulate(NAME, collect(sweep(), dims=registry.dims(NAME)))
    assert [row[:2] for row in table.rows] == [[rake, mu] for rake in (15, 30, 45) for mu in (0, 0.3)]
    assert table.header[2:5] == [f"force at {n} points [-]" for n in (8, 12, 16)]
    for row in table.rows:
        facts = dict(zip(table.header, row, strict=True))
        assert facts["force at 8 points [-]"] == pytest.approx(facts["eq. (14) [-]"] * (1.1 - 1 / 8))
        assert facts["limit over eq. (14) [-]"] == pytest.approx(1.1)
        assert facts["eq. (13) at the measured angle [-]"] == pytest.approx(facts["eq. (14) [-]"])
        assert facts["chip thickness ratio [-]"] == 1.2
    frictionless = dict(zip(table.header, table.rows[2], strict=True))
    assert frictionless["eq. (14) [-]"] == pytest.approx(8.5, abs=0.01)
    assert frictionless["angle of least force [deg]"] == pytest.approx(60.0, abs=0.01)


def test_measured_angle_is_that_of_the_finest_run():
    """Nairn (2015), eq. (13), without friction by hand: k h (cot a + tan(a - r)) + G, as nothing slides at a cost."""
    angle, rake = math.radians(51), math.radians(30)
    runs = [cut(8, angle=0.9), cut(16, angle=angle)]
    found = series_of(collect(runs))[0]
    work = 25e6 / math.sqrt(3) * 0.9e-3 * (1 / math.tan(angle) + math.tan(angle - rake)) + 2000.0
    sliding = (math.sin(rake) - math.tan(rake) * math.cos(rake)) * math.sin(angle) / math.cos(angle - rake)
    assert sliding == pytest.approx(0.0, abs=1e-15)
    assert found.model_measured == pytest.approx(work / 2000.0)
    assert found.model_measured == pytest.approx(8.76, abs=0.01)


def test_runs_that_bend_are_drawn_and_do_not_enter_the_fit():
    runs = [cut(6, ratio=0.5, state=0), *(cut(n) for n in (8, 12, 16))]
    found = series_of(collect(runs))[0]
    assert len(found.runs) == 4
    assert found.fit.limit / found.model == pytest.approx(1.1)
    ax = registry.draw(NAME, collect(runs)).axes[0]
    assert len(ax.containers) == 5


def test_series_that_only_bend_are_left_out_and_lone_touching_runs_have_no_limit():
    assert series_of(collect([cut(n, state=0) for n in (8, 12)])) == []
    table = registry.tabulate(NAME, collect([cut(8, state=0), cut(12)]))
    assert math.isnan(dict(zip(table.header, table.rows[0], strict=True))["limit [-]"])


def test_failed_and_unmeasured_runs_are_holes():
    runs = [cut(8), cut(12), failed(cut(16))]
    table = registry.tabulate(NAME, collect([run.drop_vars("angle_shear") for run in runs]))
    facts = dict(zip(table.header, table.rows[0], strict=True))
    assert facts["limit over eq. (14) [-]"] == pytest.approx(1.1)
    assert math.isnan(facts["eq. (13) at the measured angle [-]"])


def test_one_panel_a_rake_angle_with_levels_of_the_models():
    figure = registry.draw(NAME, collect(sweep(angle=0.8)))
    assert [ax.get_title(loc="left") for ax in figure.axes] == [rf"$\alpha$ = {rake}°" for rake in (15, 30, 45)]
    for ax, rake in zip(figure.axes, (15, 30, 45), strict=True):
        for mu in (0, 0.3):
            model = model_of(cut(8, rake, mu)).force_over_toughness
            levels = [line.get_ydata() for line in ax.get_lines() if line.get_linestyle() == "--"]
            assert any(np.allclose(level, model) for level in levels)
        assert len([line for line in ax.get_lines() if line.get_linestyle() == ":"]) == 2


def test_condensed_runs_know_what_the_model_does_not():
    """Rates over the travel behind the start of the window; the synthetic run has shares of its work."""
    run = cut(8)
    length = float(run.tool_travel[-1])
    plastic = (("sample",), 0.01 * run.work_tool.values)
    run = run.assign(window_start=((), 0.5 * length), work_plastic_base=plastic)
    found = condense(run)
    late = run.tool_travel.values >= 0.5 * length
    work, travel = run.work_tool.values[late], run.tool_travel.values[late]
    rate = (work[-1] - work[0]) / (travel[-1] - travel[0]) / 2000.0
    shares = {"rate_plastic_base": 0.01, "rate_lost": 0.08 + 0.03, "rate_stored": 0.1 + 0.02}
    assert set(shares) == set(SPENT)
    for name, share in shares.items():
        assert float(found[name]) == pytest.approx(share * rate)
    facts = registry.tabulate(NAME, collect([condense(cut(16)), found.assign_attrs(run.attrs)])).rows[0]
    assert len(facts) == len(registry.tabulate(NAME, collect(sweep())).header) - 1
    assert condense(run.drop_vars("window_start")).identical(run.drop_vars("window_start"))
