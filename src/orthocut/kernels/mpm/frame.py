"""Constants of a run, bundled for the kernels."""

import math
from typing import NamedTuple

import numpy as np

from orthocut.kernels.laws.cohesive import CohesiveLaw
from orthocut.kernels.laws.failure import Criterion
from orthocut.kernels.laws.hardening import Hardening


class Frame(NamedTuple):
    """Grid of square cells; both bodies use the same."""

    origin_x: float
    """Position of node (0, 0) [m]."""
    origin_y: float
    """Position of node (0, 0) [m]."""
    cell: float
    """Cell size [m]."""
    inv_cell: float
    """One over the cell size [1/m]."""
    count_x: int
    """Nodes in a row."""
    count_y: int
    """Rows of nodes."""
    last_clamped_row: int
    """Rows of the base up to this one are clamped in both directions, or rest on dashpots."""
    mass_small: float
    """Nodes of less mass are skipped [kg/m]."""
    mass_firm: float
    """Nodes of less mass follow the firm ones beside them [kg/m]; 0 leaves all nodes alone."""
    time_step: float
    """Time step [s]."""
    affine: float
    """Share of the velocity gradient that points hand on to the next grid: 0 (PIC) to 1."""
    dashpot_normal: float = 0.0
    """Resistance of a dashpot across the bottom, density times wave speed times cell [kg/(m s)]; 0 where it is held."""
    dashpot_shear: float = 0.0
    """Resistance of a dashpot along the bottom [kg/(m s)]."""
    reach: float = math.inf
    """Material farther than this ahead of the tool tip, or half as far behind it, rests [m]."""
    last_whole_column: int = -1
    """Up to this column, beyond the end of the path, chip and base are one; -1 where there is no such place."""
    half_point: float = 0.25
    """Half-width of an undeformed point over the cell size: 1/4 for two points a cell and direction."""


class Solid(NamedTuple):
    """Material of the workpiece."""

    modulus_bulk: float
    """Bulk modulus [Pa]."""
    modulus_shear: float
    """Shear modulus [Pa]."""
    density: float
    """Density in the undeformed state [kg/m^3]."""
    hardening: Hardening
    """Law of the yield stress; kernels are compiled for its type."""


class Cohesion(NamedTuple):
    """Interface between chip and base; kernels are compiled for the types of both."""

    law: CohesiveLaw
    """Traction over opening."""
    criterion: Criterion
    """When it fails in mixed mode."""


class Wedge(NamedTuple):
    """Rigid tool that moves towards -x."""

    rake_angle: float
    """Rake angle [rad]."""
    clearance_angle: float
    """Clearance angle [rad]."""
    friction: float
    """Coulomb coefficient."""
    speed: float
    """Speed after the ramp [m/s]."""
    ramp_time: float
    """Duration of the ramp [s]."""
    feedback: float
    """Gain of the feedback damping in the ramp [1/m^2]."""
    by_cells: bool = False
    """Whether contact is found with particles of the tool on the grid, see `contact_cells`, or by exact geometry."""


class Usavg(NamedTuple):
    """Choices of the loop that updates stresses twice a step, see `usavg`."""

    flip: float
    """Share of a point's own velocity that is kept beside that of the nodes: 0 (PIC) to 1 (FLIP)."""
    position_order: int
    """Order of the update of positions: 0, 1 or 2."""


class Workspace(NamedTuple):
    """Arrays that live only within a step."""

    lanes: np.ndarray
    """One block of points and what is derived from it, shape (WORK,)."""
    near: np.ndarray
    """Points near the tool, block * LANES + lane, shape (2, n_lanes)."""
    marked: np.ndarray
    """Offsets of the nodes of each body that touch the tool, shape (2, n_nodes)."""
    listed: np.ndarray
    """1 for the nodes that are already listed, shape (n_nodes,); 0 everywhere outside of the search."""
    tool_nodes: np.ndarray
    """Nodes that particles of the tool reach, shape (n_nodes,)."""
    tool_sums: np.ndarray
    """Volume of the tool at each node, and its moments, shape (n_nodes, 3); 0 everywhere outside of the search."""
    body_sums: np.ndarray
    """Mass of a body at each node, and its moment, shape (n_nodes, 2); 0 everywhere outside of the search."""
    closing: np.ndarray
    """Offsets of the nodes around closed pairs of the interface, shape (n_nodes,)."""
    closing_normal: np.ndarray
    """Sums of the normals of the pairs around those nodes, shape (n_nodes, 2)."""
    closing_impulse: np.ndarray
    """Impulses on the chip at those nodes, shape (n_nodes, 2)."""
    closing_slot: np.ndarray
    """Place of each node in `closing`; -1 everywhere outside of the search, shape (n_nodes,)."""
    loose: np.ndarray
    """Nodes of each body that follow the firm ones beside them, shape (2, n_nodes)."""
    loose_weights: np.ndarray
    """Weights of the lines of firm nodes that they follow, shape (2, n_nodes, 8)."""
    moves: np.ndarray
    """Displacements of all points in the step of `usavg`, two rows of lanes a block."""
