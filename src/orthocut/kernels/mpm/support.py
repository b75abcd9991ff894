"""Nodes with little mass follow the firm nodes beside them.

A node just outside of the material is served by the corners of one or two points. Left alone it moves until the stress
of these points, and not its mass, balances it: they yield to it, and since deformations are summed up step by step they
do not come back when the node is left behind. A bent chip loses energy so at both surfaces, at each crossing of a cell,
whatever the speed and the time step; smaller cells help only in proportion to their size.

A loose node therefore has no motion of its own. Its force goes to the firm nodes on lines that lead into the material,
and it moves with the straight line through their changes of velocity: v1 - (v2 - v1) for the nearest and the next node.
Forces, masses and velocities use the same weights, so that forces keep their sum and their moment, a force that all
nodes feel alike moves all alike, and linear fields of velocity stay exact. Between no mass and the mass of a firm node
the own motion fades in. Contact comes first: it acts on firm nodes, with the masses that they carry along, and loose
nodes follow what is left. Loose nodes that move as if there were no contact, while contact holds the firm ones that
took their forces, make energy in each step. The idea is that of aggregated finite elements (Badia,
Verdugo & Martin 2018, Comput. Methods Appl. Mech. Eng. 336, 533).
"""

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.layout import NFX, NFY, NM, NMARK, NODE, NPX, NPY, NVX, NVY

DIRECTIONS = 8
LOOSE = -1.0
"""Mark of a loose node, from before the update of the grid to the end of the step."""

_DIAGONAL = 0.25  # weight of a diagonal line over that of a line along the grid
_LEAST = 1e-6  # weight of a line of nodes that are just firm


@part
def _offset(direction, frame):
    """Column, row and index of the nearest node in one of the eight directions, relative to a node."""
    k = direction if direction < 4 else direction + 1
    column, row = k % 3 - 1, k // 3 - 1
    return column, row, row * frame.count_x + column


@part
def lean_on_firm_nodes(grid, extent, loose, weights, frame, free):
    """List the loose nodes of a body and hand their forces and masses to firm nodes.

    Parameters
    ----------
    grid : float array
        Nodes of the body, marks zero. Firm nodes receive forces, and masses in their marks, of which some are less than
        zero [kg/m]; loose nodes are marked and keep their own force.
    extent : int array, shape (4,)
        First and last column, first and last row of the nodes in use.
    loose : int array, shape (n_nodes,)
        Receives the indices of the loose nodes.
    weights : float array, shape (n_nodes, DIRECTIONS)
        Receives the weight of the line in each direction; the sum is one.
    frame : Frame
        Grid.
    free : int array, shape (4,)
        First and last column, first and last row of the nodes that are not held; no node leans on others.

    Returns
    -------
    int
        Number of loose nodes. Nodes without a line of two firm nodes move on their own.
    """
    firm = frame.mass_firm
    left, right = max(extent[0], free[0]), min(extent[1], free[1])
    lower, upper = max(extent[2], free[2]), min(extent[3], free[3])
    count = 0
    for j in range(lower, upper + 1):
        for i in range(left, right + 1):
            node = j * frame.count_x + i
            mass = grid[node * NODE + NM]
            if mass <= frame.mass_small or mass >= firm:
                continue
            total = 0.0
            for d in range(DIRECTIONS):
                column, row, step = _offset(d, frame)
                weights[count, d] = 0.0
                if left <= i + 2 * column <= right and lower <= j + 2 * row <= upper:
                    first = grid[(node + step) * NODE + NM] - firm
                    second = grid[(node + 2 * step) * NODE + NM] - firm
                    if first >= 0.0 and second >= 0.0:
                        straight = column == 0 or row == 0
                        weight = (1.0 if straight else _DIAGONAL) * (first * second + _LEAST * firm * firm)
                        weights[count, d] = weight
                        total += weight
            if total == 0.0:
                continue
            given = 1.0 - (mass / firm) ** 2
            for d in range(DIRECTIONS):
                weights[count, d] /= total
                share = given * weights[count, d]
                if share > 0.0:
                    step = _offset(d, frame)[2]
                    first, second = (node + step) * NODE, (node + 2 * step) * NODE
                    fx, fy = share * grid[node * NODE + NFX], share * grid[node * NODE + NFY]
                    grid[first + NFX] += 2.0 * fx
                    grid[first + NFY] += 2.0 * fy
                    grid[second + NFX] -= fx
                    grid[second + NFY] -= fy
                    grid[first + NMARK] += 2.0 * share * mass
                    grid[second + NMARK] -= share * mass
            grid[node * NODE + NMARK] = LOOSE
            loose[count] = node
            count += 1
    return count


@part
def follow_firm_nodes(grid, loose, weights, count, frame):
    """Move the loose nodes with the firm ones.

    Parameters
    ----------
    grid : float array
        Nodes of the body, firm ones with their new velocities.
    loose, weights, count
        Loose nodes, see `lean_on_firm_nodes`.
    frame : Frame
        Grid.
    """
    for k in range(count):
        node = loose[k]
        at = node * NODE
        mass = grid[at + NM]
        own = (mass / frame.mass_firm) ** 2
        change_x = change_y = 0.0
        for d in range(DIRECTIONS):
            weight = weights[k, d]
            if weight > 0.0:
                step = _offset(d, frame)[2]
                first, second = (node + step) * NODE, (node + 2 * step) * NODE
                one, two = 2.0 * weight / grid[first + NM], weight / grid[second + NM]
                change_x += 2.0 * weight * grid[first + NVX] - weight * grid[second + NVX]
                change_y += 2.0 * weight * grid[first + NVY] - weight * grid[second + NVY]
                change_x -= one * grid[first + NPX] - two * grid[second + NPX]
                change_y -= one * grid[first + NPY] - two * grid[second + NPY]
        rate = own * frame.time_step
        grid[at + NVX] = (grid[at + NPX] + rate * grid[at + NFX]) / mass + (1.0 - own) * change_x
        grid[at + NVY] = (grid[at + NPY] + rate * grid[at + NFY]) / mass + (1.0 - own) * change_y


@part
def work_of_loose_forces(grid, grid_before, loose, weights, count, frame):
    """Work of the forces of loose nodes that firm nodes have not taken over; see `grid.work_of_forces` [J/m]."""
    work = 0.0
    for k in range(count):
        node = loose[k]
        at = node * NODE
        mass = grid[at + NM]
        given = 1.0 - (mass / frame.mass_firm) ** 2
        vx, vy = grid[at + NPX] / mass, grid[at + NPY] / mass
        if grid_before[at + NM] > frame.mass_small:
            vx, vy = grid_before[at + NVX], grid_before[at + NVY]
        vx += grid[at + NVX]
        vy += grid[at + NVY]
        for d in range(DIRECTIONS):
            share = given * weights[k, d]
            if share > 0.0:
                step = _offset(d, frame)[2]
                first, second = (node + step) * NODE, (node + 2 * step) * NODE
                vx -= share * 2.0 * (grid[first + NVX] + grid_before[first + NVX])
                vy -= share * 2.0 * (grid[first + NVY] + grid_before[first + NVY])
                vx += share * (grid[second + NVX] + grid_before[second + NVX])
                vy += share * (grid[second + NVY] + grid_before[second + NVY])
        work += grid[at + NFX] * vx + grid[at + NFY] * vy
    return 0.5 * frame.time_step * work
