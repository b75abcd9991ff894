"""Which points are near the tool, and which nodes touch it."""

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.contact import list_near_points, mark_contact_nodes
from orthocut.kernels.mpm.contact_cells import REACH, mark_cells, sum_tool
from orthocut.kernels.mpm.layout import BASE, CHIP

RELIST = 0.25
"""Travel of the tool, in cells, after which the points near it are listed anew."""
_REACH = 2.0  # points so near the tool, in cells, are looked at


@part
def list_near(points, blocks, wedge, tip, frame, space):
    """List the points of chip and base near the tool; return how many there are of each."""
    reach = (REACH if wedge.by_cells else _REACH) * frame.cell
    chip = list_near_points(space.near[CHIP], points, blocks[CHIP], CHIP, wedge, tip, reach)
    base = list_near_points(space.near[BASE], points, blocks[BASE], BASE, wedge, tip, reach)
    return chip, base


@part
def place_tool(chip_extent, base_extent, wedge, tip, frame, space):
    """Put the tool on the grid if contact is found there; return the number of nodes that see it.

    Parameters
    ----------
    chip_extent, base_extent : int array, shape (4,)
        Columns and rows that each body reaches.
    wedge : Wedge
        Tool.
    tip : float
        Place of the tool tip along the cut [m].
    frame : Frame
        Grid.
    space : Workspace
        Work space; `remove_tool` clears it.
    """
    if not wedge.by_cells:
        return 0
    top = frame.origin_y + chip_extent[3] * frame.cell
    right = frame.origin_x + base_extent[1] * frame.cell
    return sum_tool(space.tool_sums, space.tool_nodes, wedge, tip, right, top, frame)


@part
def mark_touching(points, near, tool_nodes, body, wedge, tip, frame, space):
    """List the nodes of a body that touch the tool in `space.marked`; return how many there are.

    Parameters
    ----------
    points : float array
        Points of all bodies.
    near : int
        Number of points of the body near the tool, see `list_near`.
    tool_nodes : int
        Number of nodes that see the tool, see `place_tool`.
    body : int
        CHIP or BASE.
    wedge, tip, frame, space
        See `place_tool`.
    """
    if wedge.by_cells:
        return mark_cells(
            space.marked[body],
            space.tool_sums,
            space.tool_nodes,
            tool_nodes,
            space.body_sums,
            points,
            space.near[body],
            near,
            body,
            wedge,
            tip,
            frame,
        )
    return mark_contact_nodes(space.marked[body], space.listed, points, space.near[body], near, body, wedge, tip, frame)
