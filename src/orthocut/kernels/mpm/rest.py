"""Material far from the tool rests: its points are not looked at, and nodes that they would share are held still.

Points stand in blocks along the cut. Blocks wake up before the tool comes near, and those of the base go to sleep where
it has passed; the range in between is one piece. A sleeping point keeps its place and its stress. Every node that one
reaches is held, so a point that wakes up finds nodes at rest, and neither forces nor masses are missed at the seam.
"""

import math

from orthocut.kernels.jit import jit, part
from orthocut.kernels.mpm.layout import BASE, BLOCK, CHIP, LANES, MASS, VX, VY, X
from orthocut.kernels.mpm.shape import nearest_node

PAIRS = 2
"""Row of the pairs of the interface in the table of what is awake, behind those of the bodies."""
AWAKE = 3
BEHIND = 0.5
"""Distance behind the tool beyond which material rests, over that ahead of it."""


@part
def _ends(points, block):
    """Least and largest x of the points of a block that have mass [m]."""
    low, high = math.inf, -math.inf
    for lane in range(block * BLOCK, block * BLOCK + LANES):
        if points[lane + MASS * LANES] > 0.0:
            low = min(low, points[lane + X * LANES])
            high = max(high, points[lane + X * LANES])
    return low, high


@jit
def wake_ahead(points, blocks, awake, tip, frame):
    """Wake the blocks that the tool comes near to, before points move.

    Parameters
    ----------
    points, blocks, awake, tip, frame
        See `rest_behind`.
    """
    for body in (CHIP, BASE):
        while awake[body, 0] > blocks[body, 0] and _ends(points, awake[body, 0] - 1)[1] > tip - frame.reach:
            awake[body, 0] -= 1


@jit
def rest_behind(points, blocks, upper_x, awake, free, tip, frame):
    """Put to sleep what the tool has left behind, and hold the nodes at both seams, after points have moved.

    Nodes have the momentum of points that go to sleep by then; those that are held from now on pass it to the clamp.

    Parameters
    ----------
    points : float array
        Fields of all points in blocks; velocities of those that go to sleep are set to zero.
    blocks : int array, shape (2, 2)
        First block of each body and first block after it.
    upper_x : float array, shape (n_pairs,)
        Places of the pairs of the interface along the cut [m].
    awake : int array, shape (AWAKE, 2)
        First block of each body that is awake and first one after those; first pair and number of pairs. Set here.
    free : int array, shape (2, 4)
        First and last column, first and last row of the nodes of each body that are not held. Columns are set here.
    tip : float
        Place of the tool tip along the cut [m].
    frame : Frame
        Grid; `reach` says how far ahead of the tool material is awake.
    """
    for body in (CHIP, BASE):
        first, last = awake[body, 0], awake[body, 1]
        while body == BASE and last > first + 1 and _ends(points, last - 1)[0] > tip + BEHIND * frame.reach:
            last -= 1
            for lane in range(last * BLOCK, last * BLOCK + LANES):
                points[lane + VX * LANES] = 0.0
                points[lane + VY * LANES] = 0.0
        awake[body, 1] = last
        free[body, 0], free[body, 1] = 0, frame.count_x - 1
        if first > blocks[body, 0]:
            end = (_ends(points, first - 1)[1] - frame.origin_x) * frame.inv_cell
            free[body, 0] = int(nearest_node(end, frame.count_x)) + 2
        if last < blocks[body, 1]:
            end = (_ends(points, last)[0] - frame.origin_x) * frame.inv_cell
            free[body, 1] = int(nearest_node(end, frame.count_x)) - 2
    free[CHIP, 0] = free[BASE, 0] = max(free[CHIP, 0], free[BASE, 0])  # one seam, or bodies at rest would be pushed
    seam = frame.origin_x + (free[CHIP, 0] - 1) * frame.cell
    while awake[PAIRS, 0] > 0 and upper_x[awake[PAIRS, 0] - 1] > seam:
        awake[PAIRS, 0] -= 1
