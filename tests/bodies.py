"""Free bodies of material points, run by the solver's own time step, for tests with exact answers.

Nodes stand at whole multiples of the cell size. Nothing but what a test asks for acts on a body: the tool is far away,
there is no interface and no row is clamped.
"""

from __future__ import annotations

import math

import numpy as np

from orthocut.kernels.laws.cohesive import Cubic
from orthocut.kernels.laws.failure import Area
from orthocut.kernels.laws.hardening import Linear
from orthocut.kernels.mpm import interface as pairs
from orthocut.kernels.mpm import layout, points, step
from orthocut.kernels.mpm.frame import Cohesion, Frame, Solid, Wedge
from orthocut.mpm.setup import fill_blocks
from orthocut.mpm.solver import Solver
from orthocut.mpm.state import State

PLASTIC = Solid(980e6, 376e6, 1000.0, Linear(25e6, 0.0))
"""Material of Nairn (2015) without hardening."""
ELASTIC = PLASTIC._replace(hardening=Linear(1e15, 0.0))
"""The same without yielding."""
SPEED = math.sqrt((PLASTIC.modulus_bulk + 4 * PLASTIC.modulus_shear / 3) / PLASTIC.density)
"""Speed of pressure waves [m/s]."""
YOUNG_PLANE = 4 * 376e6 * (3 * 980e6 + 376e6) / (3 * 980e6 + 4 * 376e6)
"""Plane-strain modulus E' [Pa]."""
FAR = 1e3
TOOL_AT_REST = Wedge(0.0, 0.0, 0.0, 0.0, 1e-300, 0.0)
NO_COHESION = Cohesion(Cubic(1.0, 0.0), Area())


def rectangle(left: float, right: float, low: float, high: float, cell: float) -> np.ndarray:
    """Places of points in a rectangle, two a cell and direction, shape (2, n); lengths in cells."""
    i, j = np.meshgrid(np.arange(round(2 * (right - left))), np.arange(round(2 * (high - low))), indexing="ij")
    return np.stack([left + 0.5 * i.ravel() + 0.25, low + 0.5 * j.ravel() + 0.25]) * cell


class Bodies(Solver):
    """One or two bodies of points at rest.

    Parameters
    ----------
    chip, base : float array, shape (2, n), optional
        Places of points [m].
    cell : float
        Cell size [m]; points serve a quarter of a cell's area each.
    room : float
        Cells around the bodies.
    weight_chip, weight_base : float or float array, shape (n,)
        Mass of the points over that of the material. Stress follows mass: heavy points are as stiff as heavy.
    clamped : float, optional
        Rows of the base up to this height are clamped [m].
    wedge, tip
        Tool and place of its tip [m].
    pairs_at : float array, optional
        Places of the pairs of an interface along y = 0 [m], two a cell.
    """

    def __init__(
        self,
        chip=None,
        base=None,
        *,
        cell=1e-3,
        room=4,
        solid=ELASTIC,
        affine=0.9,
        support=0.0,
        courant=0.5,
        weight_chip=1.0,
        weight_base=1.0,
        clamped=None,
        wedge=TOOL_AT_REST,
        tip=FAR,
        pairs_at=(),
        cohesion=NO_COHESION,
    ):
        mass = solid.density * cell**2
        blocks = [
            fill_blocks(*places, 0.25 * mass * weight)
            for places, weight in ((chip, weight_chip), (base, weight_base))
            if places is not None
        ]
        places = np.concatenate([part for part in (chip, base) if part is not None], axis=1)
        low = np.floor(places.min(axis=1) / cell).astype(int) - room
        high = np.ceil(places.max(axis=1) / cell).astype(int) + room
        split = blocks[0].shape[0] if chip is not None else 0
        interface = np.zeros((pairs.INTERFACE_ROWS, len(pairs_at)))
        interface[pairs.UPPER_X] = interface[pairs.LOWER_X] = pairs_at
        interface[pairs.NORMAL_Y] = interface[pairs.ALIVE] = interface[pairs.PRESENT] = 1.0
        totals = np.zeros(step.TOTALS)
        totals[step.TIP] = tip
        frame = Frame(
            origin_x=low[0] * cell,
            origin_y=low[1] * cell,
            cell=cell,
            inv_cell=1.0 / cell,
            count_x=int(high[0] - low[0]) + 1,
            count_y=int(high[1] - low[1]) + 1,
            last_clamped_row=-1 if clamped is None else round(clamped / cell) - int(low[1]),
            mass_small=1e-9 * mass,
            mass_firm=support * mass,
            time_step=courant * cell / math.sqrt((solid.modulus_bulk + 4 * solid.modulus_shear / 3) / solid.density),
            affine=affine,
        )
        blocks_of_bodies = np.array([[0, split], [split, sum(part.shape[0] for part in blocks)]])
        state = State(
            np.concatenate(blocks).ravel(), blocks_of_bodies, interface, totals, solid, cohesion, wedge, frame
        )
        super().__init__(state)
        columns, rows = np.arange(frame.count_x), np.arange(frame.count_y)
        self.node_x, self.node_y = np.meshgrid(frame.origin_x + cell * columns, frame.origin_y + cell * rows)

    def nodes(self, body: int = layout.CHIP) -> np.ndarray:
        """Nodes of the next step with mass, momentum and force; a view, shape (rows, columns, NODE)."""
        frozen = self.freeze()
        return frozen["grids"][body, int(frozen["current"])].reshape(*self.node_x.shape, layout.NODE)

    def deform(self, place, gradient) -> None:
        """Put all points elsewhere, with a deformation gradient of determinant near one, at rest.

        Parameters
        ----------
        place : float array, shape (2, n)
            New places of all points, in the order of `field`.
        gradient : float array, shape (2, 2, n)
            Deformation gradient.
        """
        self.put(layout.X, place[0])
        self.put(layout.Y, place[1])
        for name, (a, b) in {"FXX": (0, 0), "FXY": (0, 1), "FYX": (1, 0), "FYY": (1, 1)}.items():
            self.put(getattr(layout, name), gradient[a, b])
        ratio = gradient[0, 0] * gradient[1, 1] - gradient[0, 1] * gradient[1, 0]
        strain = np.einsum("ikn,jkn->ijn", gradient, gradient) / ratio ** (2 / 3)
        self.put(layout.BXX, strain[0, 0])
        self.put(layout.BYY, strain[1, 1])
        self.put(layout.BXY, strain[0, 1])
        self.set_velocity(lambda x, y: (0.0, 0.0))

    def put(self, field: int, values) -> None:
        """Replace one field of all points that have mass."""
        lanes = self.state.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)
        rows = lanes[:, field, :].copy()
        rows[lanes[:, layout.MASS, :] > 0.0] = values
        lanes[:, field, :] = rows

    def set_velocity(self, chip, base=None) -> None:
        """Velocities of both bodies from functions of place, as a grid with these velocities hands them on."""
        frozen, state = self.freeze(), self.state
        current = int(frozen["current"])
        kinetic = 0.0
        for body, function in ((layout.CHIP, chip), (layout.BASE, base or chip)):
            frozen["extents"][body, 1 - current] = 0, self.node_x.shape[1] - 1, 0, self.node_x.shape[0] - 1
            before = frozen["grids"][body, 1 - current]
            before[:] = 0.0
            nodes = before.reshape(*self.node_x.shape, layout.NODE)
            nodes[..., layout.NVX], nodes[..., layout.NVY] = function(self.node_x, self.node_y)
            frozen["grids"][body, current] = 0.0
            kinetic += points.advance_points(
                state.points,
                state.blocks[body],
                before,
                frozen["grids"][body, current],
                self._space.lanes,
                frozen["extents"][body, current],
                state.solid,
                state.frame,
                0.0,
            )
        state.totals[step.KINETIC] = kinetic

    def run(self, steps: int, load=None) -> None:
        """Advance; `load(nodes, body)` adds forces to the nodes of each body before each step."""
        if load is None:
            self.advance(steps)
            return
        for _ in range(steps):
            for body in (layout.CHIP, layout.BASE):
                load(self.nodes(body), body)
            self.advance(1)

    def of(self, body: int, field: int) -> np.ndarray:
        """One field of the points of one body."""
        first, last = self.state.blocks[body]
        lanes = self.state.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)[first:last]
        return lanes[:, field, :][lanes[:, layout.MASS, :] > 0.0]

    @property
    def time(self) -> float:
        return self.state.totals[step.TIME]

    @property
    def mass(self) -> np.ndarray:
        return self.state.field(layout.MASS)

    @property
    def place(self) -> np.ndarray:
        """Places of all points, shape (2, n)."""
        return np.stack([self.state.field(layout.X), self.state.field(layout.Y)])

    @property
    def velocity(self) -> np.ndarray:
        """Velocities of all points, shape (2, n)."""
        return np.stack([self.state.field(layout.VX), self.state.field(layout.VY)])

    @property
    def momentum(self) -> np.ndarray:
        """Momentum of the nodes, both bodies."""
        return sum(self.nodes(body)[..., layout.NPX : layout.NPY + 1].sum((0, 1)) for body in (0, 1))

    @property
    def spin(self) -> float:
        """Angular momentum of the nodes about the origin, both bodies."""
        return sum(
            (self.node_x * nodes[..., layout.NPY] - self.node_y * nodes[..., layout.NPX]).sum()
            for nodes in (self.nodes(0), self.nodes(1))
        )

    def stress(self) -> np.ndarray:
        """Cauchy stress xx, yy, xy of all points, shape (3, n) [Pa]."""
        fxx, fxy, fyx, fyy = (self.state.field(f) for f in (layout.FXX, layout.FXY, layout.FYX, layout.FYY))
        bxx, byy, bxy = (self.state.field(f) for f in (layout.BXX, layout.BYY, layout.BXY))
        ratio = fxx * fyy - fxy * fyx
        third = (bxx + byy + 1 / (bxx * byy - bxy**2)) / 3
        solid = self.state.solid
        pressure = 0.5 * solid.modulus_bulk * (ratio**2 - 1)
        shear = solid.modulus_shear
        return np.stack([shear * (bxx - third) + pressure, shear * (byy - third) + pressure, shear * bxy]) / ratio


def ring(length: int, height: int, cell: float, **options) -> Bodies:
    """An elastic strip bent to a ring about the origin: pure bending, in equilibrium without any force.

    Parameters
    ----------
    length, height : int
        Length of the middle line and height of the strip, in cells.
    """
    along, across = rectangle(0, length, -height / 2, height / 2, cell)
    radius = length * cell / (2 * math.pi)
    solid = options.get("solid", ELASTIC)
    ratio = (3 * solid.modulus_bulk - 2 * solid.modulus_shear) / (6 * solid.modulus_bulk + 2 * solid.modulus_shear)
    swell = ratio / (1 - ratio)  # the inner half of the strip becomes thicker, the outer half thinner
    inward = across + swell * across**2 / (2 * radius)
    hoop, radial = 1 - inward / radius, 1 + swell * across / radius
    c, s = np.cos(along / radius), np.sin(along / radius)
    place = (radius - inward) * np.stack([c, s])
    bodies = Bodies(place, cell=cell, **options)
    bodies.deform(place, np.stack([np.stack([-hoop * s, -radial * c]), np.stack([hoop * c, -radial * s])]))
    return bodies
