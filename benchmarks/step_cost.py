"""Cost of a step of both methods for several sizes of the scene; prints one JSON object a line."""

import json

from orthocut.experiments.speed_dem import bench_dem
from orthocut.experiments.speed_mpm import bench_mpm

STEPS = 6_000_000
"""Particles times steps of one repeat."""

if __name__ == "__main__":
    for points_per_depth in (6, 10, 15, 30):
        points = 118 * points_per_depth**2
        print(json.dumps(bench_mpm(points_per_depth, steps=max(50, STEPS // points))), flush=True)
    for discs in (500, 2085, 7406, 29_624):
        print(json.dumps(bench_dem(discs, steps=max(200, STEPS // discs))), flush=True)
