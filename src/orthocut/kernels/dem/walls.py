"""Contacts of discs with rigid walls.

A wall is a convex wedge: a tip and two faces without end, given by their outward normals. A tool has two different
normals, a plane wall twice the same. A disc touches the closest point of the wedge, a face or the tip, and
only that one.
"""

from orthocut.kernels.dem.layout import (
    FIRST_X,
    FIRST_Y,
    FRICTION,
    ROW,
    SECOND_X,
    SECOND_Y,
    SPEED_X,
    SPEED_Y,
    TIP_X,
    TIP_Y,
    WALL_FORCE_X,
    WALL_FORCE_Y,
    WALL_FRICTION,
    WALL_PEAK_X,
    WALL_PEAK_Y,
    WALL_STIFFNESS,
    WALL_SUM_X,
    WALL_SUM_Y,
    WALL_WORK,
)
from orthocut.kernels.jit import inline, part
from orthocut.kernels.laws.linear_contact import linear_contact


@inline
def wedge_distance(dx, dy, first_x, first_y, second_x, second_y):
    """Signed distance of a point from a convex wedge, and the direction away from its closest point.

    Parameters
    ----------
    dx, dy : float
        Position of the point less that of the tip [m].
    first_x, first_y, second_x, second_y : float
        Outward normals of both faces.
    """
    first = dx * first_x + dy * first_y
    second = dx * second_x + dy * second_y
    cosine = first_x * second_x + first_y * second_y
    # Along each face, from the tip, positive on the face: a face lies on the inner side of the other.
    along_first = cosine * first - second
    along_second = cosine * second - first
    squared = dx * dx + dy * dy
    if cosine < 1.0 - 1e-12 and along_first < 0.0 and along_second < 0.0 and squared > 0.0:
        distance = squared**0.5
        return distance, dx / distance, dy / distance
    if first >= second:
        return first, first_x, first_y
    return second, second_x, second_y


@part
def find_near_walls(start, disc, walls, position, radius, skin):
    """List the discs closer to each wall than `skin`."""
    count = 0
    for w in range(walls.shape[0]):
        start[w] = count
        for m in range(radius.size):
            i = m * ROW
            distance, _, _ = wedge_distance(
                position[i] - walls[w, TIP_X], position[i + 1] - walls[w, TIP_Y],
                walls[w, FIRST_X], walls[w, FIRST_Y], walls[w, SECOND_X], walls[w, SECOND_Y],
            )  # fmt: skip
            if distance - radius[m] < skin:
                disc[count] = m
                count += 1
    start[walls.shape[0]] = count


@part
def move_walls(walls, time_step):
    """Move all walls."""
    for w in range(walls.shape[0]):
        walls[w, TIP_X] += time_step * walls[w, SPEED_X]
        walls[w, TIP_Y] += time_step * walls[w, SPEED_Y]


@part
def add_wall_forces(force, walls, shear, tally, start, disc, position, velocity, radius, stiffness_ratio, time_step):
    """Add the forces of walls on discs; sum the forces on each wall.

    Parameters
    ----------
    walls : float array, shape (n_walls, 17)
        Geometry, velocity and properties; the columns of forces and work are updated.
    shear : float array, shape (n_walls, n_discs)
        Shear forces [N/m]; modified in place.
    """
    for w in range(walls.shape[0]):
        tip_x, tip_y = walls[w, TIP_X], walls[w, TIP_Y]
        speed_x, speed_y = walls[w, SPEED_X], walls[w, SPEED_Y]
        sum_x = 0.0
        sum_y = 0.0
        for c in range(start[w], start[w + 1]):
            m = disc[c]
            i = m * ROW
            distance, normal_x, normal_y = wedge_distance(
                position[i] - tip_x, position[i + 1] - tip_y,
                walls[w, FIRST_X], walls[w, FIRST_Y], walls[w, SECOND_X], walls[w, SECOND_Y],
            )  # fmt: skip
            if distance >= radius[m]:
                shear[w, m] = 0.0
                continue
            slide = normal_x * (velocity[i + 1] - speed_y) - normal_y * (velocity[i] - speed_x)
            slip = (slide - distance * velocity[i + 2]) * time_step
            push, along, loss = linear_contact(
                distance - radius[m], shear[w, m], slip, walls[w, WALL_STIFFNESS], stiffness_ratio,
                walls[w, WALL_FRICTION],
            )  # fmt: skip
            shear[w, m] = along
            tally[FRICTION] += loss
            force_x = push * normal_x - along * normal_y
            force_y = push * normal_y + along * normal_x
            force[i] += force_x
            force[i + 1] += force_y
            force[i + 2] -= distance * along
            sum_x -= force_x
            sum_y -= force_y
        walls[w, WALL_FORCE_X] = sum_x
        walls[w, WALL_FORCE_Y] = sum_y
        walls[w, WALL_SUM_X] += sum_x
        walls[w, WALL_SUM_Y] += sum_y
        walls[w, WALL_WORK] -= (sum_x * speed_x + sum_y * speed_y) * time_step
        if abs(sum_x) > abs(walls[w, WALL_PEAK_X]):
            walls[w, WALL_PEAK_X] = sum_x
        if abs(sum_y) > abs(walls[w, WALL_PEAK_Y]):
            walls[w, WALL_PEAK_Y] = sum_y
