"""Contact of material points with the rigid wedge, by exact geometry and prescribed normals.

A node is in contact when a point that it serves reaches through a face of the wedge: the distance of the point from the
face is less than the half-extent of its deformed domain. Momentum is then exchanged along the normals of Nairn (2015)
for a tool that moves towards -x: (cos a, -sin a) for the rake face, (0, 1) for the bottom, from material into tool.
"""

import math

from orthocut.kernels.jit import part
from orthocut.kernels.mpm.grid import moving_mass
from orthocut.kernels.mpm.layout import (
    BASE,
    BLOCK,
    CHIP,
    FXX,
    FXY,
    FYX,
    FYY,
    LANES,
    MASS,
    NM,
    NMARK,
    NODE,
    NPX,
    NPY,
    NVX,
    NVY,
    X,
    Y,
)
from orthocut.kernels.mpm.shape import nearest_node
from orthocut.kernels.mpm.support import LOOSE


@part
def face_of(body, wedge):
    """Unit normal into the tool and direction away from the tip of the face that a body meets."""
    if body == CHIP:
        c, s = math.cos(wedge.rake_angle), math.sin(wedge.rake_angle)
        return c, -s, s, c
    c, s = math.cos(wedge.clearance_angle), math.sin(wedge.clearance_angle)
    return -s, c, c, s


@part
def normal_of(body, wedge):
    """Unit normal of contact of a body, from material into tool."""
    if body == BASE:
        return 0.0, 1.0
    return math.cos(wedge.rake_angle), -math.sin(wedge.rake_angle)


@part
def list_near_points(near, points, blocks, body, wedge, tip, reach):
    """List the points of a body that are within reach of their face of the tool.

    Parameters
    ----------
    near : int array
        Receives block * LANES + lane of each point.
    points, blocks
        Points of all bodies, and the blocks of this one.
    body : int
        CHIP or BASE.
    wedge : Wedge
        Tool.
    tip : float
        Place of the tool tip along the cut; its height is zero [m].
    reach : float
        Distance from the face, and along it beyond the tip, within which points are listed [m].

    Returns
    -------
    int
        Number of points listed.
    """
    nx, ny, tx, ty = face_of(body, wedge)
    count = 0
    for block in range(blocks[0], blocks[1]):
        start = block * BLOCK
        for lane in range(LANES):
            dx = points[start + X * LANES + lane] - tip
            dy = points[start + Y * LANES + lane]
            outside = -(dx * nx + dy * ny)
            along = dx * tx + dy * ty
            if outside < reach and along > -reach and points[start + MASS * LANES + lane] > 0.0:
                near[count] = block * LANES + lane
                count += 1
    return count


@part
def mark_contact_nodes(marked, listed, points, near, near_count, body, wedge, tip, frame):
    """List the nodes of a body that serve a point which reaches through its face of the tool.

    Parameters
    ----------
    marked : int array
        Receives the offsets of the nodes.
    listed : int array, shape (n_nodes,)
        Work space, zero everywhere; left so.
    points : float array
        Points of all bodies.
    near, near_count
        Points to look at, see `list_near_points`.
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
    nx, ny, tx, ty = face_of(body, wedge)
    half_width = frame.half_point * frame.cell
    count = 0
    for k in range(near_count):
        start = near[k] // LANES * BLOCK
        lane = near[k] % LANES
        x, y = points[start + X * LANES + lane], points[start + Y * LANES + lane]
        fxx, fxy = points[start + FXX * LANES + lane], points[start + FXY * LANES + lane]
        fyx, fyy = points[start + FYX * LANES + lane], points[start + FYY * LANES + lane]
        dx, dy = x - tip, y
        extent_normal = half_width * (abs(nx * fxx + ny * fyx) + abs(nx * fxy + ny * fyy))
        extent_along = half_width * (abs(tx * fxx + ty * fyx) + abs(tx * fxy + ty * fyy))
        if -(dx * nx + dy * ny) < extent_normal and dx * tx + dy * ty > -extent_along:
            i = int(nearest_node((x - frame.origin_x) * frame.inv_cell, frame.count_x))
            j = int(nearest_node((y - frame.origin_y) * frame.inv_cell, frame.count_y))
            for row in range(j - 1, j + 2):
                for column in range(i - 1, i + 2):
                    at = (row * frame.count_x + column) * NODE
                    if listed[at // NODE] == 0:
                        listed[at // NODE] = 1
                        marked[count] = at
                        count += 1
    for k in range(count):
        listed[marked[k] // NODE] = 0
    return count


@part
def push_with_tool(grid, marked, marked_count, body, wedge, speed, frame):
    """Exchange momentum between the tool and the firm marked nodes that approach it; Coulomb friction along the face.

    Parameters
    ----------
    grid : float array
        Nodes of the body with their velocities at the end of the step; modified in place.
    marked, marked_count
        Nodes in contact, see `mark_contact_nodes`.
    body : int
        CHIP or BASE.
    wedge : Wedge
        Tool.
    speed : float
        Speed of the tool towards -x [m/s].
    frame : Frame
        Grid.

    Returns
    -------
    impulse_x, impulse_y : float
        Impulse of the tool on the body [N s/m].
    lost_impact, lost_friction : float
        Work of the tool that did not reach the nodes: in impacts and in friction [J/m]. Impulses act at the mean
        velocity of the step, as all forces do.
    """
    nx, ny = normal_of(body, wedge)
    friction = wedge.friction
    impulse_x = impulse_y = lost_impact = lost_friction = 0.0
    for k in range(marked_count):
        at = marked[k]
        mass = grid[at + NM]
        if mass <= frame.mass_small or grid[at + NMARK] == LOOSE:
            continue
        vx, vy = grid[at + NVX], grid[at + NVY]
        dx, dy = -speed - vx, -vy
        normal = dx * nx + dy * ny
        if normal >= 0.0:
            continue
        moving = moving_mass(grid, at)
        jx, jy = moving * normal * nx, moving * normal * ny
        start_x, start_y = grid[at + NPX] / mass, grid[at + NPY] / mass
        if friction > 0.0:
            tangent_x, tangent_y = dx - normal * nx, dy - normal * ny
            slip = math.sqrt(tangent_x * tangent_x + tangent_y * tangent_y)
            if slip > 0.0:
                share = min(1.0, -friction * normal / slip)
                jx += moving * share * tangent_x
                jy += moving * share * tangent_y
        end_x, end_y = vx + jx / moving, vy + jy / moving
        lag_x, lag_y = -speed - 0.5 * (start_x + end_x), -0.5 * (start_y + end_y)
        lag_normal = lag_x * nx + lag_y * ny
        pressed = jx * nx + jy * ny
        lost_impact += pressed * lag_normal
        lost_friction += (jx - pressed * nx) * (lag_x - lag_normal * nx) + (jy - pressed * ny) * (
            lag_y - lag_normal * ny
        )
        grid[at + NVX] = end_x
        grid[at + NVY] = end_y
        impulse_x += jx
        impulse_y += jy
    return impulse_x, impulse_y, lost_impact, lost_friction
