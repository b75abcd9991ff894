"""Initial state: points, interface and grid of a cut."""

from __future__ import annotations

import math

import numpy as np

from orthocut.kernels.mpm import interface as pairs
from orthocut.kernels.mpm import layout, step
from orthocut.kernels.mpm.frame import Frame, Solid, Usavg, Wedge
from orthocut.mpm.laws import cohesion_of, hardening_of
from orthocut.mpm.state import State
from orthocut.params.mpm import MpmCutting

_ROOM = 1.1  # length of a straight chip over travel and notch, for the space above and ahead of the workpiece
_MASS_SMALL = 1e-9  # nodes below this fraction of the mass of a full cell are skipped


def fill_blocks(x: np.ndarray, y: np.ndarray, mass: float) -> np.ndarray:
    """Points at rest in blocks of lanes; lanes that pad the last block stand at the last point and have no mass.

    Parameters
    ----------
    x, y : float array, shape (n,)
        Positions [m].
    mass : float
        Mass of each point per unit width [kg/m].

    Returns
    -------
    float array, shape (n_blocks, POINT_FIELDS, LANES)
    """
    count = -(-x.size // layout.LANES)
    flat = np.zeros((layout.POINT_FIELDS, count * layout.LANES))
    flat[layout.X], flat[layout.Y] = x[-1], y[-1]
    flat[layout.X, : x.size], flat[layout.Y, : y.size] = x, y
    flat[layout.MASS, : x.size] = mass
    for name in (layout.FXX, layout.FYY, layout.BXX, layout.BYY):
        flat[name] = 1.0
    return flat.reshape(layout.POINT_FIELDS, count, layout.LANES).transpose(1, 0, 2).copy()


def _rectangle(columns: range, rows: range, spacing: float, per_cell: int) -> tuple[np.ndarray, np.ndarray]:
    """Places of points on a square lattice, columns of cells one after the other."""
    i, j = np.meshgrid(np.array(columns), np.array(rows), indexing="ij")
    i, j = i.ravel(), j.ravel()
    order = np.lexsort((i % per_cell, j % per_cell, j // per_cell, i // per_cell))
    return (i[order] + 0.5) * spacing, (j[order] + 0.5) * spacing


def build(case: MpmCutting) -> State:
    """Workpiece at rest, tool tip at the end face of the notch.

    The cutting path is y = 0, the workpiece reaches from x = 0 to its length, the tool stands at its right end.
    """
    depth = case.cut_depth
    n = case.numerics.points_per_depth
    per_cell = case.numerics.points_per_cell
    spacing = depth / n
    columns = per_cell * round(case.workpiece.length_ratio * n / per_cell)
    base_rows = per_cell * max(1, round(case.workpiece.base_ratio * n / per_cell))
    mass = case.material.density * spacing**2
    chip = fill_blocks(*_rectangle(range(columns), range(n), spacing, per_cell), mass)
    base = fill_blocks(*_rectangle(range(columns), range(-base_rows, 0), spacing, per_cell), mass)

    room = _ROOM * (case.travel_ratio + case.workpiece.notch_ratio) + 2.0
    beside = above = math.ceil(room * n / per_cell) + 3
    rows = base_rows // per_cell
    below = rows + 3
    lift = -case.numerics.grid_offset % 1.0  # what the row of nodes at or next below the cut lies below it, in cells

    path = round(case.workpiece.path_ratio * n) or columns
    whole = max(columns - path, 0)
    notch = round(case.workpiece.notch_ratio * n)
    places = np.arange(whole, columns)
    interface = np.zeros((pairs.INTERFACE_ROWS, places.size))
    interface[pairs.UPPER_X] = interface[pairs.LOWER_X] = (places + 0.5) * spacing
    interface[pairs.NORMAL_Y] = 1.0
    interface[pairs.ALIVE] = places < columns - notch
    interface[pairs.PRESENT] = 1.0
    interface[pairs.FAILED_AT] = np.nan
    interface[pairs.MODE_ONE] = np.nan

    cell = case.cell
    solid = case.material
    held = case.workpiece.bottom == "clamped"
    totals = np.zeros(step.TOTALS)
    totals[step.TIP] = columns * spacing + max(0.0, -math.tan(case.tool.rake_angle)) * depth
    chip_blocks, base_blocks = chip.shape[0], base.shape[0]
    return State(
        points=np.concatenate([chip, base]).ravel(),
        blocks=np.array([[0, chip_blocks], [chip_blocks, chip_blocks + base_blocks]]),
        interface=interface,
        totals=totals,
        solid=Solid(solid.modulus_bulk, solid.modulus_shear, solid.density, hardening_of(solid)),
        cohesion=cohesion_of(case.interface),
        wedge=Wedge(
            case.tool.rake_angle,
            case.tool.clearance_angle,
            case.tool.friction,
            case.cut_speed,
            case.numerics.ramp_fraction * case.duration,
            case.numerics.ramp_feedback,
            case.numerics.contact == "cells",
        ),
        frame=Frame(
            origin_x=-beside * cell,
            origin_y=-(below + lift) * cell,
            cell=cell,
            inv_cell=1.0 / cell,
            count_x=beside + columns // per_cell + beside + 1,
            count_y=below + above + 1,
            last_clamped_row=below - rows + round(lift),
            mass_small=_MASS_SMALL * solid.density * cell**2,
            mass_firm=case.numerics.support * solid.density * cell**2,
            time_step=case.time_step,
            affine=case.numerics.affine,
            dashpot_normal=0.0 if held else solid.density * solid.speed_pressure_wave * cell,
            dashpot_shear=math.sqrt(solid.density * solid.modulus_shear) * cell,
            reach=case.numerics.reach_ratio * depth or math.inf,
            half_point=0.5 / per_cell,
            last_whole_column=beside + whole // per_cell if whole else -1,
        ),
        usavg=Usavg(case.numerics.flip, case.numerics.position_order) if case.numerics.scheme == "usavg" else None,
    )
