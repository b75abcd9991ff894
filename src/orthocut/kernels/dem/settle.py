"""Settling of frictionless discs in a rectangular vessel.

Lengths in any unit; the modulus and all masses are one, so that every disc has the same fastest time scale. Only the
equilibrium matters, and it depends on lengths and stiffness ratios alone.
"""

import numpy as np

from orthocut.kernels.dem.layout import ROW
from orthocut.kernels.dem.neighbours import find_pairs
from orthocut.kernels.jit import inline, jit, part

TIME_STEP = 0.3
"""Time step; the unit is sqrt(mass/(modulus x width))."""
DAMPING = 0.7
"""Local damping."""
CHECK = 10
"""Steps between checks of the list of pairs."""


@inline
def push_from_wall(gap):
    """Force of a smooth wall with twice the modulus."""
    return -2.0 * gap if gap < 0.0 else 0.0


@part
def add_pushes(force, position, radius, width, height, start, second):
    """Add the forces of overlapping discs and walls.

    Returns
    -------
    float array, shape (6,)
        Sum of contact forces, number of contacts, largest overlap over diameter; sum of force times branch length
        (twice the area times the pressure); sum of stiffness times radii times branch length (its derivative by a
        common scaling of the radii); number of wall contacts.
    """
    sums = np.zeros(6)
    for i in range(radius.size):
        x, y, own = position[i * ROW], position[i * ROW + 1], radius[i]
        for c in range(start[i], start[i + 1]):
            j = second[c]
            dx = position[j * ROW] - x
            dy = position[j * ROW + 1] - y
            reach = own + radius[j]
            squared = dx * dx + dy * dy
            if squared < reach * reach:
                length = squared**0.5
                stiffness = 2.0 * min(own, radius[j]) / reach
                push = stiffness * (reach - length)
                scale = push / max(length, 1e-300)
                force[i * ROW] -= scale * dx
                force[i * ROW + 1] -= scale * dy
                force[j * ROW] += scale * dx
                force[j * ROW + 1] += scale * dy
                sums[0] += push
                sums[1] += 1.0
                sums[2] = max(sums[2], (reach - length) / reach)
                sums[3] += push * length
                sums[4] += stiffness * reach * length
        west, east = push_from_wall(x - own), push_from_wall(width - x - own)
        south, north = push_from_wall(y - own), push_from_wall(height - y - own)
        force[i * ROW] += west - east
        force[i * ROW + 1] += south - north
        for push, length in ((west, x), (east, width - x), (south, y), (north, height - y)):
            if push > 0.0:
                sums[0] += push
                sums[3] += push * length
                sums[4] += 2.0 * own * length
                sums[5] += 1.0
    return sums


@jit
def settle(position, velocity, radius, width, height, lists, grid, skin, steps, calm, overlap_goal, ratio_goal):
    """Let discs move until they are in equilibrium.

    Parameters
    ----------
    position, velocity : float arrays, shape (4 n_discs,)
        Modified in place.
    lists : tuple of int arrays
        Scratch: start and second disc of pairs, start and discs of cells, cell of each disc.
    steps : int
        Largest number of steps.
    calm : int
        Steps between two resets of all velocities; 0 for none.
    overlap_goal, ratio_goal : float
        Stop when the largest overlap over diameter, and the mean unbalanced over the mean contact force, are at most
        these.

    Returns
    -------
    steps_done : int
        -1 if there is no room for all pairs or a position is not a number.
    sums : float array, shape (6,)
        As in `add_pushes`.
    """
    start, second, cell_start, cell_disc, cell_of = lists
    n = radius.size
    force = np.zeros(ROW * n)
    reference = np.full(ROW * n, np.inf)
    sums = np.zeros(6)
    for step in range(steps):
        if step % CHECK == 0:
            moved = 0.0
            speed = 0.0
            for k in range(ROW * n):
                moved = max(moved, abs(position[k] - reference[k]))
                speed = max(speed, abs(velocity[k]))
            if not moved + 2.0 * CHECK * TIME_STEP * speed < 0.35 * skin:
                if find_pairs(start, second, cell_start, cell_disc, cell_of, position, radius, skin, grid) < 0:
                    return -1, sums
                reference[:] = position
        force[:] = 0.0
        sums = add_pushes(force, position, radius, width, height, start, second)
        if step % CHECK == CHECK - 1 and sums[1] > 0.0 and sums[2] <= overlap_goal:
            unbalanced = 0.0
            for i in range(n):
                unbalanced += (force[i * ROW] ** 2 + force[i * ROW + 1] ** 2) ** 0.5
            if unbalanced / n <= ratio_goal * sums[0] / (sums[1] + sums[5]):
                return step, sums
        for k in range(ROW * n):
            drag = DAMPING * abs(force[k])
            drag = -drag if velocity[k] > 0.0 else (drag if velocity[k] < 0.0 else 0.0)
            velocity[k] += TIME_STEP * (force[k] + drag)
            position[k] += TIME_STEP * velocity[k]
        if calm > 0 and step % calm == calm - 1:
            velocity[:] = 0.0
    return steps, sums
