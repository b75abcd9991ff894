"""Initial state of a scene: joints installed without stress, walls, driven discs."""

from __future__ import annotations

import math

import numpy as np

from orthocut.dem.joint_kinds import BONDED, GAPPED, draw_kinds
from orthocut.dem.pairs import close_pairs
from orthocut.dem.state import Contacts, Cracks, Joints, Law, Scene, Walls
from orthocut.kernels.dem import layout
from orthocut.kernels.dem.joint_order import sort_joints
from orthocut.params.dem import FlatJoint

NO_DISCS = np.zeros(0, dtype=np.int64)
_NEIGHBOURS = 10
"""Room in the list of contacts, per disc."""


def law_of(joint: FlatJoint) -> Law:
    """Parameters of the kernels from a parameter block."""
    return Law(
        joint.modulus,
        joint.stiffness_ratio,
        joint.strength_tensile,
        joint.cohesion,
        math.tan(joint.friction_angle),
        joint.friction,
        joint.elements,
        joint.damping,
    )


def install_joints(x: np.ndarray, y: np.ndarray, radius: np.ndarray, joint: FlatJoint) -> Joints:
    """Joints on all pairs that touch or are close, without stress whatever the overlap.

    Where a joint is gapped, its discs touch at the distance of installation less its initial gap.
    """
    pairs = close_pairs(x, y, radius, joint.gap_ratio)
    first, second = pairs[:, 0], pairs[:, 1]
    dx, dy = x[second] - x[first], y[second] - y[first]
    distance = np.sqrt(dx * dx + dy * dy)
    smaller = np.minimum(radius[first], radius[second])
    kinds = draw_kinds(np.column_stack([x, y]), pairs, joint)
    touching = distance - np.where(kinds == GAPPED, joint.gapped_opening * smaller, 0.0)
    n_blocks = -(-len(pairs) // layout.LANES) + 1  # the last whole block and the last other one can be partly filled
    n_places = n_blocks * layout.LANES
    state = np.zeros((n_blocks, layout.FIELDS))

    def fill(field: int, values: np.ndarray | float) -> None:
        column = np.zeros(n_places)
        column[: len(pairs)] = values
        state[:, field : field + layout.LANES] = column.reshape(n_blocks, layout.LANES)

    fill(layout.DISTANCE, touching)
    fill(layout.HALF_LENGTH, joint.radius_multiplier * smaller)
    fill(layout.STIFFNESS, joint.modulus / (radius[first] + radius[second]))
    fill(layout.DIFFERENCE, radius[first] - radius[second])
    fill(layout.NORMAL_X, dx / distance)
    fill(layout.NORMAL_Y, dy / distance)
    for element in range(joint.elements):
        fill(layout.BONDED + element * layout.LANES, np.where(kinds == BONDED, 1.0, 0.0))
    joints = Joints(
        first=(layout.ROW * first).astype(np.uint32),
        second=(layout.ROW * second).astype(np.uint32),
        start=np.searchsorted(first, np.arange(len(x) + 1)).astype(np.int64),
        distance=touching,
        kind=kinds,
        live=np.ones(len(pairs), dtype=np.uint8),
        place=np.arange(len(pairs)),
        owner=np.full(n_places, -1),
        lane_first=np.zeros(n_places, dtype=np.uint32),
        lane_second=np.zeros(n_places, dtype=np.uint32),
        lanes=np.zeros(n_blocks, dtype=np.int64),
        broken=np.zeros(n_blocks, dtype=np.uint8),
        tidiness=np.zeros(3, dtype=np.int64),
        state=state,
        spare=np.zeros_like(state),
        work=np.zeros(layout.WORK),
    )
    sort_joints(joints, joint.elements)
    return joints


def wall(
    tip: tuple[float, float],
    normals: tuple[tuple[float, float], tuple[float, float]],
    velocity: tuple[float, float],
    friction: float,
    modulus: float,
) -> np.ndarray:
    """Row of a rigid wall: tip and outward normals of both faces of a convex wedge.

    A disc at a wall has the contact area 2 R and the length R, so its normal stiffness is twice the modulus.
    """
    row = np.zeros(layout.WALL)
    row[: layout.WALL_FRICTION] = (*tip, *normals[0], *normals[1], *velocity)
    row[layout.WALL_FRICTION] = friction
    row[layout.WALL_STIFFNESS] = 2 * modulus
    return row


def build(
    x: np.ndarray,
    y: np.ndarray,
    radius: np.ndarray,
    joint: FlatJoint,
    walls: list[np.ndarray] | None = None,
    driven: np.ndarray = NO_DISCS,
    group: np.ndarray = NO_DISCS,
) -> Scene:
    """Scene of discs at rest, joined where they touch.

    Parameters
    ----------
    x, y, radius : float arrays, shape (n_discs,)
        [m].
    joint : FlatJoint
        Parameters of joints and contacts.
    walls : list of rows, optional
        As made by `wall`.
    driven, group : int arrays, shape (n_driven,)
        Discs whose velocity is prescribed (zero until set), and their groups 0, 1, ...
    """
    n = len(x)
    position = np.zeros((n, layout.ROW))
    position[:, 0], position[:, 1] = x, y
    mass = joint.density * math.pi * radius**2
    inverse_mass = np.zeros((n, layout.ROW))
    inverse_mass[:, 0] = inverse_mass[:, 1] = 1 / mass
    inverse_mass[:, 2] = 2 / (mass * radius**2)
    inverse_mass[driven] = 0.0

    joints = install_joints(x, y, radius, joint)
    rows = np.array(walls) if walls else np.zeros((0, layout.WALL))
    skin = 0.4 * float(radius.min())
    size = 2 * float(radius.max()) + skin
    margin = 4 * size
    left, bottom = float(x.min()) - margin, float(y.min()) - margin
    columns = int((float(x.max()) + margin - left) / size) + 1
    lines = int((float(y.max()) + margin - bottom) / size) + 1
    room = _NEIGHBOURS * n

    return Scene(
        position=position.ravel(),
        velocity=np.zeros(layout.ROW * n),
        force=np.zeros(layout.ROW * n),
        inverse_mass=inverse_mass.ravel(),
        radius=np.ascontiguousarray(radius),
        reference=np.zeros(layout.ROW * n),
        joints=joints,
        contacts=Contacts(
            start=np.zeros(n + 1, dtype=np.int64),
            second=np.zeros(room, dtype=np.int64),
            distance=np.zeros(room),
            shear=np.zeros(room),
            old_start=np.zeros(n + 1, dtype=np.int64),
            old_second=np.zeros(room, dtype=np.int64),
            old_shear=np.zeros(room),
            pair_start=np.zeros(n + 1, dtype=np.int64),
            pair_second=np.zeros(room, dtype=np.int64),
            cell_start=np.zeros(columns * lines + 1, dtype=np.int64),
            cell_disc=np.zeros(n, dtype=np.int64),
            cell_of=np.zeros(n, dtype=np.int64),
        ),
        walls=Walls(
            rows=rows,
            shear=np.zeros((len(rows), n)),
            start=np.zeros(len(rows) + 1, dtype=np.int64),
            disc=np.zeros(max(len(rows), 1) * n, dtype=np.int64),
        ),
        cracks=Cracks(
            log=np.zeros(max(len(joints.first), 1) * joint.elements * layout.CRACK), count=np.zeros(1, dtype=np.int64)
        ),
        driven=layout.ROW * np.asarray(driven, dtype=np.int64),
        group=np.asarray(group, dtype=np.int64),
        reaction=np.zeros(2 * (int(group.max()) + 1 if len(group) else 1)),
        tally=np.zeros(layout.TALLY),
        clock=np.array([0, -1, 0, 0], dtype=np.int64),
        law=law_of(joint),
        grid=(left, bottom, size, columns, lines),
        skin=skin,
        time_step=joint.time_step_factor * math.sqrt(float(mass.min()) / joint.modulus),
        speed_limit=0.2 * math.sqrt(joint.modulus / joint.density),
    )
