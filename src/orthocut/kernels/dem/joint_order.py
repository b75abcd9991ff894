"""Which joint is computed where: whole joints share blocks, broken ones share others, removed ones have none.

A block with one broken element takes the general path for all its joints, and a removed joint is computed until its
lane is given away. Joints are therefore sorted anew when the work that this would have saved has reached the work of
sorting.
"""

from orthocut.kernels.dem.layout import BONDED, DISTANCE, FIELDS, LANES, NORMAL_X, SHIFT
from orthocut.kernels.jit import part

IN_USE, WHOLE, NEEDLESS = 0, 1, 2
"""Places in `Joints.tidiness`: blocks in use; blocks of whole joints, which come first; needless work since the last
sort, in lanes of removed joints times checks."""

OPENED = 20
"""Needless work of a whole block that takes the general path, in lanes of removed joints."""
PATIENCE = 100
"""Needless work that costs as much as to sort, measured with the cut of 2085 discs."""


@part
def is_whole(state, place, elements):
    """Whether all elements of the joint at a place are bonded."""
    bonded = 0.0
    for e in range(elements):
        bonded += state[place // LANES, BONDED + e * LANES + place % LANES]
    return bonded == elements


@part
def clear_lane(block, k):
    """Make a lane harmless: a joint of no stiffness between two points at unit distance."""
    for field in range(0, FIELDS, LANES):
        block[field + k] = 0.0
    block[DISTANCE + k] = 1.0
    block[NORMAL_X + k] = 1.0


@part
def sort_joints(joints, elements):
    """Give whole joints the first blocks and other live ones the next, both in the order of the joints."""
    joints.spare[:] = joints.state
    whole = 0
    for b in range(joints.first.size):
        if joints.live[b] != 0 and is_whole(joints.spare, joints.place[b], elements):
            whole += 1
    blocks = (whole + LANES - 1) // LANES
    joints.owner[:] = -1
    joints.lanes[:] = 0
    place_whole, place_other = 0, blocks * LANES
    for b in range(joints.first.size):
        before = joints.place[b]
        joints.place[b] = -1
        if joints.live[b] == 0:
            continue
        if is_whole(joints.spare, before, elements):
            place = place_whole
            place_whole += 1
        else:
            place = place_other
            place_other += 1
        block, k = joints.state[place // LANES], place % LANES
        for field in range(0, FIELDS, LANES):
            block[field + k] = joints.spare[before // LANES, field + before % LANES]
        if place < blocks * LANES:
            block[SHIFT + k] = 0.0
        joints.place[b] = place
        joints.owner[place] = b
        joints.lane_first[place] = joints.first[b]
        joints.lane_second[place] = joints.second[b]
        joints.lanes[place // LANES] += 1
    for place in range(joints.owner.size):
        if joints.owner[place] < 0:
            clear_lane(joints.state[place // LANES], place % LANES)
    for b in range(joints.broken.size):
        joints.broken[b] = b >= blocks
    joints.tidiness[IN_USE] = (place_other + LANES - 1) // LANES
    joints.tidiness[WHOLE] = blocks
    joints.tidiness[NEEDLESS] = 0


@part
def keep_tidy(joints, elements):
    """Sort the joints if that pays; called between steps, always after the same number of them."""
    opened = 0
    for b in range(joints.tidiness[WHOLE]):
        opened += joints.broken[b]
    dead = 0
    for place in range(joints.tidiness[IN_USE] * LANES):
        b = joints.owner[place]
        dead += b >= 0 and joints.live[b] == 0
    joints.tidiness[NEEDLESS] += OPENED * opened + dead
    if joints.tidiness[NEEDLESS] >= PATIENCE:
        sort_joints(joints, elements)
