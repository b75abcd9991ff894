"""Shape functions of material points: uGIMP.

Bardenhagen & Kober (2004), CMES 5, 477-496.
"""

import math

from orthocut.kernels.jit import inline


@inline
def gimp_weights(r, half):
    """Weights of the left, nearest and right node for a particle.

    Parameters
    ----------
    r : float
        Position minus that of the nearest node, over the cell size, in [-1/2, 1/2].
    half : float
        Half-width of the particle over the cell size, up to 1/2.

    Returns
    -------
    left, centre, right : float
        Weights; their sum is one.
    left_slope, centre_slope, right_slope : float
        Derivatives by position times the cell size; their sum is zero.
    """
    t = min(max(half - r, 0.0), 2.0 * half)
    u = 2.0 * half - t
    share = 0.25 / half
    left = share * t * t + max(-half - r, 0.0)
    right = share * u * u + max(r - half, 0.0)
    slope = 2.0 * share
    return left, 1.0 - left - right, right, -slope * t, slope * (t - u), slope * u


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
