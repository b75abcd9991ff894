"""Uniaxial tests of a specimen of bonded discs: loading, sampling, stop rule and results."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from orthocut.dem.packing import PackedDiscs
from orthocut.dem.state import Scene
from orthocut.experiments.dem_run import closure, crack_data, energy_data, packing_data, proceed, timing
from orthocut.io.datasets import build as build_dataset
from orthocut.measure.dem_cracks import count_cracks
from orthocut.measure.dem_energy import Energies, energies, forces
from orthocut.measure.specimen import elastic_constants, strains, stress_axial
from orthocut.params.dem import DemCompression, DemTension

SAMPLES = 200
"""Samples that a dataset holds; when they are full, every other one is dropped and the interval doubled."""
STRAIN_INTERVAL = 1e-5
"""Axial strain between samples at first."""
READINGS = 4
"""Readings of the stress in an interval, which are averaged."""

Progress = Callable[[float], None]
Test = DemTension | DemCompression


class Sample(NamedTuple):
    """One row of the history; tension is positive."""

    time: float
    strain_axial: float
    strain_gauge: float
    strain_lateral: float
    stress_axial: float
    stress_grip: float
    cracks_tension: int
    cracks_shear: int
    energies: Energies


def load_specimen(
    case: Test,
    packed: PackedDiscs,
    scene: Scene,
    sign: int,
    grip_force: Callable[[Scene], float],
    progress: Progress,
) -> tuple[list[Sample], Sample, np.ndarray, np.ndarray, float, Energies]:
    """Load until the stress has dropped to the stated fraction of its peak, or to the largest strain.

    Parameters
    ----------
    sign : int
        1 in tension, -1 in compression.
    grip_force : callable
        Reads the sum over steps of the pulling force on both ends since the last call, over two [N/m].

    Returns
    -------
    samples, sample of the largest stress (even if dropped from the samples), places at the start, fraction of intact
    elements at the end, CPU seconds in the solver, energies at the start
    """
    width, height = case.packing.width, case.packing.height
    initial = scene.places.copy()
    middle = np.abs(initial[:, 1] - 0.5 * height) < 0.25 * height
    rate = 2 * case.grip_speed / height
    proceed(scene, 0)
    reading = max(1, round(STRAIN_INTERVAL / rate / scene.time_step / READINGS))
    per_sample = READINGS
    advancing = 0.0
    samples: list[Sample] = []
    peak: Sample | None = None
    start = energies(scene)

    strain = 0.0
    while strain < case.strain_max:
        stresses = []
        for _ in range(per_sample):
            began = time.thread_time()
            proceed(scene, reading)
            advancing += time.thread_time() - began
            found = forces(scene)
            y = scene.places[:, 1]
            stresses.append(stress_axial(found, y, 0.25 * height, 0.75 * height, width))
        strain = rate * scene.time
        axial, lateral = strains(initial, scene.places, middle)
        grip = grip_force(scene) / (per_sample * reading) / width
        stress = float(np.mean(stresses))
        sample = Sample(
            scene.time,
            sign * strain,
            axial,
            lateral,
            stress,
            grip,
            *count_cracks(scene),
            energies(scene, found.energy),
        )
        samples.append(sample)
        if peak is None or sign * stress > sign * peak.stress_axial:
            peak = sample
        progress(min(strain / case.strain_max, 1.0))
        cracked = sample.cracks_tension + sample.cracks_shear > 0
        if cracked and sign * stress < case.drop_fraction * sign * peak.stress_axial:
            break
        if len(samples) == SAMPLES:
            samples = samples[1::2]
            per_sample *= 2
    progress(1.0)
    return samples, peak, initial, found.intact, advancing, start


def specimen_dataset(
    case: Test,
    title: str,
    packed: PackedDiscs,
    scene: Scene,
    sign: int,
    grip_force: Callable[[Scene], float],
    progress: Progress,
    began: float,
) -> xr.Dataset:
    """Load a specimen and return histories, results, discs at start and end, cracks and energies."""
    samples, peak, initial, intact, advancing, start = load_specimen(case, packed, scene, sign, grip_force, progress)
    column = {name: np.array([getattr(s, name) for s in samples], dtype=float) for name in Sample._fields[:-1]}
    loading = sign * column["stress_axial"]
    modulus, poisson = elastic_constants(loading, column["strain_gauge"], column["strain_lateral"])
    history: dict[str, Any] = {**column, **energy_data([s.energies for s in samples], start)}
    padding = np.full(SAMPLES - len(samples), np.nan)
    tension, shear = count_cracks(scene)

    data = {name: (("sample",), np.concatenate([values, padding])) for name, values in history.items()}
    data |= {
        "modulus_young": ((), modulus),
        "ratio_poisson": ((), poisson),
        "strength_ultimate": ((), sign * peak.stress_axial),
        "strain_peak": ((), peak.strain_gauge),
        "cracks_tension_total": ((), tension),
        "cracks_shear_total": ((), shear),
        "energy_closure": ((), closure(samples[-1].energies, start)),
        "time_snapshot": (("snapshot",), [0.0, scene.time]),
        "disc_x": (("snapshot", "disc"), [initial[:, 0], scene.places[:, 0]]),
        "disc_y": (("snapshot", "disc"), [initial[:, 1], scene.places[:, 1]]),
        "bond_intact": (("snapshot", "bond"), [np.ones_like(intact), intact]),
        **packing_data(packed, scene),
        **crack_data(scene),
    }
    dataset = build_dataset(case, title, data, {"time": data.pop("time")})
    dataset.attrs.update(timing(time.perf_counter() - began, advancing, scene))
    return dataset
