"""What is watched while bonded discs move, beside their speeds: the energy balance, and how far discs overlap."""

from __future__ import annotations

import numpy as np

from orthocut.dem.state import Scene
from orthocut.kernels.dem.layout import FIRST_X, FIRST_Y, ROW, SECOND_X, SECOND_Y, TIP_X, TIP_Y
from orthocut.measure.dem_energy import Energies
from orthocut.measure.guard import Diverged

CLOSURE_LIMIT = 0.05
"""Share of the work, or of what it was spent on if that is more, that may remain unaccounted for."""
FAINT = 0.05
"""Overlap over radius of a contact whose energy is added to what the balance is compared with: at first touch speeds,
half a step behind the places, leave more open than has been done."""
OVERLAP_LIMIT = 0.5
"""Overlap over radius beyond which contacts are no longer those of round discs; ordinary cuts reach 0.1."""


def overlap(scene: Scene) -> float:
    """Largest overlap over the smaller radius, of two discs since their installation, or of a disc and a wall."""
    places, radius = scene.position.reshape(-1, ROW)[:, :2], scene.radius
    joints, contacts, walls = scene.joints, scene.contacts, scene.walls
    count = int(contacts.start[-1])
    live = joints.live > 0
    first = np.concatenate([joints.first[live] // ROW, np.repeat(np.arange(len(radius)), np.diff(contacts.start))])
    second = np.concatenate([joints.second[live] // ROW, contacts.second[:count]])
    touching = np.concatenate([joints.distance[live], contacts.distance[:count]])
    way = places[second] - places[first]
    deep = (touching - np.hypot(way[:, 0], way[:, 1])) / np.minimum(radius[first], radius[second])
    largest = float(deep.max(initial=0.0))
    for w, row in enumerate(walls.rows):
        near = walls.disc[walls.start[w] : walls.start[w + 1]]
        away = places[near] - row[[TIP_X, TIP_Y]]
        one, other = row[[FIRST_X, FIRST_Y]], row[[SECOND_X, SECOND_Y]]
        first, second, cosine = away @ one, away @ other, one @ other
        at_tip = (cosine < 1 - 1e-12) & (cosine * first < second) & (cosine * second < first)
        distance = np.where(at_tip, np.hypot(away[:, 0], away[:, 1]), np.maximum(first, second))
        largest = max(largest, float((1 - distance / radius[near]).max(initial=0.0)))
    return largest


def watch(scene: Scene, now: Energies, start: Energies) -> None:
    """Stop a run whose numbers can no longer be trusted.

    Parameters
    ----------
    scene : Scene
    now, start : Energies
        Energy balance at this instant and before the first step.

    Raises
    ------
    Diverged
        If energy is lost or made, or discs overlap so far that they are none any more.
    """
    when = f"step {int(scene.clock[0])}, time {scene.time:.4g} s"
    scale = max(abs(now.work_tool) + abs(start.energy_kinetic), sum(abs(part) for part in now[1:]))
    scale += scene.law.modulus * (FAINT * float(scene.radius.max())) ** 2
    lost = start.total - now.total
    if not abs(lost) <= CLOSURE_LIMIT * scale:
        raise Diverged(
            f"{when}: {lost / scale:.0%} of the work is not accounted for; try a smaller joint.time_step_factor"
        )
    deep = overlap(scene)
    if not deep <= OVERLAP_LIMIT:
        raise Diverged(
            f"{when}: discs overlap, or are in a wall, by {deep:.2f} of their radius (allowed: {OVERLAP_LIMIT:g}); the "
            "load is of the order of joint.modulus: try smaller strengths"
        )
