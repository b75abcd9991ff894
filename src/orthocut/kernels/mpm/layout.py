"""Memory layout of material points and grid nodes.

Points stand in blocks of `LANES`; field f of lane k of block b is at ``b * BLOCK + f * LANES + k`` of one flat array, so
that one base pointer with constant offsets serves all fields and loops over lanes vectorise. Lanes that pad the last
block of a body have no mass. The quantities of a node stand side by side and fill one cache line.
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

# quantities of a node
NM = 0  # mass [kg/m]
NPX, NPY = 1, 2  # momentum per unit width [kg/s]
NFX, NFY = 3, 4  # force [N/m]
NMARK = 5  # marks of the contact pass: 0 none, 1 touches the tool
NVX, NVY = 6, 7  # velocity at the end of the step [m/s]
NODE = 8

# bodies; each has a velocity field of its own
CHIP, BASE = 0, 1
