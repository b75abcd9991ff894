"""Linear contacts between discs without a live joint."""

from orthocut.kernels.dem.layout import FRICTION, ROW
from orthocut.kernels.dem.neighbours import find_pairs
from orthocut.kernels.jit import part
from orthocut.kernels.laws.linear_contact import linear_contact


@part
def renew_contacts(contacts, joints, position, radius, skin, grid):
    """List the pairs of close discs without a live joint anew; shear forces of old contacts are kept.

    A pair that was installed with an overlap touches at its distance of installation, so that the overlap of the
    packing stays forgotten when its joint is gone.

    Returns
    -------
    int
        Number of contacts, or -1 if the list is too short or a position is not a number.
    """
    contacts.old_start[:] = contacts.start
    contacts.old_second[:] = contacts.second
    contacts.old_shear[:] = contacts.shear
    found = find_pairs(
        contacts.pair_start, contacts.pair_second, contacts.cell_start, contacts.cell_disc, contacts.cell_of,
        position, radius, skin, grid,
    )  # fmt: skip
    if found < 0:
        return -1
    count = 0
    for i in range(radius.size):
        contacts.start[i] = count
        for p in range(contacts.pair_start[i], contacts.pair_start[i + 1]):
            j = contacts.pair_second[p]
            distance = radius[i] + radius[j]
            live = False
            for b in range(joints.start[i], joints.start[i + 1]):
                if joints.second[b] == j * ROW:
                    live = joints.live[b] != 0
                    distance = min(distance, joints.distance[b])
                    break
            if live:
                continue
            shear = 0.0
            for c in range(contacts.old_start[i], contacts.old_start[i + 1]):
                if contacts.old_second[c] == j:
                    shear = contacts.old_shear[c]
                    break
            contacts.second[count] = j
            contacts.distance[count] = distance
            contacts.shear[count] = shear
            count += 1
    contacts.start[radius.size] = count
    return count


@part
def add_contact_forces(
    force, contacts, tally, position, velocity, radius, modulus, stiffness_ratio, friction, time_step
):
    """Add the forces of linear contacts to the discs."""
    for m in range(radius.size):
        i = m * ROW
        for c in range(contacts.start[m], contacts.start[m + 1]):
            n = contacts.second[c]
            j = n * ROW
            dx = position[j] - position[i]
            dy = position[j + 1] - position[i + 1]
            distance = contacts.distance[c]
            squared = dx * dx + dy * dy
            if squared >= distance * distance:
                contacts.shear[c] = 0.0
                continue
            length = squared**0.5
            normal_x = dx / length
            normal_y = dy / length
            lever_first = 0.5 * (length + radius[m] - radius[n])
            lever_second = length - lever_first
            slide = normal_x * (velocity[j + 1] - velocity[i + 1]) - normal_y * (velocity[j] - velocity[i])
            slip = (slide - lever_first * velocity[i + 2] - lever_second * velocity[j + 2]) * time_step
            stiffness = 2.0 * min(radius[m], radius[n]) / (radius[m] + radius[n]) * modulus
            push, along, loss = linear_contact(
                length - distance, contacts.shear[c], slip, stiffness, stiffness_ratio, friction
            )
            contacts.shear[c] = along
            tally[FRICTION] += loss
            force_x = push * normal_x - along * normal_y
            force_y = push * normal_y + along * normal_x
            force[i] -= force_x
            force[i + 1] -= force_y
            force[i + 2] -= lever_first * along
            force[j] += force_x
            force[j + 1] += force_y
            force[j + 2] -= lever_second * along
