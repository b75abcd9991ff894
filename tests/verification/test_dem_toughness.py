"""Plate with a central crack: which joints are cut, energy release, how toughness goes with discs and strength."""

import numpy as np
import pytest

from orthocut.dem.joint_kinds import SLIT
from orthocut.dem.packing import pack
from orthocut.experiments import dem_tension, dem_toughness
from orthocut.params.block import ConfigError
from orthocut.params.case import load
from orthocut.variables import VARIABLES

SMALL = {"packing.width": "0.5 mm", "packing.height": "1 mm", "grip_speed": "10 mm/s"}
STRONG = {"strength_tensile": "100 GPa", "cohesion": "100 GPa", "strain_max": 3e-4}
TENSILE = {"strength_tensile": "60 MPa", "cohesion": "200 MPa"}


def simulated(**values):
    return dem_toughness.simulate(load("dem_toughness", {**SMALL, **values}), lambda fraction: None)


def test_only_joints_across_the_crack_are_cut():
    case = load("dem_toughness", {**SMALL, "crack_ratio": 0.4})
    scene = dem_toughness.make_scene(case, pack(case.packing))
    slit = scene.joints.kind == SLIT
    ends = [scene.places[disc // 4] for disc in (scene.joints.first[slit], scene.joints.second[slit])]
    assert np.all((ends[0][:, 1] - 0.5e-3) * (ends[1][:, 1] - 0.5e-3) < 0)
    x = 0.5 * (ends[0][:, 0] + ends[1][:, 0])
    assert np.abs(x - 0.25e-3).max() < 0.1e-3 + 1e-5
    # a line through a dense packing crosses one or two joints a disc
    assert 0.2e-3 / 2e-5 < slit.sum() < 3 * 0.2e-3 / 1.5e-5
    assert scene.joints.broken.sum() > 0
    assert (slit == 0).sum() > 20 * slit.sum()


def test_energy_release_is_that_of_the_stress_intensity():
    """At fixed grips a longer crack leaves less energy: K from the stress and from the energy agree within 12 %."""
    young = float(dem_tension.simulate(load("dem_tension", {**SMALL, **STRONG}), lambda fraction: None).modulus_young)
    runs = {ratio: simulated(**STRONG, crack_ratio=ratio) for ratio in (0.2, 0.4, 0.6)}
    assert len({float(run.strain_axial.max()) for run in runs.values()}) == 1
    energy = {ratio: float(np.nanmax(run.energy_elastic.values)) for ratio, run in runs.items()}
    released = (energy[0.2] - energy[0.6]) / (0.4 * 0.5e-3)
    assert (released * young) ** 0.5 == pytest.approx(float(runs[0.4].toughness_fracture), rel=0.12)


def test_toughness_goes_with_strength_and_the_root_of_the_size_of_discs():
    run = simulated(**TENSILE)
    assert set(run.variables) <= set(VARIABLES)
    toughness = float(run.toughness_fracture)
    twice = {"strength_tensile": "120 MPa", "cohesion": "400 MPa"}
    assert float(simulated(**twice).toughness_fracture) == pytest.approx(2 * toughness, rel=0.1)
    scaled = {"packing.width": "2 mm", "packing.height": "4 mm", "packing.radius_min": "30 um"}
    large = simulated(**TENSILE, **scaled)
    assert float(large.toughness_fracture) == pytest.approx(2 * toughness, rel=1e-6)


def test_a_crack_shorter_than_four_discs_is_refused():
    with pytest.raises(ConfigError, match=r"crack_ratio = 0\.1 is a crack of 0\.05 mm \(allowed: 0\.16 or more"):
        load("dem_toughness", {**SMALL, "crack_ratio": 0.1})
