"""Tests of a specimen of bonded discs along y: loading, sampling, stop rule and results."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from orthocut.dem.packing import PackedDiscs
from orthocut.dem.state import Scene
from orthocut.experiments.dem_run import closure, energy_data, field_data, packing_data, proceed, timing
from orthocut.io.checkpoint import Checkpoint, packed, unpacked
from orthocut.io.datasets import build as build_dataset
from orthocut.measure.dem_cracks import count_cracks
from orthocut.measure.dem_energy import Energies, energies, forces
from orthocut.measure.dem_watch import watch
from orthocut.measure.specimen import elastic_constants, strains, stress_axial
from orthocut.params.dem import DemBrazilian, DemCompression, DemTension

SAMPLES = 200
"""Samples that a dataset holds; when they are full, every other one is dropped and the interval doubled."""
STRAIN_INTERVAL = 1e-5
"""Axial strain between samples at first."""
READINGS = 4
"""Readings of the stress in an interval, which are averaged."""

Progress = Callable[[float], None]
Test = DemTension | DemCompression | DemBrazilian


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


@dataclass
class Loading:
    """What a test has gathered so far."""

    samples: list[Sample] = field(default_factory=list)
    peak: Sample | None = None
    """Sample of the largest stress, even if dropped from the samples."""
    per_sample: int = READINGS
    """Readings in an interval."""
    strain: float = 0.0
    advancing: float = 0.0
    """CPU time of the steps [s]."""

    def freeze(self) -> dict[str, np.ndarray]:
        """Everything, as arrays."""
        rows = [[*sample[:-1], *sample.energies] for sample in [self.peak, *self.samples]]
        return {"rows": np.array(rows), "numbers": np.array([self.per_sample, self.strain, self.advancing])}

    @classmethod
    def thaw(cls, frozen: Mapping[str, np.ndarray]) -> Loading:
        """Return what `freeze` took."""
        last = len(Sample._fields) - 1
        peak, *samples = (Sample(*row[:last], Energies(*row[last:])) for row in frozen["rows"].tolist())
        per_sample, strain, advancing = frozen["numbers"].tolist()
        return cls(samples, peak, int(per_sample), strain, advancing)

    def add(self, sample: Sample, sign: int) -> None:
        """Add a sample."""
        self.samples.append(sample)
        if self.peak is None or sign * sample.stress_axial > sign * self.peak.stress_axial:
            self.peak = sample

    def thin(self) -> None:
        """When there are too many samples, drop every other one and double the interval."""
        if len(self.samples) == SAMPLES:
            self.samples = self.samples[1::2]
            self.per_sample *= 2


def load_specimen(
    case: Test,
    scene: Scene,
    sign: int,
    grip_force: Callable[[Scene], float],
    progress: Progress,
    checkpoint: Checkpoint | None,
    section: float,
    start: Energies,
) -> tuple[Loading, np.ndarray]:
    """Load until the stress has dropped to the stated fraction of its peak, or to the largest strain.

    Parameters
    ----------
    sign : int
        1 in tension, -1 in compression.
    grip_force : callable
        Reads the sum over steps of the pulling force on both ends since the last call, over two [N/m].
    checkpoint : Checkpoint, optional
        Where the run goes on from, and leaves its state now and then.
    section : float
        What forces are divided by to give stresses, for unit width [m].
    start : Energies
        Energy balance before the first step.

    Returns
    -------
    what was gathered, fraction of intact elements at the end
    """
    height = case.packing.height
    initial = scene.places.copy()
    middle = np.abs(initial[:, 1] - 0.5 * height) < 0.25 * height
    rate = 2 * case.grip_speed / height
    reading = max(1, round(STRAIN_INTERVAL / rate / scene.time_step / READINGS))
    loading = _restore(scene, checkpoint) or Loading()

    while loading.strain < case.strain_max:
        stresses = []
        for _ in range(loading.per_sample):
            began = time.thread_time()
            proceed(scene, reading)
            loading.advancing += time.thread_time() - began
            found = forces(scene)
            y = scene.places[:, 1]
            stresses.append(stress_axial(found, y, 0.25 * height, 0.75 * height, section))
        loading.strain = rate * scene.time
        sample = Sample(
            scene.time,
            sign * loading.strain,
            *strains(initial, scene.places, middle),
            float(np.mean(stresses)),
            grip_force(scene) / (loading.per_sample * reading) / section,
            *count_cracks(scene),
            energies(scene, found.energy),
        )
        watch(scene, sample.energies, start)
        loading.add(sample, sign)
        progress(min(loading.strain / case.strain_max, 1.0))
        cracked = sample.cracks_tension + sample.cracks_shear > 0
        if cracked and sign * sample.stress_axial < case.drop_fraction * sign * loading.peak.stress_axial:
            break
        loading.thin()
        if checkpoint:
            checkpoint.offer(lambda: packed("scene", scene.freeze()) | packed("loading", loading.freeze()))
    progress(1.0)
    return loading, forces(scene).intact


def _restore(scene: Scene, checkpoint: Checkpoint | None) -> Loading | None:
    """Bring a scene to the last checkpoint, if there is one; return what was gathered until then."""
    saved = checkpoint.restore() if checkpoint else None
    if saved is None:
        return None
    scene.thaw(unpacked("scene", saved))
    return Loading.thaw(unpacked("loading", saved))


def specimen_dataset(
    case: Test,
    title: str,
    discs: PackedDiscs,
    scene: Scene,
    sign: int,
    grip_force: Callable[[Scene], float],
    progress: Progress,
    checkpoint: Checkpoint | None,
    snapshots: int,
    section: float | None = None,
) -> xr.Dataset:
    """Load a specimen and return histories, results, energies and, if snapshots are wanted, discs and cracks.

    Parameters are those of `load_specimen`; the section is the width of the packing unless it is given.
    """
    initial, joined = scene.places.copy(), forces(scene).intact
    proceed(scene, 0)
    start = energies(scene)
    section = section or case.packing.width
    done, intact = load_specimen(case, scene, sign, grip_force, progress, checkpoint, section, start)
    samples = done.samples
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
        "strength_ultimate": ((), sign * done.peak.stress_axial),
        "strain_peak": ((), done.peak.strain_gauge),
        "cracks_tension_total": ((), tension),
        "cracks_shear_total": ((), shear),
        "energy_closure": ((), closure(samples[-1].energies, start)),
        **packing_data(discs, scene),
    }
    if snapshots:
        data |= {
            "time_snapshot": (("snapshot",), [0.0, scene.time]),
            "disc_x": (("snapshot", "disc"), [initial[:, 0], scene.places[:, 0]]),
            "disc_y": (("snapshot", "disc"), [initial[:, 1], scene.places[:, 1]]),
            "bond_intact": (("snapshot", "bond"), [joined, intact]),
            **field_data(scene),
        }
    dataset = build_dataset(case, title, data, {"time": data.pop("time")})
    dataset.attrs.update(timing(done.advancing, scene))
    return dataset
