"""Elastic energy of contacts with walls."""

from orthocut.kernels.dem.layout import (
    FIRST_X,
    FIRST_Y,
    ROW,
    SECOND_X,
    SECOND_Y,
    TIP_X,
    TIP_Y,
    WALL_STIFFNESS,
)
from orthocut.kernels.dem.walls import wedge_distance
from orthocut.kernels.jit import jit


@jit
def measure_walls(walls, shear, start, disc, position, radius, stiffness_ratio):
    """Elastic energy of all contacts with walls [J/m]."""
    total = 0.0
    for w in range(walls.shape[0]):
        stiffness = walls[w, WALL_STIFFNESS]
        for c in range(start[w], start[w + 1]):
            m = disc[c]
            distance, _, _ = wedge_distance(
                position[m * ROW] - walls[w, TIP_X], position[m * ROW + 1] - walls[w, TIP_Y],
                walls[w, FIRST_X], walls[w, FIRST_Y], walls[w, SECOND_X], walls[w, SECOND_Y],
            )  # fmt: skip
            gap = distance - radius[m]
            if gap < 0.0:
                own = shear[w, m]
                total += 0.5 * (stiffness * gap * gap + own * own * stiffness_ratio / stiffness)
    return total
