"""Uniaxial tension of a specimen of bonded discs (Yang et al. 2018, section 3.1).

Stress is measured in the middle half of the height over the whole width of the packing, and by the reaction of the
grips; strains are slopes of the displacements of the discs there. Young's modulus E and Poisson's ratio come from
the samples between 10 and 50 % of the peak before it (`orthocut.measure.specimen.elastic_constants`); the tensile
strength (UTS, ``strength_ultimate``) is the largest stress.
"""

from __future__ import annotations

import numpy as np
import xarray as xr

from orthocut.dem.packing import PackedDiscs
from orthocut.dem.setup import build
from orthocut.dem.state import Scene
from orthocut.experiments.dem_specimen import Progress, specimen_dataset
from orthocut.experiments.packing_shelf import packed_discs
from orthocut.io.checkpoint import Checkpoint
from orthocut.params.dem import DemTension

BOTTOM, TOP = 0, 1


def make_scene(case: DemTension, packed: PackedDiscs) -> Scene:
    """Specimen with a driven row of discs at either end, moving apart without spin.

    All discs start with the velocity of uniform stretching, so that no wave runs through the specimen.
    """
    height = case.packing.height
    top = packed.y > (1 - case.grip_ratio) * height
    bottom = packed.y < case.grip_ratio * height
    driven = np.flatnonzero(top | bottom)
    scene = build(
        packed.x, packed.y, packed.radius, case.joint, driven=driven, group=np.where(top[driven], TOP, BOTTOM)
    )
    scene.speeds[:, 1] = case.grip_speed * (2 * packed.y / height - 1)
    scene.speeds[top, 1] = case.grip_speed
    scene.speeds[bottom, 1] = -case.grip_speed
    return scene


def read_grips(scene: Scene) -> float:
    """Sum over steps of the pulling force, mean of both grips, since the last call [N/m]."""
    total = 0.5 * float(scene.reaction[2 * BOTTOM + 1] - scene.reaction[2 * TOP + 1])
    scene.reaction[:] = 0.0
    return total


def simulate(
    case: DemTension, progress: Progress, checkpoint: Checkpoint | None = None, snapshots: int = 2
) -> xr.Dataset:
    """Pull a specimen apart; see `orthocut.variables` for what the dataset holds. Snapshots are start and end."""
    discs = packed_discs(case.packing, checkpoint)
    scene = make_scene(case, discs)
    title = "Uniaxial tension of bonded discs"
    return specimen_dataset(case, title, discs, scene, 1, read_grips, progress, checkpoint, snapshots)
