"""Solver of a cut with material points: work space and the call of the kernels."""

from __future__ import annotations

import numpy as np

from orthocut.kernels.mpm import interface, layout, points, step
from orthocut.mpm.state import State
from orthocut.params.cohesive import CohesiveZone
from orthocut.params.material import ElasticPlastic


class Solver:
    """Advances a state.

    Parameters
    ----------
    state : State
        Modified in place.
    material : ElasticPlastic
        Material of the workpiece.
    cohesive : CohesiveZone
        Interface along the cutting path.
    """

    def __init__(self, state: State, material: ElasticPlastic, cohesive: CohesiveZone) -> None:
        self.state = state
        self.material = np.array(
            [
                material.modulus_bulk,
                material.modulus_shear,
                material.stress_yield,
                material.modulus_plastic,
                material.density,
            ]
        )
        self.cohesive = np.array([cohesive.strength, cohesive.opening_critical])
        count_x, count_y = state.counts
        nodes = count_x * count_y
        self._grids = np.zeros((2, 2, nodes * layout.NODE))
        self._extents = np.zeros((2, 2, 4), dtype=np.int64)
        self._extents[..., 0] = self._extents[..., 2] = 0
        self._extents[..., 1] = self._extents[..., 3] = -1
        self._near = np.zeros((2, state.points.size // layout.POINT_FIELDS), dtype=np.int64)
        self._marked = np.zeros(nodes, dtype=np.int64)
        self._closing = np.zeros(nodes, dtype=np.int64)
        self._closing_normal = np.zeros((nodes, 2))
        self._closing_slot = np.full(nodes, -1, dtype=np.int64)
        self._work = np.zeros(points.WORK)
        self._parity = 0
        self._mass = float(state.field(layout.MASS).sum())
        self._extrapolate()

    def _extrapolate(self) -> None:
        """Fill the current grid from the points: a step of no duration from a grid at rest."""
        state = self.state
        for body in (layout.CHIP, layout.BASE):
            points.advance_points(
                state.points,
                state.blocks[body],
                self._grids[body, 1],
                self._grids[body, 0],
                self._work,
                self._extents[body, 0],
                self.material,
                0.0,
                *state.origin,
                1.0 / state.cell,
                *state.counts,
            )

    def advance(self, steps: int) -> None:
        """Advance by a number of steps."""
        state = self.state
        self._parity = step.run_steps(
            steps,
            state.points,
            state.blocks,
            self._grids,
            self._extents,
            state.interface,
            state.tool,
            state.totals,
            self.material,
            self.cohesive,
            self._near,
            self._marked,
            self._closing,
            self._closing_normal,
            self._closing_slot,
            self._work,
            state.time_step,
            state.cell,
            *state.origin,
            *state.counts,
            state.last_clamped_row,
            self._mass,
            self._parity,
        )

    def energies(self) -> tuple[float, float, float]:
        """Elastic energy, plastic work and kinetic energy of the points [J/m]."""
        return points.sum_energies(self.state.points, int(self.state.blocks[-1, -1]), self.material)

    @property
    def crack_tip(self) -> float:
        """Place of the broken pair farthest ahead [m]."""
        return float(interface.crack_tip_of(self.state.interface))

    @property
    def escaped(self) -> bool:
        """Whether a point stands so near the edge of the grid that its nodes would lie outside."""
        state = self.state
        for body in (layout.CHIP, layout.BASE):
            low_x, high_x, low_y, high_y = self._extents[body, self._parity]
            if min(low_x, low_y) < 1 or high_x > state.counts[0] - 2 or high_y > state.counts[1] - 2:
                return True
        return False
