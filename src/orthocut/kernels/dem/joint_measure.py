"""What joints hold at an instant: forces and elastic energy, without changing them."""

from orthocut.kernels.dem.layout import (
    BEND,
    BONDED,
    DISTANCE,
    HALF_LENGTH,
    LANES,
    NORMAL_X,
    NORMAL_Y,
    ROW,
    STIFFNESS,
    STRESS_SHEAR,
)
from orthocut.kernels.jit import jit, part
from orthocut.kernels.laws.flat_joint import element_closure


@part
def element_shear(joints, place, e):
    """Shear stress of element `e` of the joint at a place [Pa]; in whole blocks the first element stands for all."""
    own = e if joints.broken[place // LANES] != 0 else 0
    return joints.state[place // LANES, STRESS_SHEAR + own * LANES + place % LANES]


@part
def joint_energy(block, k, gap, law):
    """Elastic energy of a joint in a broken block [J/m]."""
    stiffness = block[STIFFNESS + k]
    half_length = block[HALF_LENGTH + k] / law.elements
    total = 0.0
    for e in range(law.elements):
        offset = (2 * e + 1 - law.elements) * half_length
        _, _, energy = element_closure(
            block[BONDED + e * LANES + k], gap - block[BEND + k] * offset, block[BEND + k], half_length, stiffness
        )
        shear = block[STRESS_SHEAR + e * LANES + k]
        total += energy
        if stiffness > 0.0:
            total += shear * shear * half_length * law.stiffness_ratio / stiffness
    return total


@jit
def measure_joints(force_x, force_y, moment, intact, joints, position, law):
    """Force on the first disc, moment of the normal stress and fraction of bonded elements of every joint.

    Parameters
    ----------
    force_x, force_y, moment, intact : float arrays, shape (n_joints,)
        Filled: [N/m], [N/m], [N], [1].

    Returns
    -------
    float
        Elastic energy of all joints [J/m].
    """
    total = 0.0
    for b in range(joints.first.size):
        force_x[b] = 0.0
        force_y[b] = 0.0
        moment[b] = 0.0
        intact[b] = 0.0
        place = joints.place[b]
        if place < 0:
            continue
        block = joints.state[place // LANES]
        k = place % LANES
        i, j = joints.first[b], joints.second[b]
        dx = position[j] - position[i]
        dy = position[j + 1] - position[i + 1]
        stiffness = block[STIFFNESS + k]
        gap = (dx * dx + dy * dy) ** 0.5 - block[DISTANCE + k]
        bend = position[j + 2] - position[i + 2]
        half_length = block[HALF_LENGTH + k] / law.elements
        normal = 0.0
        shear = 0.0
        for e in range(law.elements):
            offset = (2 * e + 1 - law.elements) * half_length
            bonded = block[BONDED + e * LANES + k]
            force, own, energy = element_closure(bonded, gap - bend * offset, bend, half_length, stiffness)
            stress = element_shear(joints, place, e)
            normal += force
            shear += 2.0 * half_length * stress
            moment[b] += offset * force + own
            intact[b] += bonded / law.elements
            total += energy
            if stiffness > 0.0:
                total += stress * stress * half_length * law.stiffness_ratio / stiffness
        normal_x = block[NORMAL_X + k]
        normal_y = block[NORMAL_Y + k]
        force_x[b] = normal * normal_x - shear * normal_y
        force_y[b] = normal * normal_y + shear * normal_x
    return total


@jit
def measure_contacts(force_x, force_y, contacts, position, radius, modulus, stiffness_ratio):
    """Fill the forces on the first discs of all linear contacts [N/m]; return their elastic energy [J/m]."""
    total = 0.0
    for m in range(radius.size):
        for c in range(contacts.start[m], contacts.start[m + 1]):
            n = contacts.second[c]
            dx = position[n * ROW] - position[m * ROW]
            dy = position[n * ROW + 1] - position[m * ROW + 1]
            length = (dx * dx + dy * dy) ** 0.5
            gap = length - contacts.distance[c]
            force_x[c] = 0.0
            force_y[c] = 0.0
            if gap < 0.0:
                stiffness = 2.0 * min(radius[m], radius[n]) / (radius[m] + radius[n]) * modulus
                shear = contacts.shear[c]
                force_x[c] = (stiffness * gap * dx + shear * dy) / length
                force_y[c] = (stiffness * gap * dy - shear * dx) / length
                total += 0.5 * (stiffness * gap * gap + shear * shear * stiffness_ratio / stiffness)
    return total
