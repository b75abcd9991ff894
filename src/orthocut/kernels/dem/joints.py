"""Forces of all flat joints: scalar gather, vectorised response of a block of joints, scalar scatter.

A block whose elements are all bonded takes a short path in which the number of elements does not matter. When the most
loaded element of any of its joints reaches its strength, the block changes to the general path, until the joints are
sorted (`orthocut.kernels.dem.joint_order`).
"""

from orthocut.kernels.dem.joint_order import IN_USE
from orthocut.kernels.dem.layout import (
    BEND,
    BONDED,
    CRACK,
    DIFFERENCE,
    DISTANCE,
    FRACTURE,
    FRICTION,
    HALF_LENGTH,
    LANES,
    NORMAL_X,
    NORMAL_Y,
    SHIFT,
    SPIN,
    STIFFNESS,
    STRESS_SHEAR,
    W_BEND,
    W_LENGTH,
    W_MODE,
    W_MOMENT,
    W_NORMAL,
    W_RELEASED,
    W_SHEAR,
    W_SLIP,
    W_SPIN,
    W_X,
    W_Y,
)
from orthocut.kernels.jit import part
from orthocut.kernels.laws.flat_joint import element_closure, element_failure, element_slip, joint_intact


@part
def gather(work, position, first, second, start, lanes):
    """Vector, mean and relative rotation between the discs of the joints of a block; unused lanes get a unit vector."""
    for k in range(lanes):
        i = first[start + k]
        j = second[start + k]
        work[W_X + k] = position[j] - position[i]
        work[W_Y + k] = position[j + 1] - position[i + 1]
        work[W_SPIN + k] = 0.5 * (position[j + 2] + position[i + 2])
        work[W_BEND + k] = position[j + 2] - position[i + 2]
    for k in range(lanes, LANES):
        work[W_X + k] = 1.0
        work[W_Y + k] = 0.0
        work[W_SPIN + k] = 0.0
        work[W_BEND + k] = 0.0


@part
def follow(block, work):
    """Update the frames of a block and find gap and shear displacement.

    The shear displacement comes from the turn of the frame and the rotations, not from velocities, so that a rigid
    rotation by any angle gives none. On return ``W_X`` holds the gap.
    """
    for k in range(LANES):
        dx = work[W_X + k]
        dy = work[W_Y + k]
        spin = work[W_SPIN + k]
        bend = work[W_BEND + k]
        length = (dx * dx + dy * dy) ** 0.5
        inverse = 1.0 / length
        normal_x = dx * inverse
        normal_y = dy * inverse
        turn = block[NORMAL_X + k] * normal_y - block[NORMAL_Y + k] * normal_x
        turn += turn * turn * turn * (1.0 / 6.0)
        work[W_SLIP + k] = length * (turn - (spin - block[SPIN + k])) + 0.5 * block[DIFFERENCE + k] * (
            bend - block[BEND + k]
        )
        work[W_LENGTH + k] = length
        work[W_X + k] = length - block[DISTANCE + k]
        block[NORMAL_X + k] = normal_x
        block[NORMAL_Y + k] = normal_y
        block[SPIN + k] = spin
        block[BEND + k] = bend


@part
def respond_whole(block, work, stiffness_ratio, strength_tensile, cohesion, tangent, reach):
    """Response of a block without a broken element; return the number of joints that reach their strength."""
    flexibility = 1.0 / stiffness_ratio
    failing = 0
    for k in range(LANES):
        stiffness = block[STIFFNESS + k]
        stress_shear = block[STRESS_SHEAR + k] + stiffness * flexibility * work[W_SLIP + k]
        block[STRESS_SHEAR + k] = stress_shear
        normal, shear, moment, largest = joint_intact(
            work[W_X + k], block[BEND + k], stress_shear, block[HALF_LENGTH + k], stiffness, reach
        )
        work[W_NORMAL + k] = normal
        work[W_SHEAR + k] = shear
        work[W_MOMENT + k] = moment
        failing += (largest > strength_tensile) | (abs(stress_shear) > cohesion - largest * tangent)
    return failing


@part
def open_block(block, work, elements):
    """Give every element of a block its own shear stress, before the first of them breaks."""
    for e in range(1, elements):
        for k in range(LANES):
            block[STRESS_SHEAR + e * LANES + k] = block[STRESS_SHEAR + k]
    for k in range(LANES):
        work[W_SLIP + k] = 0.0


@part
def respond_element(block, work, e, elements, stiffness_ratio, strength_tensile, cohesion, tangent, friction):
    """Add the response of element `e` of each joint; return the number of breaks and the work of friction.

    The views of the element's own fields keep the loop free of offsets that depend on `e`, with which it would not
    vectorise.
    """
    breaks = 0
    loss = 0.0
    stress = block[STRESS_SHEAR + e * LANES : STRESS_SHEAR + (e + 1) * LANES]
    bonds = block[BONDED + e * LANES : BONDED + (e + 1) * LANES]
    for k in range(LANES):
        stiffness = block[STIFFNESS + k]
        half_length = block[HALF_LENGTH + k] / elements
        rotation = block[BEND + k]
        bonded = bonds[k]
        before = stress[k]
        offset = (2 * e + 1 - elements) * half_length
        gap = work[W_X + k] - rotation * offset
        trial = before + stiffness / stiffness_ratio * work[W_SLIP + k]

        mode = bonded * element_failure(stiffness * gap, trial, strength_tensile, cohesion, tangent)
        held = bonded if mode == 0.0 else 0.0
        force, moment, energy = element_closure(held, gap, rotation, half_length, stiffness)
        width = 2.0 * half_length
        slipped = element_slip(trial, force / width if width > 0.0 else 0.0, friction)
        after = trial if held != 0.0 else slipped

        softness = stiffness_ratio / stiffness if stiffness > 0.0 else 0.0
        loss += (1.0 - bonded) * 0.5 * (before + after) * (trial - after) * softness * width
        whole = stiffness * half_length * (gap * gap + rotation * rotation * half_length * half_length / 3.0)
        work[W_RELEASED + k] = whole - energy + 0.5 * (trial * trial - after * after) * softness * width
        work[W_MODE + k] = mode
        breaks += mode != 0.0

        bonds[k] = held
        stress[k] = after
        work[W_NORMAL + k] += force
        work[W_SHEAR + k] += after * width
        work[W_MOMENT + k] += offset * force + moment
    return breaks, loss


@part
def record_cracks(log, count, tally, block, work, position, first, owner, start, lanes, e, elements, step):
    """Log the breaks of element `e` in a block, in the order of the lanes."""
    for k in range(lanes):
        if work[W_MODE + k] != 0.0:
            i = first[start + k]
            normal_x = block[NORMAL_X + k]
            normal_y = block[NORMAL_Y + k]
            lever = 0.5 * (work[W_LENGTH + k] + block[DIFFERENCE + k])
            offset = (2 * e + 1 - elements) * block[HALF_LENGTH + k] / elements
            row = count[0] * CRACK
            log[row] = step
            log[row + 1] = position[i] + lever * normal_x - offset * normal_y
            log[row + 2] = position[i + 1] + lever * normal_y + offset * normal_x
            log[row + 3] = normal_x
            log[row + 4] = normal_y
            log[row + 5] = 2.0 * owner[start + k] + work[W_MODE + k] - 1.0
            count[0] += 1
            tally[FRACTURE] += work[W_RELEASED + k]


@part
def respond_broken(
    block, work, elements, stiffness_ratio, strength_tensile, cohesion, tangent, friction,
    log, count, tally, position, first, owner, start, lanes, step,
):  # fmt: skip
    """Response of a block with broken elements."""
    for k in range(LANES):
        work[W_NORMAL + k] = 0.0
        work[W_SHEAR + k] = 0.0
        work[W_MOMENT + k] = 0.0
        block[SHIFT + k] += work[W_SLIP + k]
    for e in range(elements):
        breaks, loss = respond_element(
            block, work, e, elements, stiffness_ratio, strength_tensile, cohesion, tangent, friction
        )
        tally[FRICTION] += loss
        if breaks > 0:
            record_cracks(log, count, tally, block, work, position, first, owner, start, lanes, e, elements, step)


@part
def resolve(block, work):
    """Turn the resultants of a block into force and moments on the discs.

    The force acts at the middle of the overlap or gap, the same point for both discs, so that momentum and angular
    momentum are conserved.
    """
    for k in range(LANES):
        normal_x = block[NORMAL_X + k]
        normal_y = block[NORMAL_Y + k]
        normal = work[W_NORMAL + k]
        shear = work[W_SHEAR + k]
        moment = work[W_MOMENT + k]
        half = 0.5 * work[W_LENGTH + k]
        skew = 0.5 * block[DIFFERENCE + k]
        work[W_X + k] = normal * normal_x - shear * normal_y
        work[W_Y + k] = normal * normal_y + shear * normal_x
        work[W_SPIN + k] = (half + skew) * shear - moment
        work[W_BEND + k] = (half - skew) * shear + moment


@part
def scatter(force, work, first, second, start, lanes):
    """Add forces and moments of a block to its discs."""
    for k in range(lanes):
        i = first[start + k]
        j = second[start + k]
        force_x = work[W_X + k]
        force_y = work[W_Y + k]
        force[i] += force_x
        force[i + 1] += force_y
        force[i + 2] += work[W_SPIN + k]
        force[j] -= force_x
        force[j + 1] -= force_y
        force[j + 2] += work[W_BEND + k]


@part
def add_joint_forces(force, joints, cracks, tally, position, law, step):
    """Add the forces of all joints to the discs; break elements that reach their strength.

    Parameters
    ----------
    force : float array, shape (4 n_discs,)
        Forces [N/m] and moments [N]; added to.
    joints, cracks : tuples of arrays
        Joints and log of cracks; modified in place.
    tally : float array
        Energies [J/m]; added to.
    position : float array, shape (4 n_discs,)
        Positions [m] and rotations [rad].
    law : tuple of floats
        Parameters of the joints.
    step : int
        Number of the step, for the log.
    """
    reach = (law.elements - 1.0) / law.elements
    work = joints.work
    for b in range(joints.tidiness[IN_USE]):
        block = joints.state[b]
        start = b * LANES
        lanes = joints.lanes[b]
        gather(work, position, joints.lane_first, joints.lane_second, start, lanes)
        follow(block, work)
        if joints.broken[b] == 0:
            failing = respond_whole(
                block, work, law.stiffness_ratio, law.strength_tensile, law.cohesion, law.tangent, reach
            )
            if failing > 0:
                joints.broken[b] = 1
                open_block(block, work, law.elements)
        if joints.broken[b] != 0:
            respond_broken(
                block, work, law.elements, law.stiffness_ratio, law.strength_tensile, law.cohesion, law.tangent,
                law.friction, cracks.log, cracks.count, tally, position, joints.lane_first, joints.owner, start, lanes,
                step,
            )  # fmt: skip
        resolve(block, work)
        scatter(force, work, joints.lane_first, joints.lane_second, start, lanes)
