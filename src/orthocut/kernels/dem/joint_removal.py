"""Removal of joints whose faces have left each other."""

from orthocut.kernels.dem.joint_measure import joint_energy
from orthocut.kernels.dem.joint_order import IN_USE
from orthocut.kernels.dem.layout import (
    BEND,
    BONDED,
    DISTANCE,
    FRACTURE,
    HALF_LENGTH,
    LANES,
    ROW,
    SHIFT,
    STIFFNESS,
)
from orthocut.kernels.jit import part


@part
def remove_joints(joints, tally, position, radius, law):
    """Remove wholly broken joints whose faces have shifted by more than their length, or lie open, or have tilted far.

    Open means that the gap is positive all along the faces and larger than a tenth of their half-length at the centre;
    tilted far means by more than half a radian, beyond which flat faces no longer describe two round discs. The energy
    that a joint still holds, less that of the linear contact that takes its place, counts as released by fracture. A
    joint stays where that contact would hold more, as it may between pressed faces shorter than the discs: to remove
    it would make energy.

    Returns
    -------
    int
        Number of joints removed.
    """
    removed = 0
    for place in range(joints.tidiness[IN_USE] * LANES):
        b = joints.owner[place]
        if joints.broken[place // LANES] == 0 or b < 0 or joints.live[b] == 0:
            continue
        block = joints.state[place // LANES]
        k = place % LANES
        bonded = 0.0
        for e in range(law.elements):
            bonded += block[BONDED + e * LANES + k]
        if bonded > 0.0:
            continue
        i, j = joints.first[b], joints.second[b]
        dx = position[j] - position[i]
        dy = position[j + 1] - position[i + 1]
        half_length = block[HALF_LENGTH + k]
        tilt = abs(block[BEND + k])
        length = (dx * dx + dy * dy) ** 0.5
        gap = length - block[DISTANCE + k]
        shifted = abs(block[SHIFT + k]) > 2.0 * half_length
        opened = gap > max(tilt, 0.1) * half_length
        if shifted or opened or tilt > 0.5:
            held = joint_energy(block, k, gap, law)
            smaller = min(radius[i // ROW], radius[j // ROW])
            reach = radius[i // ROW] + radius[j // ROW]
            stiffness = 2.0 * smaller / reach * law.modulus
            overlap = max(min(reach, joints.distance[b]) - length, 0.0)
            released = held - 0.5 * stiffness * overlap * overlap
            if released < 0.0:
                continue
            tally[FRACTURE] += released
            joints.live[b] = 0
            block[STIFFNESS + k] = 0.0
            removed += 1
    return removed
