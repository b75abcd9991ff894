"""Where the numbers of the joints lie in memory.

Joints lie in blocks of 64 lanes in one array of shape (n_blocks, FIELDS). Within a block, field f of lane k is at
``f + k`` where f is one of the offsets below. Loops over the lanes of a block see constant offsets from one base, which
lets the compiler vectorise them; one array a field does not. `WORK` offsets are those of the scratch of one block.

Discs lie in rows of four numbers: x, y, rotation, nothing. Indices of discs in joints and contacts are multiplied by
four, so that they point to the first number of the row.
"""

LANES = 64
"""Joints in a block."""
ROW = 4
"""Numbers in a disc's row."""
ELEMENTS = 4
"""Largest number of elements of a joint."""

DISTANCE = 0 * LANES
"""Distance of the centres at which the faces touch [m]."""
HALF_LENGTH = 1 * LANES
"""Half-length of the faces [m]."""
STIFFNESS = 2 * LANES
"""Normal stiffness [Pa/m]; zero for removed joints and unused lanes."""
DIFFERENCE = 3 * LANES
"""Radius of the first disc less that of the second [m]."""
NORMAL_X = 4 * LANES
"""Normal at the last step, from the first to the second disc."""
NORMAL_Y = 5 * LANES
SPIN = 6 * LANES
"""Mean rotation of both discs at the last step [rad]."""
BEND = 7 * LANES
"""Rotation of the second disc less that of the first at the last step [rad]."""
STRESS_SHEAR = 8 * LANES
"""Shear stress [Pa] of the elements; in a whole block only the first is kept, since all are equal."""
BONDED = (8 + ELEMENTS) * LANES
"""1 while an element is bonded, else 0."""
SHIFT = (8 + 2 * ELEMENTS) * LANES
"""Shear displacement since the block takes the general path [m]."""
FIELDS = (9 + 2 * ELEMENTS) * LANES
"""Numbers in a block."""

W_X = 0 * LANES
"""Vector from the first to the second disc, then the force on the first disc."""
W_Y = 1 * LANES
W_SPIN = 2 * LANES
"""Mean rotation, then the moment on the first disc."""
W_BEND = 3 * LANES
"""Relative rotation, then the moment on the second disc."""
W_LENGTH = 4 * LANES
"""Distance of the centres [m]."""
W_SLIP = 5 * LANES
"""Shear displacement in the step [m]."""
W_NORMAL = 6 * LANES
"""Resultants: normal force, shear force, moment."""
W_SHEAR = 7 * LANES
W_MOMENT = 8 * LANES
W_MODE = 9 * LANES
"""Mode of failure of the element at hand."""
W_RELEASED = 10 * LANES
"""Energy released by the failure of the element at hand [J/m]."""
WORK = 11 * LANES
"""Numbers in the scratch."""

DAMPING, FRICTION, FRACTURE, GRIP = 0, 1, 2, 3
"""Places in the tally of energies [J/m]: removed by damping, by friction, by breaking; work done by driven discs."""
TALLY = 4

CRACK = 6
"""Numbers in a row of the crack log: step, x, y, normal x, normal y, 2 joint + mode (0 tension, 1 shear)."""

TIP_X, TIP_Y, FIRST_X, FIRST_Y, SECOND_X, SECOND_Y, SPEED_X, SPEED_Y = range(8)
"""Columns of a wall: a convex wedge with a tip, two faces given by their outward normals, and a velocity."""
WALL_FRICTION, WALL_STIFFNESS, WALL_FORCE_X, WALL_FORCE_Y, WALL_SUM_X, WALL_SUM_Y, WALL_PEAK_X, WALL_PEAK_Y = range(
    8, 16
)
"""Friction, normal stiffness [Pa]; force on the wall in the last step, its sum over steps and its peaks."""
WALL_WORK = 16
"""Work done by the wall [J/m]."""
WALL = 17
"""Numbers in the row of a wall."""
