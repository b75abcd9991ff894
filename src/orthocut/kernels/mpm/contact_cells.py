"""Which nodes touch the tool by the rule of Nairn's program: particles of the tool on the grid.

The rigid tool is a layer of particles along both faces, two cells deep and four particles a cell, in rows that are
parallel to the faces. A node touches when material and tool, each at its mean position as the node sees it, are nearer
to each other than 0.8 cells along the normal of contact. The tool so acts ahead of its faces: by 0.75 to 0.86 cells
where flush faces meet.
"""

import math

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.contact import normal_of
from orthocut.kernels.mpm.layout import BLOCK, LANES, MASS, NODE, X, Y
from orthocut.kernels.mpm.shape import gimp_weights, nearest_node

REACH = 4.0
"""Points so near the tool, in cells, may share a node with it, also after it has moved by a quarter of a cell."""
_DEEP = 4  # particles across the layer
_GAP = 0.8  # distance of the mean positions in contact, in cells


@part
def sum_tool(tool_sums, tool_nodes, wedge, tip, right, top, frame):
    """Volume of the tool and its moments at the nodes.

    Parameters
    ----------
    tool_sums : float array, shape (n_nodes, 3)
        Zero everywhere; receives volume over that of a particle, and this times place from the tip [m].
    tool_nodes : int array, shape (n_nodes,)
        Receives the nodes that see the tool.
    wedge : Wedge
        Tool.
    tip : float
        Place of the tool tip along the cut; its height is zero [m].
    right, top : float
        Particles beyond are left out [m].
    frame : Frame
        Grid.

    Returns
    -------
    int
        Number of nodes listed.
    """
    spacing = 0.5 * frame.cell
    lean, rise = math.tan(wedge.rake_angle), math.tan(wedge.clearance_angle)
    rows = max(int(top / spacing), 0) + _DEEP
    columns = max(int((right - tip) / spacing), 0) + _DEEP
    count = 0
    for row in range(rows):
        for column in range(columns if row < _DEEP else _DEEP):
            along_rake, along_bottom = (row + 0.5) * spacing, (column + 0.5) * spacing
            dx = along_rake * lean + along_bottom
            dy = along_rake + along_bottom * rise
            x = (tip + dx - frame.origin_x) * frame.inv_cell
            y = (dy - frame.origin_y) * frame.inv_cell
            i, j = nearest_node(x, frame.count_x), nearest_node(y, frame.count_y)
            if abs(x - i) > 0.5 or abs(y - j) > 0.5:  # outside of the grid
                continue
            weights_x, weights_y = gimp_weights(x - i, 0.25), gimp_weights(y - j, 0.25)
            for k in range(3):
                for c in range(3):
                    node = (int(j) - 1 + k) * frame.count_x + int(i) - 1 + c
                    weight = weights_x[c] * weights_y[k]
                    if weight <= 0.0:
                        continue
                    if tool_sums[node, 0] == 0.0:
                        tool_nodes[count] = node
                        count += 1
                    tool_sums[node, 0] += weight
                    tool_sums[node, 1] += weight * dx
                    tool_sums[node, 2] += weight * dy
    return count


@part
def remove_tool(tool_sums, tool_nodes, tool_count):
    """Set the sums of the tool to zero again."""
    for k in range(tool_count):
        for c in range(3):
            tool_sums[tool_nodes[k], c] = 0.0


@part
def mark_cells(marked, tool_sums, tool_nodes, tool_count, body_sums, points, near, near_count, body, wedge, tip, frame):
    """List the nodes of a body where material and tool are nearer than 0.8 cells along the normal.

    Parameters
    ----------
    marked : int array
        Receives the offsets of the nodes.
    tool_sums, tool_nodes, tool_count
        Tool at the nodes, see `sum_tool`.
    body_sums : float array, shape (n_nodes, 2)
        Work space, zero everywhere; left so.
    points : float array
        Points of all bodies.
    near, near_count
        Points to look at, see `contact.list_near_points`; all that share a node with the tool must be among them.
    body : int
        CHIP or BASE.
    wedge : Wedge
        Tool.
    tip : float
        Place of the tool tip along the cut [m].
    frame : Frame
        Grid.

    Returns
    -------
    int
        Number of nodes listed.
    """
    nx, ny = normal_of(body, wedge)
    for k in range(near_count):
        start = near[k] // LANES * BLOCK
        lane = near[k] % LANES
        px, py = points[start + X * LANES + lane], points[start + Y * LANES + lane]
        mass = points[start + MASS * LANES + lane]
        distance = (px - tip) * nx + py * ny
        x, y = (px - frame.origin_x) * frame.inv_cell, (py - frame.origin_y) * frame.inv_cell
        i, j = nearest_node(x, frame.count_x), nearest_node(y, frame.count_y)
        half = frame.half_point
        weights_x, weights_y = gimp_weights(x - i, half), gimp_weights(y - j, half)
        for row in range(3):
            for column in range(3):
                node = (int(j) - 1 + row) * frame.count_x + int(i) - 1 + column
                if tool_sums[node, 0] > 0.0:
                    share = mass * weights_x[column] * weights_y[row]
                    body_sums[node, 0] += share
                    body_sums[node, 1] += share * distance
    count = 0
    for k in range(tool_count):
        node = tool_nodes[k]
        if body_sums[node, 0] > 0.0:
            tool = (tool_sums[node, 1] * nx + tool_sums[node, 2] * ny) / tool_sums[node, 0]
            if tool - body_sums[node, 1] / body_sums[node, 0] < _GAP * frame.cell:
                marked[count] = node * NODE
                count += 1
        body_sums[node, 0] = body_sums[node, 1] = 0.0
    return count
