"""Brazilian disc: shape of the specimen, agreement of both stresses, tension across the middle, splitting."""

import math

import numpy as np
import pytest

from orthocut.dem.packing import pack
from orthocut.experiments import dem_brazilian, dem_tension
from orthocut.experiments.dem_platens import between_platens
from orthocut.experiments.dem_run import proceed
from orthocut.measure.dem_energy import forces
from orthocut.params.case import load
from orthocut.variables import VARIABLES

ROUND = {"packing.width": "0.5 mm", "packing.height": "0.5 mm", "grip_speed": "10 mm/s"}
TENSILE = {"strength_tensile": "60 MPa", "cohesion": "200 MPa"}


@pytest.fixture(scope="module")
def split():
    return dem_brazilian.simulate(load("dem_brazilian", {**ROUND, **TENSILE}), lambda fraction: None)


def test_specimen_is_round_between_two_flats():
    case = load("dem_brazilian", {**ROUND, "flat_ratio": 0.4})
    packed = pack(case.packing)
    kept = dem_brazilian.select_discs(case, packed)
    x, y = packed.x[kept] - 0.25e-3, packed.y[kept] - 0.25e-3
    half = case.diameter / 2
    solid = np.pi * np.sum(packed.radius[kept] ** 2) / (1 - packed.porosity)
    angle = math.asin(0.4)
    area = half**2 * (math.pi - 2 * angle + math.sin(2 * angle))
    assert case.diameter == pytest.approx(0.5e-3 - 4e-5)
    assert solid == pytest.approx(area, rel=0.03)
    assert np.hypot(x, y).max() <= half
    assert (np.abs(y) + packed.radius[kept]).max() <= half * math.cos(angle)


def test_both_stresses_agree_until_it_splits(split):
    stress, grip = -split.stress_axial.values, -split.stress_grip.values
    peak = int(np.nanargmax(stress))
    loaded = np.flatnonzero(stress[: peak + 1] > 0.3 * stress[peak])
    assert len(loaded) > 20
    assert grip[loaded] == pytest.approx(stress[loaded], rel=0.02)


def test_it_splits_along_the_loaded_diameter_at_about_the_tensile_strength(split):
    assert set(split.variables) <= set(VARIABLES)
    before = split.crack_time.values <= split.time.values[int(np.nanargmin(split.stress_axial.values))] * 1.05
    assert int(split.cracks_tension_total) > 10 * int(split.cracks_shear_total)
    middle = split.disc_x.values[0].mean()
    near = np.abs(split.crack_x.values[before] - middle) < 0.25 * load("dem_brazilian", ROUND).diameter
    assert near.mean() > 0.8
    pull = {"packing.width": "0.5 mm", "packing.height": "1 mm", "grip_speed": "10 mm/s"}
    direct = dem_tension.simulate(load("dem_tension", {**pull, **TENSILE}), lambda fraction: None, None, 0)
    assert 0.6 < float(split.strength_ultimate) / float(direct.strength_ultimate) < 1.4


def test_tension_across_the_middle_is_that_of_an_elastic_disc():
    case = load(
        "dem_brazilian", {**ROUND, "strength_tensile": "100 GPa", "cohesion": "100 GPa", "grip_speed": "2 mm/s"}
    )
    packed = pack(case.packing)
    kept = dem_brazilian.select_discs(case, packed)
    scene = between_platens(case, packed.x[kept], packed.y[kept], packed.radius[kept])
    proceed(scene, 40_000)
    found, centre = forces(scene), scene.places.mean(axis=0)
    assert scene.cracks.count[0] == 0

    def stress(axis, half):
        """Mean normal stress in a square around the centre; forces count with the part of their branch inside."""
        inside = np.clip(scene.places, centre - half, centre + half)
        branch = inside[found.second, axis] - inside[found.first, axis]
        middle = 0.5 * (scene.places[found.first, 1 - axis] + scene.places[found.second, 1 - axis])
        within = np.abs(middle - centre[1 - axis]) < half
        return float(np.sum((found.force[:, axis] * branch)[within]) / (2 * half) ** 2)

    half = 0.12 * case.diameter
    low, high = centre[1] - 0.1 * case.diameter, centre[1] + 0.1 * case.diameter
    rows = np.clip(scene.places[:, 1], low, high)
    load_down = -np.sum(found.force[:, 1] * (rows[found.second] - rows[found.first])) / (high - low)
    splitting = 2 * load_down / (math.pi * case.diameter)
    assert stress(0, half) / splitting == pytest.approx(0.93, abs=0.12)
    assert -stress(1, half) / splitting == pytest.approx(2.9, abs=0.35)
