"""Checks of a finished run from its dataset alone, by other ways than those in which the solvers watch themselves.

Each check returns a number and the limit beyond which the run lies; what is beyond is named.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import xarray as xr

from orthocut.dem.pairs import close_pairs
from orthocut.params.case import Case
from orthocut.theory.hardening import yield_stress

SNAPSHOTS = 11
"""Snapshots that checks need."""
MAY_BE_NAN = {
    "mode_one_fraction",
    "touching",
    "crack_gap_mean",
    "chip_thickness_ratio",
    "angle_shear",
    "shear_largest",
    "force_cutting_contact",
    "force_thrust_contact",
    "force_cutting_drift",
    "modulus_young",
    "ratio_poisson",
    "strain_peak",
}
"""Results that are NaN where there is nothing to measure: no chip yet, no failed pair, no contact, too few samples."""


class Check(NamedTuple):
    """What was looked at."""

    name: str
    value: float
    limit: float

    @property
    def passed(self) -> bool:
        """Whether the value is a number within the limit."""
        return bool(self.value <= self.limit)


def checks(case: Case, run: xr.Dataset) -> list[Check]:
    """All checks of a run."""
    of_solver = _mpm(case, run) if case.kind == "mpm_cutting" else _dem(case, run)
    return [Check("values not finite", _not_finite(run), 0), *of_solver]


def _not_finite(run: xr.Dataset) -> int:
    used = np.isfinite(run["time"].values)
    count = 0
    for name, variable in run.data_vars.items():
        if name in MAY_BE_NAN or variable.dtype.kind != "f":
            continue
        values = variable.values[used] if variable.dims == ("sample",) else variable.values
        count += int(np.sum(~np.isfinite(values)))
    return count


def _late(run: xr.Dataset, depth: float) -> np.ndarray:
    return run["tool_travel"].values > depth


def _mpm(case: Case, run: xr.Dataset) -> Iterator[Check]:
    late = _late(run, case.cut_depth)
    work = run["work_tool"].values
    parts = {name: run[f"energy_{name}"].values for name in ENERGIES}
    residual = work - sum(parts.values())
    scale = np.maximum(abs(work[late]), 1e-300)
    yield Check("energy not accounted for over the work", float(np.max(abs(residual[late]) / scale)), 0.05)
    made = -(parts["numerical"] + parts["contact"])[late] / scale
    yield Check("energy made by transfers and contact over the work", float(np.max(made)), 0.05)
    for name, limit in (("elastic", 1e-6), ("plastic", 1e-6), ("kinetic", 1e-6), ("friction", 0.01), ("damping", 0.01)):
        yield Check(f"{name} energy below zero over the work", float(-parts[name].min() / abs(work[-1])), limit)
    yield Check("momentum not accounted for over that of the tool", _momentum(case, run), 0.05)
    through, along = case.numerics.points_per_depth, case.numerics.points_per_cell
    columns = along * round(case.workpiece.length_ratio * through / along)
    rows = through + along * max(1, round(case.workpiece.base_ratio * through / along))
    cells = (through / along) ** 2
    yield Check("points lost", float(abs(run["point_x"].shape[1] - columns * rows)), 0)
    gradient = run["point_deformation"].values[-1]
    volume = gradient[:, 0] * gradient[:, 3] - gradient[:, 1] * gradient[:, 2]
    yield Check("points turned inside out", float(np.sum(~(volume > 0))), 0)
    yield Check("stress over yield stress, less one", _beyond_yield(case, run, volume), 0.02)
    yield Check("way of a point in the tool, in cells", _in_tool(case, run), 2.0)
    yield Check("cells full of both bodies", _shared_cells(case, run, volume, columns), max(2, 0.05 * cells))
    yield Check("speed of a point over that of waves", _fastest(run, "point") / case.material.speed_pressure_wave, 1.0)


ENERGIES = ("elastic", "plastic", "kinetic", "cohesive", "friction", "contact", "numerical", "damping")


def _momentum(case: Case, run: xr.Dataset) -> float:
    """Way of the mass centre after the ramp less that by the forces of tool and clamp, over that by the tool's alone.

    The speed at the end of the ramp is not known; it is fitted. Where the tool hardly pushes along an axis, the measure
    is a thousandth of the way by the larger of its forces: a way of next to nothing tells nothing.
    """
    times = run["time_snapshot"].values
    after = times > case.numerics.ramp_fraction * case.duration
    if after.sum() < 4:
        return 0.0
    mass = case.material.density * (case.cut_depth / case.numerics.points_per_depth) ** 2
    edges = np.concatenate([[0.0], run["time"].values])
    intervals = np.diff(edges)
    opened, scales, least = [], [], 1e-300
    for axis, name in (("x", "cutting"), ("y", "thrust")):
        moment = mass * run[f"point_{axis}"].values[after].sum(axis=1)
        ways = []
        for force in (-run[f"force_{name}"].values, -run[f"reaction_{name}"].values):
            impulse = np.concatenate([[0.0], np.cumsum(force * intervals)])
            way = np.concatenate([[0.0], np.cumsum(0.5 * (impulse[1:] + impulse[:-1]) * intervals)])
            ways.append(np.interp(times[after], edges, way))
        since = times[after] - times[after][0]
        line = np.stack([np.ones_like(since), since], axis=1)

        def bent(values, line=line):
            return values - line @ np.linalg.lstsq(line, values, rcond=None)[0]

        opened.append(np.ptp(bent(moment - ways[0] - ways[1])))
        scales.append(max(np.ptp(bent(ways[0])), np.ptp(bent(ways[1]))))
        least = max(least, 1e-3 * np.ptp(ways[0]))
    return max(float(way / max(scale, least)) for way, scale in zip(opened, scales, strict=True))


def _beyond_yield(case: Case, run: xr.Dataset, volume: np.ndarray) -> float:
    """Largest Kirchhoff stress over the yield stress at the plastic strain, less one."""
    if case.material.hardening == "none":
        return 0.0
    limit = yield_stress(case.material, run["point_strain_plastic"].values[-1])
    return float(np.max(run["point_stress"].values[-1] * volume / limit)) - 1.0


def _in_tool(case: Case, run: xr.Dataset) -> float:
    """How far the deepest point is within the wedge, in cells."""
    tool = case.tool
    dx = run["point_x"].values[-1] - float(run["tool_tip_snapshot"][-1])
    dy = run["point_y"].values[-1]
    rake = dx * math.cos(tool.rake_angle) - dy * math.sin(tool.rake_angle)
    clearance = -dx * math.sin(tool.clearance_angle) + dy * math.cos(tool.clearance_angle)
    return float(np.max(np.minimum(rake, clearance)) / case.cell)


def _shared_cells(case: Case, run: xr.Dataset, volume: np.ndarray, columns: int) -> int:
    """Cells that chip and base both fill by more than 0.9."""
    x, y = run["point_x"].values[-1] / case.cell, run["point_y"].values[-1] / case.cell
    i, j = np.floor(x).astype(int), np.floor(y).astype(int)
    i, j = i - i.min(), j - j.min()
    chip = columns * case.numerics.points_per_depth
    shape = (int(i.max()) + 1, int(j.max()) + 1)
    filled = []
    for part in (slice(0, chip), slice(chip, None)):
        cells = np.zeros(shape)
        np.add.at(cells, (i[part], j[part]), volume[part] / case.numerics.points_per_cell**2)
        filled.append(cells)
    return int(np.sum(np.minimum(*filled) > 0.9))


def _fastest(run: xr.Dataset, what: str) -> float:
    """Largest mean speed of a particle between snapshots [m/s]."""
    x, y = run[f"{what}_x"].values, run[f"{what}_y"].values
    spans = np.diff(run["time_snapshot"].values)
    return float(np.max(np.hypot(np.diff(x, axis=0), np.diff(y, axis=0)).max(axis=1) / spans))


PARTS = ("kinetic", "elastic", "damping", "friction", "fracture")


def _dem(case: Case, run: xr.Dataset) -> Iterator[Check]:
    used = np.isfinite(run["time"].values)
    total = sum(run[f"energy_{name}"].values[used] for name in PARTS)
    work = run["work_tool"].values[used]
    radius = run["disc_radius"].values
    scale = float(np.max(abs(work) + abs(total))) + case.joint.modulus * (0.05 * float(radius.max())) ** 2
    drift = work - total
    yield Check("energy not accounted for over the work", float(np.ptp(drift)) / scale, 0.05)
    for name in PARTS:
        least = float(run[f"energy_{name}"].values[used].min())
        yield Check(f"{name} energy below zero over the work", -least / scale, 0.01)
    broken = (run["bond_intact"].values[0] - run["bond_intact"].values[-1]).sum() * case.joint.elements
    logged = int(run["cracks_tension_total"]) + int(run["cracks_shear_total"])
    yield Check("broken elements that are not in the log", abs(float(broken) - logged), 1e-6)
    yield Check("overlap of discs over the smaller radius", _overlap(run), 0.5)
    sound = math.sqrt(case.joint.modulus / case.joint.density)
    yield Check("speed of a disc over that of sound", _fastest(run, "disc") / sound, 0.25)
    if case.kind == "dem_cutting":
        tool = case.tool
        dx = run["disc_x"].values[-1] - float(run["tool_tip_snapshot"][-1])
        dy = run["disc_y"].values[-1] - (case.packing.height - case.cut_depth)
        rake = dx * math.cos(tool.rake_angle) - dy * math.sin(tool.rake_angle)
        clearance = -dx * math.sin(tool.clearance_angle) + dy * math.cos(tool.clearance_angle)
        yield Check("way of a centre in the tool, in radii", float(np.max(np.minimum(rake, clearance) / radius)), 0.0)
        fixed = run["disc_fixed"].values > 0
        x, y = run["disc_x"].values, run["disc_y"].values
        moved = np.hypot(x[-1] - x[0], y[-1] - y[0])[fixed]
        yield Check("way of a fixed disc, in radii", float(moved.max(initial=0.0) / radius.min()), 0.0)


def _overlap(run: xr.Dataset) -> float:
    """Largest overlap at the end over the smaller radius, beyond that of installation."""
    radius = run["disc_radius"].values
    x, y = run["disc_x"].values, run["disc_y"].values
    pairs = close_pairs(x[-1], y[-1], radius)
    if not len(pairs):
        return 0.0
    first, second = pairs.T
    reach = radius[first] + radius[second]
    at_start = np.hypot(x[0][first] - x[0][second], y[0][first] - y[0][second])
    now = np.hypot(x[-1][first] - x[-1][second], y[-1][first] - y[-1][second])
    return float(np.max((np.minimum(reach, at_start) - now) / np.minimum(radius[first], radius[second])))
