"""Leap-frog with local damping: positions at whole steps, velocities at half steps."""

import numpy as np

from orthocut.kernels.dem.layout import DAMPING, GRIP, ROW
from orthocut.kernels.jit import part


@part
def move(position, velocity, time_step):
    """Move and turn all discs."""
    for k in range(position.size):
        position[k] += time_step * velocity[k]


@part
def accelerate(velocity, force, tally, inverse_mass, damping, time_step):
    """Change velocities by the forces, damped, and clear the forces.

    Local damping takes away the fraction `damping` of the unbalanced force where it drives the motion and adds it where
    it opposes it (Yang et al. 2018 use PFC's local damping). Discs with inverse mass zero keep their velocity.
    """
    loss = 0.0
    for k in range(velocity.size):
        before = velocity[k]
        unbalanced = force[k]
        drag = damping * abs(unbalanced)
        drag = -drag if before > 0.0 else (drag if before < 0.0 else 0.0)
        mass = inverse_mass[k]
        after = before + time_step * mass * (unbalanced + drag)
        loss -= 0.5 * drag * (before + after) if mass > 0.0 else 0.0
        velocity[k] = after
        force[k] = 0.0
    tally[DAMPING] += loss * time_step


@part
def sum_reactions(reaction, tally, force, velocity, driven, group, time_step):
    """Add the force on the driven discs to the sums of their groups, and the work done on them to the tally.

    Parameters
    ----------
    reaction : float array, shape (2 n_groups,)
        Sums over steps of the force that the specimen exerts on the group, x and y [N/m]; added to.
    """
    work = 0.0
    for m in range(driven.size):
        k = driven[m]
        g = 2 * group[m]
        reaction[g] += force[k]
        reaction[g + 1] += force[k + 1]
        work -= force[k] * velocity[k] + force[k + 1] * velocity[k + 1] + force[k + 2] * velocity[k + 2]
    tally[GRIP] += work * time_step


@part
def fastest(velocity):
    """Largest speed of a disc [m/s]; infinite if any is not a number."""
    largest = 0.0
    for i in range(0, velocity.size, ROW):
        square = velocity[i] * velocity[i] + velocity[i + 1] * velocity[i + 1]
        if not square <= largest:
            largest = square if square == square else np.inf
    return largest**0.5


@part
def count_strays(position, reference, distance):
    """Count the discs not within `distance` of their places at the last search; a place that is not a number is not."""
    limit = distance * distance
    count = 0
    for m in range(position.size // ROW):
        dx = position[m * ROW] - reference[m * ROW]
        dy = position[m * ROW + 1] - reference[m * ROW + 1]
        count += not dx * dx + dy * dy <= limit
    return count
