"""Shape functions: uGIMP for two points a cell and direction, and bilinear ones for interface points.

Bardenhagen & Kober (2004), CMES 5, 477-496.
"""

import math

from orthocut.kernels.jit import inline


@inline
def gimp_weights(r):
    """Weights of the left, nearest and right node for a particle of half-width h/4.

    Parameters
    ----------
    r : float
        Position minus that of the nearest node, over the cell size, in [-1/2, 1/2].

    Returns
    -------
    left, centre, right : float
        Weights; their sum is one.
    left_slope, centre_slope, right_slope : float
        Derivatives by position times the cell size; their sum is zero.
    """
    t = min(max(0.25 - r, 0.0), 0.5)
    u = 0.5 - t
    left = t * t + max(-0.25 - r, 0.0)
    right = u * u + max(r - 0.25, 0.0)
    return left, 1.0 - left - right, right, -2.0 * t, 2.0 * (t - u), 2.0 * u


@inline
def nearest_node(x, count):
    """Index of the node nearest to a place, as a float, kept one node away from the ends of the grid.

    Parameters
    ----------
    x : float
        Place in cells from node 0.
    count : int
        Number of nodes.
    """
    return min(max(math.floor(x + 0.5), 1.0), count - 2.0)
