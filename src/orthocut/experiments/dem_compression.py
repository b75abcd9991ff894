"""Unconfined compression of a specimen of bonded discs (Yang et al. 2018, section 3.2)."""

from __future__ import annotations

import xarray as xr

from orthocut.dem.packing import PackedDiscs
from orthocut.dem.setup import build, wall
from orthocut.dem.state import Scene
from orthocut.experiments.dem_specimen import Progress, specimen_dataset
from orthocut.experiments.packing_shelf import packed_discs
from orthocut.io.checkpoint import Checkpoint
from orthocut.kernels.dem.layout import WALL_SUM_Y
from orthocut.params.dem import DemCompression


def make_scene(case: DemCompression, packed: PackedDiscs) -> Scene:
    """Specimen between two rigid platens that just touch it and close at the same speed.

    All discs start with the velocity of uniform shortening, so that no wave runs through the specimen.
    """
    speed, friction, modulus = case.grip_speed, case.friction_platen, case.joint.modulus
    low = float((packed.y - packed.radius).min())
    high = float((packed.y + packed.radius).max())
    up, down = (0.0, 1.0), (0.0, -1.0)
    platens = [
        wall((0.0, low), (up, up), (0.0, speed), friction, modulus),
        wall((0.0, high), (down, down), (0.0, -speed), friction, modulus),
    ]
    scene = build(packed.x, packed.y, packed.radius, case.joint, walls=platens)
    scene.speeds[:, 1] = speed * (1 - 2 * (packed.y - low) / (high - low))
    return scene


def read_platens(scene: Scene) -> float:
    """Sum over steps of the pulling force, mean of both platens, since the last call [N/m]; negative in compression."""
    rows = scene.walls.rows
    total = 0.5 * float(rows[0, WALL_SUM_Y] - rows[1, WALL_SUM_Y])
    rows[:, WALL_SUM_Y] = 0.0
    return total


def simulate(
    case: DemCompression, progress: Progress, checkpoint: Checkpoint | None = None, snapshots: int = 2
) -> xr.Dataset:
    """Crush a specimen; see `orthocut.variables` for what the dataset holds. Snapshots are start and end."""
    discs = packed_discs(case.packing, checkpoint)
    scene = make_scene(case, discs)
    title = "Unconfined compression of bonded discs"
    return specimen_dataset(case, title, discs, scene, -1, read_platens, progress, checkpoint, snapshots)
