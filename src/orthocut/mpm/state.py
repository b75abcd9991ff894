"""State of a cut with material points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orthocut.kernels.mpm import layout
from orthocut.kernels.mpm.frame import Cohesion, Frame, Solid, Usavg, Wedge


@dataclass
class State:
    """All that changes during a run, and the constants of the run.

    Attributes
    ----------
    points : float array
        Fields of all points in blocks of lanes, see `orthocut.kernels.mpm.layout`.
    blocks : int array, shape (2, 2)
        First block of each body (chip, base) and first block after it.
    interface : float array, shape (INTERFACE_ROWS, n_pairs)
        Cohesive pairs along the cutting path.
    totals : float array, shape (TOTALS,)
        Impulses and energies since the start, time and tool, see `orthocut.kernels.mpm.step`.
    solid, cohesion, wedge, frame
        Material, cohesive law, tool, grid.
    usavg : Usavg, optional
        Choices of the loop of `orthocut.kernels.mpm.usavg`, if the run uses it.
    """

    points: np.ndarray
    blocks: np.ndarray
    interface: np.ndarray
    totals: np.ndarray
    solid: Solid
    cohesion: Cohesion
    wedge: Wedge
    frame: Frame
    usavg: Usavg | None = None

    def field(self, index: int) -> np.ndarray:
        """One field of all points that have mass, shape (n_points,); a copy."""
        lanes = self.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)
        return lanes[:, index, :][lanes[:, layout.MASS, :] > 0.0]

    @property
    def point_count(self) -> int:
        """Number of points that have mass."""
        return self.field(layout.MASS).size
