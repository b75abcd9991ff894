"""Solver of a cut with material points: work space and the call of the kernels."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from orthocut.kernels.mpm import interface, layout, points, rest, step, support, usavg
from orthocut.kernels.mpm.frame import Workspace
from orthocut.mpm.state import State

_LINE = 64  # bytes of a cache line


def _aligned_zeros(*shape: int) -> np.ndarray:
    """Zeros that start at a cache line, so that each node fills one."""
    size = int(np.prod(shape))
    raw = np.zeros(size + _LINE // 8)
    start = -raw.ctypes.data % _LINE // 8
    return raw[start : start + size].reshape(shape)


class Solver:
    """Advances a state.

    Parameters
    ----------
    state : State
        Modified in place.
    """

    def __init__(self, state: State) -> None:
        self.state = state
        nodes = state.frame.count_x * state.frame.count_y
        lanes = state.points.size // layout.POINT_FIELDS
        self._grids = _aligned_zeros(2, 3 if state.usavg else 2, nodes * layout.NODE)
        self._extents = np.tile(np.array([0, -1, 0, -1]), (2, 2, 1))
        self._space = Workspace(
            lanes=_aligned_zeros(layout.WORK),
            near=np.zeros((2, lanes), dtype=np.int64),
            marked=np.zeros((2, nodes), dtype=np.int64),
            listed=np.zeros(nodes, dtype=np.int64),
            tool_nodes=np.zeros(nodes, dtype=np.int64),
            tool_sums=np.zeros((nodes, 3)),
            body_sums=np.zeros((nodes, 2)),
            closing=np.zeros(nodes, dtype=np.int64),
            closing_normal=np.zeros((nodes, 2)),
            closing_impulse=np.zeros((nodes, 2)),
            closing_slot=np.full(nodes, -1, dtype=np.int64),
            loose=np.zeros((2, nodes), dtype=np.int64),
            loose_weights=np.zeros((2, nodes, support.DIRECTIONS)),
            moves=_aligned_zeros(2 * lanes),
        )
        self._current = 0
        self._awake = np.vstack([state.blocks[:, [1, 1]], [2 * [state.interface.shape[1]]]])
        self._free = np.tile([0, state.frame.count_x - 1, 0, state.frame.count_y - 1], (2, 1))
        self._free[layout.BASE, 2] = state.frame.last_clamped_row + 1
        self._rest()
        self._mass = float(state.field(layout.MASS).sum())
        for body in (layout.CHIP, layout.BASE):  # a step of no duration fills the current grid
            points.advance_points(
                state.points,
                self._awake[body],
                self._grids[body, 1],
                self._grids[body, 0],
                self._space.lanes,
                self._extents[body, 0],
                state.solid,
                state.frame,
                0.0,
            )

    def _rest(self) -> None:
        """Let material far from the tool rest."""
        state = self.state
        tip = state.totals[step.TIP]
        state.totals[step.RESTED] = tip
        rest.wake_ahead(state.points, state.blocks, self._awake, tip, state.frame)
        rest.rest_behind(
            state.points,
            state.blocks,
            state.interface[interface.UPPER_X],
            self._awake,
            self._free,
            tip,
            state.frame,
        )

    def advance(self, steps: int) -> None:
        """Advance by a number of steps."""
        state = self.state
        if state.usavg:
            usavg.run_steps_usavg(
                steps,
                state.points,
                state.blocks,
                self._free,
                self._grids,
                self._extents,
                state.interface,
                state.totals,
                state.usavg,
                state.solid,
                state.cohesion,
                state.wedge,
                state.frame,
                self._space,
                self._mass,
            )
            return
        self._current = step.run_steps(
            steps,
            state.points,
            state.blocks,
            self._awake,
            self._free,
            self._grids,
            self._extents,
            self._current,
            state.interface,
            state.totals,
            state.solid,
            state.cohesion,
            state.wedge,
            state.frame,
            self._space,
            self._mass,
        )

    def freeze(self) -> dict[str, np.ndarray]:
        """Everything that changes from step to step, by name; views, except for the index of the current grid."""
        state = self.state
        return {
            "points": state.points,
            "interface": state.interface,
            "totals": state.totals,
            "grids": self._grids,
            "extents": self._extents,
            "awake": self._awake,
            "free": self._free,
            "current": np.array(self._current),
        }

    def thaw(self, frozen: Mapping[str, np.ndarray]) -> None:
        """Take over what `freeze` of a solver of the same case returned."""
        for name, values in self.freeze().items():
            np.copyto(values, frozen[name])
        self._current = int(frozen["current"])

    def energies(self) -> np.ndarray:
        """Elastic energy, plastic work and kinetic energy of the points of each body [J/m], shape (2, 3)."""
        state = self.state
        bodies = (state.points[first * layout.BLOCK : last * layout.BLOCK] for first, last in state.blocks)
        return np.array([points.sum_energies(body, state.solid) for body in bodies])

    @property
    def momentum_open(self) -> np.ndarray:
        """Momentum of the points less the impulses of tool and clamp, x and y [N s/m]; only damping changes it."""
        state, totals = self.state, self.state.totals
        mass = state.field(layout.MASS)
        held = np.array([mass @ state.field(layout.VX), mass @ state.field(layout.VY)])
        tool = totals[[step.CHIP_X, step.CHIP_Y]] + totals[[step.BASE_X, step.BASE_Y]]
        return held - tool - totals[[step.CLAMP_X, step.CLAMP_Y]]

    @property
    def crack_tip(self) -> float:
        """Place of the broken pair farthest ahead [m]."""
        return float(interface.crack_tip_of(self.state.interface))

    @property
    def escaped(self) -> str:
        """Edge of the grid (left, right, lower, upper) that a point is about to cross; empty if there is none."""
        frame = self.state.frame
        first_x, last_x, first_y, last_y = self._extents[:, self._current].T
        edges = {
            "left": first_x.min() < 1,
            "right": last_x.max() > frame.count_x - 2,
            "lower": first_y.min() < 1,
            "upper": last_y.max() > frame.count_y - 2,
        }
        return next((edge for edge, crossed in edges.items() if crossed), "")

    @property
    def sunken(self) -> bool:
        """Whether a point of the chip is more than two cells below the cut."""
        frame = self.state.frame
        surface = round(-frame.origin_y * frame.inv_cell)
        return bool(self._extents[layout.CHIP, self._current, 2] < surface - 3)
