"""Material points in Taichi and here: cost of a point and step, and ratios.

Taichi is a compiler for such loops, and material points are its showpiece. The step is written with its means as its
own examples are: one particle a thread-loop turn, quadratic splines on nine nodes, velocity gradients handed on, the
same law (neo-Hookean with von Mises yielding and hardening), no contact and no interface. Ours does both and keeps the
books. Both run on one core, each round one after the other, in CPU time. Taichi comes from PyPI
(`pip install orthocut[peers]`).
"""

import argparse
import csv
import importlib.util
import statistics
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from orthocut.experiments.speed_mpm import bench_mpm

OURS, THEIRS = "orthocut, whole cut", "Taichi, transfers and law"
HEADER = ["program", "precision", "points", "cost of a point and step [ns]", "over ours [-]"]
STEPS = 100


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=27_000, help="number of points, about")
    parser.add_argument("--rounds", type=int, default=5, help="rounds over all programs")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/peers_mpm.csv"))
    options = parser.parse_args()
    if importlib.util.find_spec("taichi") is None:
        parser.error("Taichi is not installed: pip install 'orthocut[peers]'")

    depth = round((options.points / 118) ** 0.5)
    programs: dict[tuple[str, str], Callable[[], tuple[int, float]]] = {
        (OURS, "double"): lambda: ours(depth),
        (THEIRS, "double"): taichi_step(options.points, "f64"),
    }
    costs: dict[tuple[str, str], list[tuple[int, float]]] = {name: [] for name in programs}
    for _ in track(range(options.rounds), "measuring", console=Console(stderr=True)):
        for name, program in programs.items():
            costs[name].append(program())

    table = Table(*HEADER)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for name, found in costs.items():
            pairs = zip(found, costs[OURS, "double"], strict=True)
            ratio = statistics.median(own[1] / base[1] for own, base in pairs)
            cost = statistics.median(one[1] for one in found)
            row = [*name, str(found[0][0]), f"{cost:.3g}", f"{ratio:.3g}"]
            writer.writerow(row)
            table.add_row(*row)
    Console().print(table)


def ours(points_per_depth: int) -> tuple[int, float]:
    """Points, and cost of one and a step of a whole cut, none at rest [ns]."""
    found = bench_mpm(points_per_depth, STEPS, 1, {"reach_ratio": 0.0})
    return found["points"], found["ns_per_point_step"]


def taichi_step(points: int, precision: str) -> Callable[[], tuple[int, float]]:
    """Measurement of a block of points, four in a cell, that deforms slowly."""
    import taichi as ti

    ti.init(arch=ti.cpu, cpu_max_num_threads=1, default_fp=getattr(ti, precision), log_level=ti.WARN)
    side = int((points / 4) ** 0.5)
    cells = side + 8
    count = 4 * side * side
    spacing = 1.0 / cells
    vector, matrix = ti.types.vector(2, float), ti.types.matrix(2, 2, float)
    position, velocity = ti.Vector.field(2, float, count), ti.Vector.field(2, float, count)
    affine, strain = ti.Matrix.field(2, 2, float, count), ti.Matrix.field(2, 2, float, count)
    volume, plastic = ti.field(float, count), ti.field(float, count)
    momentum, mass = ti.Vector.field(2, float, (cells, cells)), ti.field(float, (cells, cells))
    density, shear, bulk, strength, slope = 1.0, 100.0, 200.0, 0.5, 1.0
    time_step = 0.2 * spacing / ((bulk + 4 / 3 * shear) / density) ** 0.5
    each = density * spacing**2 / 4

    @ti.func
    def weights(offset: vector) -> ti.types.matrix(3, 2, float):
        first, middle, last = 0.5 * (1.5 - offset) ** 2, 0.75 - (offset - 1.0) ** 2, 0.5 * (offset - 0.5) ** 2
        return ti.Matrix.rows([first, middle, last])

    @ti.func
    def stress(p: int) -> matrix:
        # Left Cauchy-Green tensor in the plane, scaled to unit volume; yielding shrinks its deviator.
        ratio = volume[p]
        scaled = strain[p] / ratio ** (2.0 / 3.0)
        third = ratio ** (-2.0 / 3.0)
        mean = (scaled.trace() + third) / 3.0
        deviator = scaled - mean * ti.Matrix.identity(float, 2)
        norm = ti.sqrt(deviator.norm_sqr() + (third - mean) ** 2) * shear
        limit = ti.sqrt(2.0 / 3.0) * (strength + slope * plastic[p])
        excess = ti.max(norm - limit, 0.0)
        plastic[p] += excess / (2.0 * shear * mean + slope)
        deviator *= 1.0 - excess / ti.max(norm, 1e-30)
        strain[p] = (deviator + mean * ti.Matrix.identity(float, 2)) * ratio ** (2.0 / 3.0)
        pressure = 0.5 * bulk * (ratio - 1.0 / ratio)
        return shear / ratio * deviator + pressure * ti.Matrix.identity(float, 2)

    @ti.kernel
    def step():
        for cell in ti.grouped(mass):
            momentum[cell] = vector(0.0, 0.0)
            mass[cell] = 0.0
        for p in position:
            base = (position[p] / spacing - 0.5).cast(int)
            offset = position[p] / spacing - base.cast(float)
            w = weights(offset)
            push = -time_step * each / density * volume[p] * 4.0 / spacing**2 * stress(p) + each * affine[p]
            for i, j in ti.static(ti.ndrange(3, 3)):
                arm = (vector(i, j) - offset) * spacing
                weight = w[i, 0] * w[j, 1]
                momentum[base + ti.Vector([i, j])] += weight * (each * velocity[p] + push @ arm)
                mass[base + ti.Vector([i, j])] += weight * each
        for cell in ti.grouped(mass):
            if mass[cell] > 0.0:
                momentum[cell] /= mass[cell]
        for p in position:
            base = (position[p] / spacing - 0.5).cast(int)
            offset = position[p] / spacing - base.cast(float)
            w = weights(offset)
            new_velocity, new_affine = vector(0.0, 0.0), ti.Matrix.zero(float, 2, 2)
            for i, j in ti.static(ti.ndrange(3, 3)):
                found = momentum[base + ti.Vector([i, j])]
                weight = w[i, 0] * w[j, 1]
                new_velocity += weight * found
                new_affine += weight * found.outer_product(vector(i, j) - offset) * 4.0 / spacing
            velocity[p], affine[p] = new_velocity, new_affine
            change = ti.Matrix.identity(float, 2) + time_step * new_affine
            strain[p] = change @ strain[p] @ change.transpose()
            volume[p] *= change.determinant()
            position[p] += time_step * new_velocity

    places = (np.mgrid[: 2 * side, : 2 * side].reshape(2, -1).T + 0.5) / 2 + 4
    position.from_numpy(places * spacing)
    velocity.from_numpy(1e-3 * (places / cells - 0.5))
    strain.from_numpy(np.tile(np.eye(2), (count, 1, 1)))
    volume.fill(1.0)

    def measure() -> tuple[int, float]:
        start = time.process_time()
        for _ in range(STEPS):
            step()
        ti.sync()
        cost = 1e9 * (time.process_time() - start) / STEPS / count
        assert np.isfinite(position.to_numpy()).all()
        return count, cost

    for _ in range(2):
        measure()
    return measure


if __name__ == "__main__":
    main()
