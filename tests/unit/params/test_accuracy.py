"""Presets and tolerances: what they set, what they refuse, and that nothing else knows of them."""

import pytest

from orthocut.params import accuracy_ductile as accuracy
from orthocut.params.block import ConfigError
from orthocut.params.case import load, validate
from orthocut.params.identity import case_id
from orthocut.params.study import Study


def test_a_preset_is_the_case_with_its_fields():
    chosen = accuracy.presets()["standard"]
    plain = {"kind": "mpm", "cut_depth": "0.5 mm", **chosen.fields()}
    assert case_id(load("mpm", {"cut_depth": "0.5 mm", "preset": "standard"})) == case_id(validate(plain))
    assert validate({**plain, "workpiece": {"length_ratio": 24, "base_ratio": 4}}) == validate(
        {"kind": "mpm", "cut_depth": "0.5 mm", "preset": "standard", "workpiece": {"base_ratio": 4}}
    )


def test_presets_promise_more_for_more():
    case = load("mpm", {})
    promises = [accuracy.promise(case, choice) for choice in accuracy.presets().values()]
    works = [choice.work for choice in accuracy.presets().values()]
    assert [one.bound for one in promises] == sorted((one.bound for one in promises), reverse=True)
    assert all(one.typical < one.bound for one in promises)
    assert works == sorted(works)


@pytest.mark.parametrize("tolerance", ["60 %", "30%", 0.2, "10 %", "5.5 %"])
def test_a_tolerance_is_met_by_the_cheapest_choice(tolerance):
    case = load("mpm", {"tolerance": tolerance})
    share = float(str(tolerance).strip(" %")) / (100 if isinstance(tolerance, str) else 1)
    chosen = accuracy.cheapest(load("mpm", {}), share)
    assert case.numerics.points_per_depth == chosen.points_per_depth
    assert accuracy.promise(case, chosen).bound <= share
    for fewer in range(3, chosen.points_per_depth):
        cheaper = chosen._replace(points_per_depth=fewer)
        assert accuracy.promise(case, cheaper).bound > share


def test_errors_of_deep_cuts_are_larger():
    shallow, deep = load("mpm", {"cut_depth": "1 mm"}), load("mpm", {"cut_depth": "3 mm"})
    choice = accuracy.presets()["standard"]
    assert accuracy.depth_over_zone(deep) == pytest.approx(3 * accuracy.depth_over_zone(shallow))
    assert accuracy.promise(deep, choice).bound > accuracy.promise(shallow, choice).bound
    assert accuracy.promise(load("mpm", {"cut_depth": "6 mm"}), choice) is None
    assert accuracy.promise(load("mpm", {"rake_angle": "0 deg"}), choice) is None


@pytest.mark.parametrize(
    ("kind", "values", "words"),
    [
        ("mpm", {"tolerance": "1 %"}, r"tolerance = 0.01: no setting is known to be as good \(allowed: 2.[0-9] % or"),
        ("mpm", {"tolerance": "9 %", "cut_depth": "5 mm"}, r"3.6 lengths of the cohesive zone \(allowed: up to 3\)"),
        ("mpm", {"tolerance": "9 %", "friction": 1}, r"outside of tool.friction \(0 to 0.6\); take a preset"),
        ("mpm", {"tolerance": "9"}, "tolerance = '9': must be a share of the force, such as 10 % or 0.1"),
        ("mpm", {"tolerance": True}, "tolerance = True: must be a share"),
        ("mpm", {"tolerance": [1]}, "must be a share"),
        ("mpm", {"preset": "quik"}, "preset = 'quik': no such preset; did you mean quick"),
        ("mpm", {"preset": 3}, "preset = 3: no such preset"),
        ("mpm", {"preset": "quick", "tolerance": 0.1}, "preset and tolerance are both given"),
        ("mpm", {"preset": "quick", "points_per_depth": 9}, "also sets numerics .allowed: leave these out"),
        ("mpm", {"preset": "quick", "cut_speed": "5 m/s"}, "also sets cut_speed"),
        ("mpm", {"preset": "quick", "workpiece": {"length_ratio": 30}}, "also sets workpiece"),
        ("dem_tension", {"preset": "quick"}, "dem_tension has no such field"),
    ],
)
def test_what_is_refused(kind, values, words):
    with pytest.raises(ConfigError, match=words):
        load(kind, values)


def test_a_test_of_glass_has_no_preset():
    with pytest.raises(ConfigError, match=r"dem_tension has none \(allowed: in cases of mpm_cutting and dem_cutting"):
        validate({"kind": "dem_tension", "preset": "quick"})


def test_a_sweep_over_presets():
    sweep = {"base": {"kind": "mpm", "cut_depth": "0.5 mm"}, "axes": {"product": {"preset": ["quick", "standard"]}}}
    study = Study.model_validate({"title": "t", "sweeps": {"cuts": sweep}, "figures": {"energy_balance": ["cuts"]}})
    members = study.sweeps["cuts"].expand("s")
    assert [label for label, _ in members] == ["preset quick", "preset standard"]
    assert [case.numerics.points_per_depth for _, case in members] == [5, 8]
