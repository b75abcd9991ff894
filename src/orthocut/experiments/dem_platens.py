"""Two rigid platens that close on a specimen of bonded discs, and the force on them."""

from __future__ import annotations

import numpy as np

from orthocut.dem.setup import build, wall
from orthocut.dem.state import Scene
from orthocut.kernels.dem.layout import WALL_SUM_Y
from orthocut.params.dem import DemBrazilian, DemCompression


def between_platens(case: DemCompression | DemBrazilian, x: np.ndarray, y: np.ndarray, radius: np.ndarray) -> Scene:
    """Specimen between two rigid platens that just touch it and close at the same speed.

    All discs start with the velocity of uniform shortening, so that no wave runs through the specimen.

    Parameters
    ----------
    case : DemCompression or DemBrazilian
    x, y, radius : float arrays, shape (n_discs,)
        Discs of the specimen [m].
    """
    speed, friction, modulus = case.grip_speed, case.friction_platen, case.joint.modulus
    low, high = float((y - radius).min()), float((y + radius).max())
    up, down = (0.0, 1.0), (0.0, -1.0)
    platens = [
        wall((0.0, low), (up, up), (0.0, speed), friction, modulus),
        wall((0.0, high), (down, down), (0.0, -speed), friction, modulus),
    ]
    scene = build(x, y, radius, case.joint, walls=platens)
    scene.speeds[:, 1] = speed * (1 - 2 * (y - low) / (high - low))
    return scene


def read_platens(scene: Scene) -> float:
    """Sum over steps of the pulling force, mean of both platens, since the last call [N/m]; negative in compression."""
    rows = scene.walls.rows
    total = 0.5 * float(rows[0, WALL_SUM_Y] - rows[1, WALL_SUM_Y])
    rows[:, WALL_SUM_Y] = 0.0
    return total
