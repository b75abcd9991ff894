"""Cohesive interface between chip and base: tractions, closing contact, motion.

Pairs of massless copies stand along the cutting path; the upper copy moves with the chip, the lower one with the base,
both with the mass-weighted velocity of the four nodes around them. Weights by mass bound the stiffness that a pair
gives to a node by the mass of the node: weights by distance alone let nodes of little mass vibrate until the interface
breaks far from the tool. The opening is upper minus lower. A pair that has failed carries no traction, but keeps chip
and base from running into each other as long as it is ahead of the tool. A pair that has no material around one of its
copies, as where a chip tears, has nothing to pull on: it fails, and neither time nor mode of this are logged.
"""

import math

from orthocut.kernels.jit import jit, part
from orthocut.kernels.laws.cohesive import traction_over_opening
from orthocut.kernels.laws.failure import damage
from orthocut.kernels.mpm.grid import moving_mass
from orthocut.kernels.mpm.layout import NFX, NFY, NM, NMARK, NODE, NPX, NPY, NVX, NVY
from orthocut.kernels.mpm.support import LOOSE

# rows of the interface state, one column a pair
UPPER_X, UPPER_Y, LOWER_X, LOWER_Y = 0, 1, 2, 3  # positions [m]
PEAK_NORMAL, PEAK_TANGENT = 4, 5  # openings that set the secant stiffnesses [m]
TRACTION_X, TRACTION_Y = 6, 7  # traction on the base [Pa]
NORMAL_X, NORMAL_Y = 8, 9  # unit normal from base to chip
ALIVE = 10  # 1 while the pair carries tractions, 0 after failure and in the notch
PRESENT = 13  # 1 while the pair is looked at: after failure until it is wide open or the tool has passed
MODE_ONE = 11  # energy released in mode I over both modes, at failure
FAILED_AT = 12  # time of failure [s]
INTERFACE_ROWS = 14


@part
def pair_area(frame):
    """Area of a pair per unit width; there are as many pairs along a cell as points [m]."""
    return 2.0 * frame.half_point * frame.cell


@part
def _locate(x, y, frame):
    """Column and row of the cell around a place, kept inside of the grid, and the place in the cell."""
    x = (x - frame.origin_x) * frame.inv_cell
    y = (y - frame.origin_y) * frame.inv_cell
    i = int(min(max(math.floor(x), 0.0), frame.count_x - 2.0))
    j = int(min(max(math.floor(y), 0.0), frame.count_y - 2.0))
    return i, j, x - i, y - j


@part
def _weights(grid, x, y, frame):
    """Offsets of the lower and upper left nodes around a place, and the weights by mass of the four nodes.

    Weights are zero where these have hardly any mass together: nodes of so little mass do not move.
    """
    i, j, rx, ry = _locate(x, y, frame)
    at = (j * frame.count_x + i) * NODE
    above = at + frame.count_x * NODE
    w00 = (1.0 - rx) * (1.0 - ry) * grid[at + NM]
    w10 = rx * (1.0 - ry) * grid[at + NODE + NM]
    w01 = (1.0 - rx) * ry * grid[above + NM]
    w11 = rx * ry * grid[above + NODE + NM]
    total = w00 + w10 + w01 + w11
    scale = 1.0 / total if total > frame.mass_small else 0.0
    return at, above, w00 * scale, w10 * scale, w01 * scale, w11 * scale


@part
def _is_bare(grid, x, y, frame):
    """Whether the nodes around a place have no mass to speak of."""
    _, _, w00, w10, w01, w11 = _weights(grid, x, y, frame)
    return w00 + w10 + w01 + w11 == 0.0


@part
def spread(grid, x, y, force_x, force_y, frame):
    """Share a force at a place among the nodes around it by mass."""
    at, above, w00, w10, w01, w11 = _weights(grid, x, y, frame)
    grid[at + NFX] += w00 * force_x
    grid[at + NFY] += w00 * force_y
    grid[at + NODE + NFX] += w10 * force_x
    grid[at + NODE + NFY] += w10 * force_y
    grid[above + NFX] += w01 * force_x
    grid[above + NFY] += w01 * force_y
    grid[above + NODE + NFX] += w11 * force_x
    grid[above + NODE + NFY] += w11 * force_y


@part
def sample(grid, x, y, frame):
    """Velocity at a place from the nodes around it that have mass [m/s]."""
    at, above, w00, w10, w01, w11 = _weights(grid, x, y, frame)
    vx = w00 * grid[at + NVX] + w10 * grid[at + NODE + NVX] + w01 * grid[above + NVX] + w11 * grid[above + NODE + NVX]
    vy = w00 * grid[at + NVY] + w10 * grid[at + NODE + NVY] + w01 * grid[above + NVY] + w11 * grid[above + NODE + NVY]
    return vx, vy


@part
def set_normals(interface, first):
    """Normals of the living pairs from a first one on: central differences of midpoints of their living neighbours."""
    count = interface.shape[1]
    for k in range(first, count):
        if interface[ALIVE, k] == 0.0:
            continue
        a = k - 1 if k > 0 and interface[ALIVE, k - 1] > 0.0 else k
        b = k + 1 if k < count - 1 and interface[ALIVE, k + 1] > 0.0 else k
        tx = 0.5 * (interface[UPPER_X, b] + interface[LOWER_X, b] - interface[UPPER_X, a] - interface[LOWER_X, a])
        ty = 0.5 * (interface[UPPER_Y, b] + interface[LOWER_Y, b] - interface[UPPER_Y, a] - interface[LOWER_Y, a])
        length = math.sqrt(tx * tx + ty * ty)
        if length > 0.0:
            interface[NORMAL_X, k] = -ty / length
            interface[NORMAL_Y, k] = tx / length


@part
def pull_together(interface, first, chip, base, closing, closing_normal, closing_slot, cohesion, time, tip, frame):
    """Add the tractions of all living pairs to the nodes; list the nodes where the interface is closed.

    Parameters
    ----------
    interface : float array, shape (INTERFACE_ROWS, n_pairs)
        State of the pairs; modified in place.
    first : int
        Pairs before this one are at rest.
    chip, base : float array
        Nodes of both bodies; forces are added.
    closing : int array
        Receives the offsets of the nodes around closed pairs.
    closing_normal : float array, shape (n, 2)
        Receives the sum of the normals of the pairs around each listed node.
    closing_slot : int array, shape (n_nodes,)
        Work space, -1 everywhere; left so.
    cohesion : Cohesion
        Cohesive law and criterion of failure.
    time : float
        Time, logged at failure [s].
    tip : float
        Place of the tool tip along the cut [m].
    frame : Frame
        Grid.

    Returns
    -------
    int
        Number of nodes listed.
    """
    law, criterion = cohesion.law, cohesion.criterion
    area = pair_area(frame)
    count = 0
    for k in range(first, interface.shape[1]):
        if interface[PRESENT, k] == 0.0:
            continue
        nx, ny = interface[NORMAL_X, k], interface[NORMAL_Y, k]
        opening_x = interface[UPPER_X, k] - interface[LOWER_X, k]
        opening_y = interface[UPPER_Y, k] - interface[LOWER_Y, k]
        normal = opening_x * nx + opening_y * ny
        tangent = opening_x * ny - opening_y * nx
        if interface[ALIVE, k] == 0.0:
            if normal > frame.cell or min(interface[UPPER_X, k], interface[LOWER_X, k]) > tip:
                interface[PRESENT, k] = 0.0
                continue
        elif _is_bare(chip, interface[UPPER_X, k], interface[UPPER_Y, k], frame) or _is_bare(
            base, interface[LOWER_X, k], interface[LOWER_Y, k], frame
        ):
            interface[ALIVE, k] = interface[TRACTION_X, k] = interface[TRACTION_Y, k] = 0.0
            continue
        else:
            peak_normal, peak_tangent, one, two, failed = damage(
                criterion, law, max(normal, 0.0), abs(tangent), interface[PEAK_NORMAL, k], interface[PEAK_TANGENT, k]
            )
            if failed:
                interface[ALIVE, k] = 0.0
                interface[TRACTION_X, k] = interface[TRACTION_Y, k] = 0.0
                interface[MODE_ONE, k] = one / (one + two)
                interface[FAILED_AT, k] = time
                continue
            interface[PEAK_NORMAL, k] = peak_normal
            interface[PEAK_TANGENT, k] = peak_tangent
            pull = traction_over_opening(law, peak_normal) * max(normal, 0.0)
            shear = traction_over_opening(law, peak_tangent) * tangent
            interface[TRACTION_X, k] = pull * nx + shear * ny
            interface[TRACTION_Y, k] = pull * ny - shear * nx
            force_x = area * interface[TRACTION_X, k]
            force_y = area * interface[TRACTION_Y, k]
            spread(chip, interface[UPPER_X, k], interface[UPPER_Y, k], -force_x, -force_y, frame)
            spread(base, interface[LOWER_X, k], interface[LOWER_Y, k], force_x, force_y, frame)
        if normal < 0.0:
            for side in range(2):
                i, j, _, _ = _locate(interface[UPPER_X + 2 * side, k], interface[UPPER_Y + 2 * side, k], frame)
                corner = j * frame.count_x + i
                for node in (corner, corner + 1, corner + frame.count_x, corner + frame.count_x + 1):
                    if closing_slot[node] < 0:
                        closing_slot[node] = count
                        closing[count] = node * NODE
                        closing_normal[count, 0] = closing_normal[count, 1] = 0.0
                        count += 1
                    closing_normal[closing_slot[node], 0] += nx
                    closing_normal[closing_slot[node], 1] += ny
    for k in range(count):
        closing_slot[closing[k] // NODE] = -1
    return count


@part
def push_apart(chip, base, closing, closing_normal, impulses, count, frame):
    """Exchange normal momentum between chip and base at firm nodes around closed pairs, where they approach each other.

    Parameters
    ----------
    chip, base : float array
        Nodes of both bodies with their velocities at the end of the step; modified in place.
    closing, closing_normal, count
        Nodes around closed pairs and the sums of normals around them, see `pull_together`.
    impulses : float array, shape (n, 2)
        Receives the impulse on the chip at each of these nodes [N s/m].
    frame : Frame
        Grid.
    """
    for k in range(count):
        at = closing[k]
        impulses[k, 0] = impulses[k, 1] = 0.0
        if chip[at + NM] <= frame.mass_small or base[at + NM] <= frame.mass_small:
            continue
        if chip[at + NMARK] == LOOSE or base[at + NMARK] == LOOSE:
            continue
        nx, ny = closing_normal[k, 0], closing_normal[k, 1]
        length = math.sqrt(nx * nx + ny * ny)
        nx, ny = nx / length, ny / length
        approach = (chip[at + NVX] - base[at + NVX]) * nx + (chip[at + NVY] - base[at + NVY]) * ny
        if approach >= 0.0:
            continue
        mass_chip, mass_base = moving_mass(chip, at), moving_mass(base, at)
        impulse = -approach * mass_chip * mass_base / (mass_chip + mass_base)
        chip[at + NVX] += impulse * nx / mass_chip
        chip[at + NVY] += impulse * ny / mass_chip
        base[at + NVX] -= impulse * nx / mass_base
        base[at + NVY] -= impulse * ny / mass_base
        impulses[k, 0] = impulse * nx
        impulses[k, 1] = impulse * ny


@part
def lost_in_closing(chip, base, closing, impulses, count):
    """Energy that the impulses of `push_apart` take, acting at the mean velocity of the step [J/m].

    The tool acts on the same nodes afterwards: velocities are those after it.
    """
    lost = 0.0
    for k in range(count):
        jx, jy = impulses[k, 0], impulses[k, 1]
        if jx == 0.0 and jy == 0.0:
            continue
        at = closing[k]
        mass_chip, mass_base = chip[at + NM], base[at + NM]
        vx = chip[at + NPX] / mass_chip + chip[at + NVX] - base[at + NPX] / mass_base - base[at + NVX]
        vy = chip[at + NPY] / mass_chip + chip[at + NVY] - base[at + NPY] / mass_base - base[at + NVY]
        lost -= 0.5 * (jx * vx + jy * vy)
    return lost


@part
def move_pairs(interface, first, chip, base, frame):
    """Move both copies of all pairs that are looked at, from a first one on, with the velocities of the step's end.

    Returns
    -------
    float
        Work done on the tractions of the step [J/m].
    """
    work = 0.0
    time_step, area = frame.time_step, pair_area(frame)
    for k in range(first, interface.shape[1]):
        if interface[PRESENT, k] == 0.0:
            continue
        ux, uy = sample(chip, interface[UPPER_X, k], interface[UPPER_Y, k], frame)
        lx, ly = sample(base, interface[LOWER_X, k], interface[LOWER_Y, k], frame)
        interface[UPPER_X, k] += time_step * ux
        interface[UPPER_Y, k] += time_step * uy
        interface[LOWER_X, k] += time_step * lx
        interface[LOWER_Y, k] += time_step * ly
        work += time_step * area * (interface[TRACTION_X, k] * (ux - lx) + interface[TRACTION_Y, k] * (uy - ly))
    return work


@jit
def crack_tip_of(interface):
    """Place along the cut of the pair farthest ahead (least x) that carries no traction [m]."""
    tip = interface[UPPER_X, interface.shape[1] - 1]
    for k in range(interface.shape[1]):
        if interface[ALIVE, k] == 0.0:
            return 0.5 * (interface[UPPER_X, k] + interface[LOWER_X, k])
    return tip
