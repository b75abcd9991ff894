"""Calibration against packings whose properties are known functions of the parameters; input, outputs, the verb."""

import csv
import json

import numpy as np
import pytest
import xarray as xr
import yaml
from typer.testing import CliRunner

from orthocut.calibration.fit import deviations, fit
from orthocut.calibration.outcome import joint_yaml, save
from orthocut.calibration.trial import FITTED, REACHED, cases_of, goal_of, start_of
from orthocut.cli import app
from orthocut.io.netcdf import read
from orthocut.params.block import ConfigError
from orthocut.params.calibration import load_calibration
from orthocut.params.case import load
from orthocut.variables import VARIABLES

SLOPES = np.array([[1.0, -0.25, 0.0, 0.0], [0.0, 0.7, 0.0, 0.0], [0.0, -0.1, 0.9, 0.1], [0.0, 0.0, 0.4, 0.6]])
AT_START = np.array([95e9, 0.22, 110e6, 290e6])


class Glass:
    """Packings whose properties are powers of the parameters, each with a scatter of its own."""

    def __init__(self, calibration, scatter=0.0):
        self.start, self.seeds = start_of(calibration), []
        self.scatter = scatter * np.random.default_rng(3).normal(size=(calibration.replicates, 4))
        self.seen = []

    def __call__(self, cases):
        self.seen.append(cases)
        return [self.run(case) for case in cases]

    def run(self, case):
        parameters = np.array([getattr(case.joint, name) for name in FITTED])
        logs = SLOPES @ np.log(parameters / self.start) + self.scatter[case.packing.seed - 1]
        young, poisson, tension, compression = AT_START * np.exp(logs)
        strength = tension if case.kind == "dem_tension" else compression
        values = {"modulus_young": young, "ratio_poisson": poisson, "strength_ultimate": strength}
        return xr.Dataset({name: ((), value) for name, value in values.items()})


def calibrate(scatter=0.0, **values):
    calibration = load_calibration(values=values)
    glass, seen = Glass(calibration, scatter), []
    return calibration, glass, fit(calibration, glass, seen.append), seen


def test_known_powers_are_found_within_the_tolerance_in_few_evaluations():
    calibration, glass, found, seen = calibrate(tolerance=0.01)
    best = found.trials[found.best]
    assert found.converged
    assert np.abs(deviations(best, goal_of(calibration))).max() <= 0.01
    searched = [trial for trial in found.trials if trial.purpose == "search"]
    assert len(searched) < 15
    assert len(found.trials) == len(seen) == len(glass.seen) == len(searched) + 8
    assert found.slopes == pytest.approx(SLOPES, abs=2e-3)


def test_errors_are_those_of_a_fit_to_each_packing_alone():
    calibration, glass, found, _ = calibrate(scatter=0.05)
    alone = -np.linalg.solve(SLOPES, glass.scatter.T).T
    assert found.spread == pytest.approx(alone.std(axis=0, ddof=1), rel=0.02)
    assert found.error == pytest.approx(found.spread / np.sqrt(calibration.replicates))


def test_all_evaluations_use_the_same_packings_and_change_nothing_but_the_fitted_fields():
    calibration, glass, _, _ = calibrate(**{"joint.fraction_slit": 0.1, "packing.seed": 1, "replicates": 3})
    packings = [[case.packing for case in cases] for cases in glass.seen]
    assert all(one == packings[0] for one in packings)
    assert [packing.seed for packing in packings[0]] == [1, 1, 2, 2, 3, 3]
    for case in glass.seen[-1]:
        kept = set(type(case.joint).model_fields) - set(FITTED)
        assert all(getattr(case.joint, name) == getattr(calibration.joint, name) for name in kept)
        assert load(case.kind, {}).drop_fraction == case.drop_fraction


def test_uncertainty_is_left_out_if_not_wanted(tmp_path):
    calibration, _, found, _ = calibrate(uncertainty=False)
    assert all(trial.purpose == "search" for trial in found.trials)
    assert np.isnan([*found.slopes.ravel(), *found.spread, *found.error]).all()
    assert len(save(calibration, found, tmp_path)) == 8


def test_search_that_may_not_go_on_says_so():
    _, _, found, _ = calibrate(evaluations=1)
    assert not found.converged
    assert sum(trial.purpose == "search" for trial in found.trials) == 1


def test_parameters_have_as_many_digits_as_are_printed():
    calibration, _, found, _ = calibrate()
    best = found.trials[found.best].parameters
    assert [float(f"{value:.4g}") for value in best] == best.tolist()
    block = yaml.safe_load(joint_yaml(calibration, found))
    assert load("dem_tension", {"joint": block["joint"]}).joint == cases_of(calibration, best)[0].joint


def test_outcome_is_a_dataset_and_tables_of_it(tmp_path):
    calibration, _, found, _ = calibrate(scatter=0.02)
    paths = save(calibration, found, tmp_path)
    assert {path.name for path in paths} == {path.name for path in tmp_path.iterdir()}
    data = read(tmp_path / "calibration.nc")
    assert set(data.variables) <= set(VARIABLES)
    assert data["modulus_young"].shape == (len(found.trials), calibration.replicates)
    best = int(data["fit_evaluation"])
    for k, name in enumerate(REACHED):
        assert float(data[name][best].mean()) == pytest.approx(goal_of(calibration)[k], rel=calibration.tolerance * 1.1)
    rows = list(csv.DictReader((tmp_path / "parameters.csv").open()))
    assert [float(row["fitted"]) for row in rows] == pytest.approx(
        [float(data[f"joint_{name}"][best]) * VARIABLES[f"joint_{name}"].scale for name in FITTED], rel=1e-5
    )
    assert len(list(csv.reader((tmp_path / "evaluations.csv").open()))) == 1 + len(found.trials)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"modulus_young": "71 mm"}, r"modulus_young = '71 mm': is not a quantity in GPa \(allowed: 1 MPa to 10 TPa"),
        ({"replicates": 1}, r"replicates = 1: is out of range \(allowed: 2 to 100\)"),
        ({"joint.cohesian": "1 MPa"}, r"joint\.cohesian.*did you mean joint\.cohesion"),
        ({"joint.fraction_slit": 2}, r"joint\.fraction_slit = 2: .*allowed: 0 to 1"),
        ({"tolerance": 0}, r"tolerance = 0: is out of range"),
    ],
)
def test_faulty_fields_are_refused_with_what_is_allowed(values, message):
    with pytest.raises(ConfigError, match=message):
        load_calibration(values=values)


TINY = """
packing: {width: 0.2 mm, height: 0.3 mm}
replicates: 2
tolerance: 0.2
evaluations: 1
joint: {strength_tensile: 40 MPa, cohesion: 60 MPa}
speed_tension: 100 mm/s
speed_compression: 100 mm/s
"""


def test_verb_repeats_from_the_store_and_says_when_goals_are_missed(tmp_path):
    (tmp_path / "tiny.yaml").write_text(TINY)
    command = ["calibrate", str(tmp_path / "tiny.yaml"), "--store", str(tmp_path / "store"), "--json"]
    outcomes = [CliRunner().invoke(app, [*command, "--output", str(tmp_path / name)]) for name in ("first", "again")]
    first, again = (json.loads(outcome.stdout) for outcome in outcomes)
    assert [outcome.exit_code for outcome in outcomes] == [1, 1]
    assert "% off its goal (allowed: tolerance = 20 %)" in outcomes[0].stderr
    assert first["parameters"] == again["parameters"]
    assert first["properties"] == again["properties"]
    told = [json.loads(line) for line in (tmp_path / "again" / "progress.jsonl").read_text().splitlines()]
    assert {row["event"] for row in told} == {"done"}
    assert len(told) == 9 * 2 * 2
    assert len(list((tmp_path / "store" / "packings").iterdir())) == 2


@pytest.mark.parametrize("setting", ["tolerance", "=1", "tolerance=0.1 --set tolerance=0.2"])
def test_settings_of_the_verb_must_be_assignments(setting, tmp_path):
    parts = [part for text in setting.split(" --set ") for part in ("--set", text)]
    outcome = CliRunner().invoke(app, ["calibrate", *parts, "--output", str(tmp_path / "new")])
    assert outcome.exit_code == 2
    assert "must read field=value" in outcome.stderr
    assert not (tmp_path / "new").exists()
