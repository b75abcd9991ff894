"""Presets and tolerances of cuts of glass: speed of the tool, number of packings, and what is refused."""

import math

import numpy as np
import pytest

from orthocut.params import accuracy_glass as accuracy
from orthocut.params.accuracy import evidence
from orthocut.params.block import ConfigError
from orthocut.params.case import validate
from orthocut.params.quantity import convert
from orthocut.params.study import Study

JOINT = {"modulus": "79.5 GPa", "stiffness_ratio": 3.215, "strength_tensile": "72.77 MPa", "cohesion": "174 MPa"}
GLASS = {"kind": "dem", "joint": JOINT}
CUT = validate(GLASS)


def members(base, **sweep):
    sweeps = {"cuts": {"base": {**GLASS, **base}, **sweep}}
    study = Study.model_validate({"title": "t", "sweeps": sweeps, "figures": {"energy_balance": ["cuts"]}})
    return [case for _, case in study.sweeps["cuts"].expand("s")]


def test_a_preset_sets_speed_damping_and_packings():
    cases = members({"preset": "quick"})
    chosen = accuracy.presets()["quick"]
    assert len(cases) == chosen.packings
    assert {case.cut_speed for case in cases} == {convert(chosen.cut_speed, "m/s")}
    assert {case.joint.damping for case in cases} == {0.1}
    assert {case.joint.modulus for case in cases} == {79.5e9}
    assert len(members({"preset": "quick"}, replicates=2)) == 2
    both = members({}, axes={"product": {"preset": ["quick", "standard"]}})
    assert len(both) == chosen.packings + accuracy.presets()["standard"].packings


def test_presets_promise_more_for_more():
    choices = list(accuracy.presets().values())
    promises = [accuracy.promise(CUT, choice) for choice in choices]
    works = [choice.work for choice in choices]
    assert [one.bound for one in promises] == sorted((one.bound for one in promises), reverse=True)
    assert all(one.typical < one.bound for one in promises)
    assert works == sorted(works)


def test_promises_are_quantiles_of_what_speed_and_scatter_do():
    """Ninety of a hundred means of random forces keep to the bound."""
    row = evidence()["glass"]["speed"][1]
    for packings in (1, 4, 50):
        noise = np.random.default_rng(packings).normal(0, row["scatter"] / math.sqrt(packings), 100_000)
        bound = accuracy.promise(CUT, accuracy.Choice(row["cut_speed"], packings)).bound
        errors = np.abs((1 + row["bound"]) * (1 + noise) - 1)
        assert np.mean(errors <= bound) == pytest.approx(0.9, abs=0.005)


@pytest.mark.parametrize("tolerance", [0.6, 0.45, 0.35])
def test_a_tolerance_is_met_by_the_cheapest_choice(tolerance):
    chosen = accuracy.cheapest(CUT, tolerance)
    cases = members({"tolerance": tolerance})
    assert len(cases) == chosen.packings
    assert cases[0].cut_speed == convert(chosen.cut_speed, "m/s")
    assert accuracy.promise(CUT, chosen).bound <= tolerance
    for row in evidence()["glass"]["speed"]:
        for packings in range(1, 100):
            other = accuracy.Choice(row["cut_speed"], packings)
            assert other.work >= chosen.work or accuracy.promise(CUT, other).bound > tolerance


def test_with_packings_given_a_tolerance_sets_the_speed_alone():
    assert len(members({"tolerance": "50 %"}, replicates=12)) == 12


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        (
            {"tolerance": "9 %", "cut_depth": "0.3 mm"},
            r"not known outside of cut_depth \(0.1 mm to 0.2 mm\); take a preset",
        ),
        ({"tolerance": "9 %", "joint": {}}, "outside of joint.modulus"),
        (
            {"tolerance": "2 %"},
            r"one packing is not known to be as good \(allowed: in sweeps\); a sweep without",
        ),
        ({"preset": "quick", "cut_speed": "5 m/s"}, "also sets cut_speed"),
        ({"preset": "quick", "joint": {**JOINT, "damping": 0.7}}, "also sets joint"),
        ({"preset": "quik"}, "no such preset; did you mean quick"),
    ],
)
def test_what_is_refused(fields, words):
    with pytest.raises(ConfigError, match=words):
        validate({**GLASS, **fields})


def test_a_sweep_that_asks_for_too_much_is_told_what_there_is():
    with pytest.raises(ConfigError, match=r"no setting is known to be as good \(allowed: [0-9]+ % or more"):
        members({"tolerance": "0.5 %"})
    with pytest.raises(
        ConfigError, match=r"the mean of 3 packings is not known to be as good \(allowed: [0-9]+ % or more\)"
    ):
        members({"tolerance": "5 %"}, replicates=3)


def test_packings_that_a_tolerance_takes_count_as_cases(monkeypatch):
    monkeypatch.setattr("orthocut.params.study.MAX_CASES", 5)
    sweep = {"base": {**GLASS, "tolerance": "50 %"}}
    study = Study.model_validate({"title": "t", "sweeps": {"a": sweep}, "figures": {"energy_balance": ["a"]}})
    with pytest.raises(ConfigError, match=r"has 10 cases \(allowed: up to 5\)"):
        study.expand()
