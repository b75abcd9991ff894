"""Energy balance of a scene of bonded discs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from orthocut.dem.state import Scene
from orthocut.kernels.dem import layout
from orthocut.kernels.dem.joint_measure import measure_contacts, measure_joints
from orthocut.kernels.dem.wall_measure import measure_walls


class Energies(NamedTuple):
    """Where the work went, all in J/m."""

    work_tool: float
    """Work done by walls and driven discs."""
    energy_kinetic: float
    energy_elastic: float
    energy_damping: float
    energy_friction: float
    energy_fracture: float

    @property
    def total(self) -> float:
        """Energy held and removed less the work done; constant in an exact run."""
        return sum(self[1:]) - self.work_tool


class Forces(NamedTuple):
    """Forces between discs: joints first, then linear contacts."""

    first: np.ndarray
    """(n_forces,) index of the first disc."""
    second: np.ndarray
    """(n_forces,) index of the second disc."""
    force: np.ndarray
    """(n_forces, 2) force on the first disc [N/m]."""
    intact: np.ndarray
    """(n_joints,) fraction of bonded elements."""
    energy: float
    """Elastic energy of joints and contacts [J/m]."""


def forces(scene: Scene) -> Forces:
    """Forces between discs at this instant."""
    joints, contacts, law = scene.joints, scene.contacts, scene.law
    n_joints, n_contacts = len(joints.first), int(contacts.start[-1])
    force = np.zeros((2, n_joints + n_contacts))
    moment, intact = np.zeros(n_joints), np.zeros(n_joints)
    energy = measure_joints(force[0, :n_joints], force[1, :n_joints], moment, intact, joints, scene.position, law)
    energy += measure_contacts(
        force[0, n_joints:],
        force[1, n_joints:],
        contacts,
        scene.position,
        scene.radius,
        law.modulus,
        law.stiffness_ratio,
    )
    owner = np.repeat(np.arange(len(scene.radius)), np.diff(contacts.start))
    return Forces(
        first=np.concatenate([joints.first.astype(np.int64) // layout.ROW, owner]),
        second=np.concatenate([joints.second.astype(np.int64) // layout.ROW, contacts.second[:n_contacts]]),
        force=force.T,
        intact=intact,
        energy=energy,
    )


def energies(scene: Scene, elastic: float | None = None) -> Energies:
    """Energy balance at this instant.

    Parameters
    ----------
    scene : Scene
    elastic : float, optional
        Elastic energy of joints and contacts [J/m], where it is known already.
    """
    walls = scene.walls
    elastic = forces(scene).energy if elastic is None else elastic
    elastic += measure_walls(
        walls.rows, walls.shear, walls.start, walls.disc, scene.position, scene.radius, scene.law.stiffness_ratio
    )
    moving = scene.inverse_mass > 0
    kinetic = 0.5 * float(np.sum(scene.velocity[moving] ** 2 / scene.inverse_mass[moving]))
    return Energies(
        work_tool=float(scene.tally[layout.GRIP] + walls.rows[:, layout.WALL_WORK].sum()),
        energy_kinetic=kinetic,
        energy_elastic=float(elastic),
        energy_damping=float(scene.tally[layout.DAMPING]),
        energy_friction=float(scene.tally[layout.FRICTION]),
        energy_fracture=float(scene.tally[layout.FRACTURE]),
    )
