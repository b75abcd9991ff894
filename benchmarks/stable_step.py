"""Largest stable time step of each scheme, beside the estimate that the solvers take theirs from.

Two ways, for each variant of both solvers. *Shaken*: a small elastic scene, a strip with random stretches or a block of
discs with random velocities, is left alone; a step is stable if energy does not grow tenfold within 3,000 steps. *Cut*:
a whole short cut; a step is stable if the run reaches its end, that is, no guard stops it. Limits are known to 2 %. The
unit is the estimate from which the solver takes its step: for material points the time a pressure wave or the interface
needs for a cell (``numerics.courant``), for discs sqrt(smallest mass/(modulus x width)) (``joint.time_step_factor``).
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from rich.console import Console
from rich.progress import track
from tables import write_table

from orthocut.dem.packing import pack
from orthocut.dem.setup import build
from orthocut.dem.solver import DONE, advance
from orthocut.figures.canvas import PAGE, page, styled
from orthocut.figures.palette import BLACK, BLUE, ORANGE
from orthocut.figures.save import save
from orthocut.kernels.mpm import layout, step
from orthocut.measure.dem_energy import energies
from orthocut.measure.guard import Diverged
from orthocut.mpm import setup
from orthocut.mpm.solver import Solver
from orthocut.params.case import Case, load
from orthocut.run import run_case

STEPS = 3000
GROWTH = 10.0
RANGE = (0.05, 4.0)
WIDTH = 1.02
PAPER = {"scheme": "usavg", "grid_offset": 0.0, "affine": 0.0, "support": 0.0, "reach_ratio": 0.0}
MPM = {
    "default (APIC, support)": {},
    "PIC": {"affine": 0.0},
    "PIC without support": {"affine": 0.0, "support": 0.0},
    "APIC without support": {"support": 0.0},
    "support 0.25": {"support": 0.25},
    "loop of the paper's program, PIC": PAPER,
    "the same, 90 % FLIP": {**PAPER, "flip": 0.9},
    "Poisson's ratio 0.49": {"modulus_bulk": "16 GPa", "modulus_shear": "336 MPa"},
    "stiff interface": {"strength": "160 MPa", "toughness": "200 J/m^2"},
    "one point a cell": {"points_per_cell": 1},
    "four points a cell": {"points_per_cell": 4, "points_per_depth": 8},
}
DEM = {
    "default (damping 0.7)": {},
    "no damping": {"damping": 0.0},
    "damping 0.1": {"damping": 0.1},
    "stiffness ratio 1": {"stiffness_ratio": 1.0},
    "stiffness ratio 10": {"stiffness_ratio": 10.0},
    "one element": {"elements": 1},
    "four elements": {"elements": 4},
    "faces half as long": {"radius_multiplier": 0.5},
    "equal discs": {"packing.radius_ratio": 1.0},
    "size ratio 4": {"packing.radius_ratio": 4.0, "packing.radius_min": "4 um"},
}
STRIP = {"points_per_depth": 6, "length_ratio": 6.0, "travel_ratio": 3.0, "window_ratio": 1.0}
BLOCK = {
    "packing.width": "0.25 mm",
    "packing.height": "0.25 mm",
    "cut_depth": "0.06 mm",
    "cut_speed": "5 m/s",
    "travel": "0.15 mm",
    "time_step_factor": 0.1,
}
UNBREAKABLE = {"strength_tensile": "1 TPa", "cohesion": "1 TPa"}
NAMES = {"mpm": "ductile cuts (MPM)", "dem": "bonded discs (DEM)"}
HEADER = [
    "solver", "variant", "default step over the estimate [-]", "largest stable one, shaken [-]",
    "largest stable one, cut [-]", "margin, shaken [-]", "margin, cut [-]",
]  # fmt: skip


def largest(stable: Callable[[float], bool]) -> float:
    """Largest factor that is stable, by halving; NaN if the least one is not, infinity if the largest one is."""
    low, high = RANGE
    if not stable(low):
        return math.nan
    if stable(high):
        return math.inf
    while high / low > WIDTH:
        middle = math.sqrt(low * high)
        low, high = (middle, high) if stable(middle) else (low, middle)
    return low


def shaken_mpm(values: Mapping[str, Any], factor: float) -> bool:
    """Whether a strip beside a still tool, stretched at random without a change of volume, keeps its energy."""
    case = load("mpm", {**STRIP, "hardening": "none", "reach_ratio": 0.0, **values})
    state = setup.build(with_step(case, factor))
    state.wedge = state.wedge._replace(speed=0.0, feedback=0.0)
    lanes = state.points.reshape(-1, layout.POINT_FIELDS, layout.LANES)
    stretch = 1.0 + np.random.default_rng(1).normal(scale=1e-4, size=lanes[:, 0, :].shape)
    for row, power in ((layout.FXX, 1), (layout.FYY, -1), (layout.BXX, 2), (layout.BYY, -2)):
        lanes[:, row, :] = stretch**power
    solver = Solver(state)

    def total() -> float:
        return float(solver.energies()[:, [0, 2]].sum() + state.totals[step.COHESIVE])

    start = total()
    for _ in range(STEPS // 100):
        solver.advance(100)
        if not total() < GROWTH * start or solver.escaped:
            return False
    return True


def shaken_dem(values: Mapping[str, Any], factor: float) -> bool:
    """Whether a block of unbreakable joints with random velocities keeps its energy."""
    case = with_step(load("dem", {**BLOCK, **UNBREAKABLE, **values}), factor)
    packed = pack(case.packing)
    scene = build(packed.x, packed.y, packed.radius, case.joint)
    scene.speeds[:, :2] = np.random.default_rng(1).normal(scale=1e-3, size=(len(packed.x), 2))
    start = energies(scene).energy_kinetic
    for _ in range(STEPS // 100):
        if advance(scene, 100) != DONE:
            return False
        now = energies(scene)
        if not now.energy_kinetic + now.energy_elastic < GROWTH * start:
            return False
    return True


def cut(solver: str, values: Mapping[str, Any], factor: float) -> bool:
    """Whether a short cut reaches its end."""
    base = STRIP if solver == "mpm" else BLOCK
    try:
        run_case(with_step(load(solver, {**base, **values}), factor), snapshots=0)
    except Diverged:
        return False
    return True


def with_step(case: Case, factor: float) -> Case:
    """The case with another step, also beyond what a study may ask for."""
    if case.kind == "mpm_cutting":
        return case.model_copy(update={"numerics": case.numerics.model_copy(update={"courant": factor})})
    return case.model_copy(update={"joint": case.joint.model_copy(update={"time_step_factor": factor})})


def main() -> None:
    """Measure all variants; write a table and a picture."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/stable_step.csv"))
    options = parser.parse_args()

    rows = []
    jobs = [("mpm", *item) for item in MPM.items()] + [("dem", *item) for item in DEM.items()]
    for solver, name, values in track(jobs, "measuring", console=Console(stderr=True)):
        shaken = shaken_mpm if solver == "mpm" else shaken_dem
        used = load("mpm").numerics.courant if solver == "mpm" else load("dem").joint.time_step_factor
        limits = largest(partial(shaken, values)), largest(partial(cut, solver, values))
        rows.append([solver, name, used, *limits, *(limit / used for limit in limits)])
    write_table(HEADER, rows, options.output)
    save(draw(rows), options.output.with_suffix(".png"))


@styled
def draw(rows: Sequence[Sequence[Any]]) -> Figure:
    """Margin of the default step, by variant of each solver."""
    counts = [sum(row[0] == solver for row in rows) for solver in NAMES]
    figure = page(0.17 * sum(counts) + 1.4, PAGE)
    panels = figure.subplots(2, 1, sharex=True, height_ratios=counts)
    for ax, (solver, title) in zip(panels, NAMES.items(), strict=True):
        own = [row for row in rows if row[0] == solver][::-1]
        places = range(len(own))
        ax.plot([row[5] for row in own], places, "o", color=BLUE, label="shaken")
        ax.plot([row[6] for row in own], places, "D", color=ORANGE, mfc="white", label="cut")
        ax.set_yticks(places, [row[1] for row in own])
        ax.set_title(title, loc="left")
        ax.axvline(1.0, color=BLACK, lw=0.6)
        ax.set_xlim(left=0)
    panels[-1].set_xlabel("largest stable step over that of the default case [-]")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure


if __name__ == "__main__":
    main()
