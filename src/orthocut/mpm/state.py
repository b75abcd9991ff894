"""Arrays of a cut with material points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orthocut.kernels.mpm import layout


@dataclass
class State:
    """All that changes during a run, and the geometry of the grid.

    Attributes
    ----------
    points : float array
        Fields of all points in blocks of lanes, see `orthocut.kernels.mpm.layout`.
    blocks : int array, shape (2, 2)
        First block of each body (chip, base) and first block after it.
    interface : float array, shape (INTERFACE_ROWS, n_pairs)
        Cohesive pairs along the cutting path.
    tool : float array, shape (TOOL,)
        Angles, friction, tip, speed, ramp.
    totals : float array, shape (TOTALS,)
        Impulses and energies since the start.
    cell : float
        Cell size [m].
    origin : tuple of float
        Position of node (0, 0) [m].
    counts : tuple of int
        Number of nodes in x and y.
    last_clamped_row : int
        Rows of nodes up to this one are clamped.
    time_step : float
        Time step [s].
    """

    points: np.ndarray
    blocks: np.ndarray
    interface: np.ndarray
    tool: np.ndarray
    totals: np.ndarray
    cell: float
    origin: tuple[float, float]
    counts: tuple[int, int]
    last_clamped_row: int
    time_step: float

    def field(self, index: int) -> np.ndarray:
        """One field of all points that have mass, shape (n_points,); a copy."""
        lanes = self.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)
        return lanes[:, index, :][lanes[:, layout.MASS, :] > 0.0]

    @property
    def point_count(self) -> int:
        """Number of points that have mass."""
        return self.field(layout.MASS).size
