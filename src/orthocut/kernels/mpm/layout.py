"""Memory layout of material points and grid nodes.

Points stand in blocks of `LANES`; field f of lane k of block b is at ``b * BLOCK + f * LANES + k`` of one flat array.
Lanes that pad the last block of a body have no mass. The quantities of a node stand side by side, one cache line.
"""

LANES = 64

# fields of a point
X, Y = 0, 1  # position [m]
VX, VY = 2, 3  # velocity [m/s]
FXX, FXY, FYX, FYY = 4, 5, 6, 7  # deformation gradient
BXX, BYY, BXY = 8, 9, 10  # isochoric elastic left Cauchy-Green tensor; its determinant is one, which gives BZZ
EPS = 11  # cumulative plastic strain
MASS = 12  # mass per unit width [kg/m]
POINT_FIELDS = 13
BLOCK = POINT_FIELDS * LANES

# A block is copied to a work array that holds, behind the fields, what lives only within a pass over the points: with
# one array and constant offsets LLVM needs no alias checks and vectorises the loops over lanes.
WX, GX, WY, GY = 13, 16, 19, 22  # three weights, three slopes in each direction
CORNER = 25  # index of the lower left of the 3 x 3 nodes
DXX, DXY, DYX, DYY = 26, 27, 28, 29  # velocity gradient times cell size [m/s]
TXX, TYY, TXY = 30, 31, 32  # Kirchhoff stress times initial volume over cell size [N/m]
RX, RY = 33, 34  # place relative to the nearest node, in cells
HX, HY = 35, 36  # velocity of the nodes before the forces, at the point [m/s]
UX, UY = 37, 38  # velocity before the step [m/s], then displacement in the step [m]
WORK = 39 * LANES

# quantities of a node
NM = 0  # mass [kg/m]
NPX, NPY = 1, 2  # momentum per unit width [kg/s]
NMARK = 3  # mass of loose nodes that the node carries along [kg/m], or that it is loose itself, see support.py
NFX, NFY = 4, 5  # force [N/m]
NVX, NVY = 6, 7  # velocity at the end of the step [m/s]
NODE = 8

# bodies; each has a velocity field of its own
CHIP, BASE = 0, 1
