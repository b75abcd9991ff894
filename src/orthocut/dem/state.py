"""State of a scene of bonded discs: named groups of arrays that kernels modify in place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np


class Law(NamedTuple):
    """Parameters of joints and contacts in SI units."""

    modulus: float
    stiffness_ratio: float
    strength_tensile: float
    cohesion: float
    tangent: float
    """Tangent of the friction angle of bonded elements."""
    friction: float
    elements: int
    damping: float


class Joints(NamedTuple):
    """Flat joints in ascending order of the first disc, and the blocks of lanes in which they are computed."""

    first: np.ndarray
    """(n_joints,) uint32, four times the index of the first disc."""
    second: np.ndarray
    """(n_joints,) uint32, four times the index of the second disc."""
    start: np.ndarray
    """(n_discs + 1,) int64, where the joints of each first disc start."""
    distance: np.ndarray
    """(n_joints,) distance of the centres at which the faces touch: that at installation, less the gap of gapped joints
    [m]."""
    kind: np.ndarray
    """(n_joints,) int8, as installed; see `orthocut.dem.joint_kinds`."""
    live: np.ndarray
    """(n_joints,) uint8, 0 after removal."""
    place: np.ndarray
    """(n_joints,) int64, block times `LANES` plus lane; -1 once a removed joint has lost its lane."""
    owner: np.ndarray
    """(n_places,) int64, joint in each lane, -1 for none."""
    lane_first: np.ndarray
    """(n_places,) uint32, `first` of the joint in each lane."""
    lane_second: np.ndarray
    """(n_places,) uint32, `second` of the joint in each lane."""
    lanes: np.ndarray
    """(n_blocks,) int64, lanes in use."""
    broken: np.ndarray
    """(n_blocks,) uint8, 1 for a block with an element that has broken or was never bonded."""
    tidiness: np.ndarray
    """(3,) int64, see `orthocut.kernels.dem.joint_order`: blocks in use, blocks of whole joints, needless work."""
    state: np.ndarray
    """(n_blocks, FIELDS), see `orthocut.kernels.dem.layout`."""
    spare: np.ndarray
    """(n_blocks, FIELDS) scratch of the sort."""
    work: np.ndarray
    """(WORK,) scratch of one block."""


class Contacts(NamedTuple):
    """Pairs of close discs without a live joint, in ascending order of the first disc, and the grid to find them."""

    start: np.ndarray
    second: np.ndarray
    distance: np.ndarray
    """Distance of the centres at which the discs touch [m]."""
    shear: np.ndarray
    """Shear forces [N/m]."""
    old_start: np.ndarray
    old_second: np.ndarray
    old_shear: np.ndarray
    pair_start: np.ndarray
    pair_second: np.ndarray
    cell_start: np.ndarray
    cell_disc: np.ndarray
    cell_of: np.ndarray


class Cracks(NamedTuple):
    """Log of broken elements in order of time."""

    log: np.ndarray
    """(CRACK n_joints n_elements,) rows, see `orthocut.kernels.dem.layout`."""
    count: np.ndarray
    """(1,) int64, number of rows in use."""


class Walls(NamedTuple):
    """Rigid walls."""

    rows: np.ndarray
    """(n_walls, WALL), see `orthocut.kernels.dem.layout`."""
    shear: np.ndarray
    """(n_walls, n_discs) shear forces [N/m]."""
    start: np.ndarray
    """(n_walls + 1,) where the discs near each wall start."""
    disc: np.ndarray
    """Discs near the walls."""


class Scene(NamedTuple):
    """Everything that a run changes, and what it needs to do so."""

    position: np.ndarray
    """(4 n_discs,) rows of x [m], y [m], rotation [rad], nothing."""
    velocity: np.ndarray
    """(4 n_discs,) rows of velocities [m/s, rad/s] half a step behind the positions."""
    force: np.ndarray
    """(4 n_discs,) scratch for forces [N/m] and moments [N]."""
    inverse_mass: np.ndarray
    """(4 n_discs,) rows of 1/mass, 1/mass [m/kg], 1/inertia [1/(kg m)], 0; zero for driven discs."""
    radius: np.ndarray
    """(n_discs,) [m]."""
    reference: np.ndarray
    """(4 n_discs,) positions at the last search for neighbours."""
    joints: Joints
    contacts: Contacts
    walls: Walls
    cracks: Cracks
    driven: np.ndarray
    """(n_driven,) int64, four times the indices of discs with prescribed velocity."""
    group: np.ndarray
    """(n_driven,) int64, group of each driven disc."""
    reaction: np.ndarray
    """(2 n_groups,) sums over steps of the force of the specimen on each group, x and y [N/m]."""
    tally: np.ndarray
    """(TALLY,) energies [J/m], see `orthocut.kernels.dem.layout`."""
    clock: np.ndarray
    """(4,) int64: number of steps done, step of the last search (-1: search anew), number of searches, step of the next
    look at how far the discs have moved."""
    law: Law
    grid: tuple[float, float, float, int, int]
    """Corner of the grid of cells (x, y) [m], cell size [m], number of columns, number of rows."""
    skin: float
    """Distance up to which pairs are listed as close [m]."""
    time_step: float
    """[s]"""
    speed_limit: float
    """Speed that only a diverging run reaches [m/s]."""

    @property
    def time(self) -> float:
        """Time [s]."""
        return int(self.clock[0]) * self.time_step

    @property
    def places(self) -> np.ndarray:
        """Positions of the discs, shape (n_discs, 2) [m]; a view."""
        return self.position.reshape(-1, 4)[:, :2]

    @property
    def speeds(self) -> np.ndarray:
        """Velocities of the discs, shape (n_discs, 3) [m/s, rad/s]; a view."""
        return self.velocity.reshape(-1, 4)[:, :3]

    def freeze(self) -> dict[str, np.ndarray]:
        """All arrays by name; views."""
        return dict(_arrays(self))

    def thaw(self, frozen: Mapping[str, np.ndarray]) -> None:
        """Take over what `freeze` of a scene of the same case returned."""
        for name, values in _arrays(self):
            np.copyto(values, frozen[name])


def _arrays(group: tuple, prefix: str = "") -> Iterator[tuple[str, np.ndarray]]:
    """Names and arrays of a named group and of the groups in it."""
    for name, value in zip(group._fields, group, strict=True):
        if isinstance(value, np.ndarray):
            yield prefix + name, value
        elif hasattr(value, "_fields"):
            yield from _arrays(value, f"{prefix}{name}.")
