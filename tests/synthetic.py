"""Synthetic runs: datasets of the right shape with made-up numbers, for tests of what reads runs.

No solver made them.
"""

import math

import numpy as np

from orthocut.io.datasets import build
from orthocut.params.case import load

SAMPLES = 200
HISTORY = ("sample",)


def make_case(kind, **values):
    return load(kind, values)


def _finish(case, data, wall_time):
    dataset = build(case, "synthetic", data)
    dataset.attrs["wall_time_s"] = wall_time
    return dataset


def mpm_run(snapshots=4, wall_time=3.5, force=None, touching=0, **values):
    """A cut whose chip is the material above y = 0, turned up along the rake face."""
    case = make_case("mpm_cutting", **{"numerics.points_per_depth": 4, **values})
    h, alpha = case.cut_depth, case.tool.rake_angle
    travel = np.linspace(0, case.travel_ratio * h, SAMPLES)
    time = travel / case.cut_speed * 1.2
    force = force or 6000.0 * (1 + 0.4 * h / 0.9e-3)
    rise = 1 - np.exp(-travel / (1.5 * h))
    cutting = force * rise * (1 + 0.06 * np.sin(travel / h * 14))
    thrust = -math.tan(alpha) * cutting
    work = np.concatenate([[0], np.cumsum(0.5 * (cutting[1:] + cutting[:-1]) * np.diff(travel))])
    tip = case.workpiece.length_ratio * h - travel
    shares = {"elastic": 0.1, "plastic": 0.45, "cohesive": 0.3, "friction": 0.0, "kinetic": 0.02, "numerical": 0.08}
    shares["contact"] = 0.03
    data = {
        "time": (HISTORY, time),
        "tool_travel": (HISTORY, travel),
        "force_cutting": (HISTORY, cutting),
        "force_thrust": (HISTORY, thrust),
        "force_thrust_base": (HISTORY, 0.1 * cutting),
        "work_tool": (HISTORY, work),
        "tool_tip": (HISTORY, tip),
        "crack_tip": (HISTORY, tip - (0.1 if touching else 0.6) * h),
        **{f"energy_{name}": (HISTORY, share * work) for name, share in shares.items()},
        "force_cutting_mean": ((), force),
        "force_thrust_mean": ((), -math.tan(alpha) * force),
        "force_cutting_error": ((), 0.03 * force),
        "force_cutting_drift": ((), 0.05),
        "force_rubbing_mean": ((), 0.1 * force),
        "touching": ((), touching),
        "energy_closure": ((), 0.02),
        "mode_one_fraction": ((), 0.9),
    }
    if snapshots:
        data |= _points(case, snapshots, travel, time)
    return _finish(case, data, wall_time)


def _points(case, snapshots, travel, time):
    h, n = case.cut_depth, case.numerics.points_per_depth
    step = h / n
    length, depth = case.workpiece.length_ratio * h, case.workpiece.base_ratio * h
    x0, y0 = np.meshgrid(np.arange(step / 2, length, step), np.arange(-depth + step / 2, h, step))
    x0, y0 = x0.ravel(), y0.ravel()
    frames = np.linspace(0, SAMPLES - 1, snapshots).astype(int)
    shape = (snapshots, x0.size)
    x, y, stress, deformation = np.tile(x0, (snapshots, 1)), np.tile(y0, (snapshots, 1)), np.zeros(shape), []
    for row, frame in enumerate(frames):
        tip = length - travel[frame]
        chip = (y0 > 0) & (x0 > tip)
        angle = np.where(chip, 0.5 * math.pi - case.tool.rake_angle, 0.0)
        x[row] = np.where(chip, tip + (x0 - tip) * np.cos(angle) - y0 * np.sin(angle), x0)
        y[row] = np.where(chip, (x0 - tip) * np.sin(angle) + y0 * np.cos(angle), y0)
        stress[row] = 40e6 * np.exp(-np.hypot(x[row] - tip, y[row]) / (2 * h)) + 5e6 * chip
        cosine, sine = np.cos(angle), np.sin(angle)
        deformation.append(np.stack([cosine, -sine, sine, cosine], axis=-1))
    dims = ("snapshot", "point")
    return {
        "time_snapshot": (("snapshot",), time[frames]),
        "tool_tip_snapshot": (("snapshot",), length - travel[frames]),
        "point_x": (dims, x),
        "point_y": (dims, y),
        "point_stress": (dims, stress),
        "point_strain_plastic": (dims, stress / 50e6),
        "point_deformation": ((*dims, "component"), np.array(deformation)),
        "point_half_width": ((), step / 2),
    }


def _discs(case, snapshots, random):
    """Hexagonal packing with some play, joints between neighbours."""
    mean = case.packing.radius_min * (1 + case.packing.radius_ratio) / 2
    x, y = np.meshgrid(
        np.arange(mean, case.packing.width, 2 * mean), np.arange(mean, case.packing.height, math.sqrt(3) * mean)
    )
    x = x + (np.arange(x.shape[0]) % 2)[:, None] * mean
    inside = x.ravel() < case.packing.width - 0.5 * mean
    x, y = x.ravel()[inside], y.ravel()[inside]
    radius = mean * random.uniform(0.9, 1.05, x.size)
    near = np.hypot(x[:, None] - x, y[:, None] - y) < 2.1 * mean
    first, second = np.nonzero(np.triu(near, 1))
    return np.tile(x, (snapshots, 1)), np.tile(y, (snapshots, 1)), radius, first, second


def _scene(snapshots, random, x, y, radius, first, second, crack_x, crack_y, duration):
    count = crack_x.size
    intact = np.ones((snapshots, first.size))
    intact[-1, random.random(first.size) < 0.03] = 0.0
    return {
        "time_snapshot": (("snapshot",), np.linspace(0, duration, snapshots)),
        "disc_x": (("snapshot", "disc"), x),
        "disc_y": (("snapshot", "disc"), y),
        "disc_radius": (("disc",), radius),
        "bond_first": (("bond",), first),
        "bond_second": (("bond",), second),
        "bond_intact": (("snapshot", "bond"), intact),
        "crack_x": (("crack",), crack_x),
        "crack_y": (("crack",), crack_y),
        "crack_normal": (("crack",), random.uniform(0, math.pi, count)),
        "crack_time": (("crack",), np.sort(random.uniform(0, duration, count))),
        "crack_mode": (("crack",), (random.random(count) < 0.4).astype(np.int8)),
    }


def dem_cut_run(snapshots=2, cracks=80, wall_time=7.0, **values):
    """A cut of a block of large discs, with random peaks of force and cracks around the path of the tool."""
    case = make_case("dem_cutting", **{"packing.radius_min": "15 um", **values})
    random = np.random.default_rng(case.packing.seed)
    travel = np.linspace(0, case.travel, SAMPLES)
    force = 15e3 * (case.cut_depth / 0.1e-3) ** 0.24 * (0.15 if case.grooves is not None else 1.0)
    cutting = force * random.exponential(1.0, SAMPLES)
    thrust = 0.7 * force * random.exponential(1.0, SAMPLES)
    data = {
        "time": (HISTORY, travel / case.cut_speed),
        "tool_travel": (HISTORY, travel),
        "force_cutting": (HISTORY, cutting),
        "force_thrust": (HISTORY, thrust),
        "force_cutting_mean": ((), cutting.mean()),
        "force_thrust_mean": ((), thrust.mean()),
        "force_cutting_error": ((), cutting.std() / 14),
        **{f"{name}_peak": ((), 5 * mean) for name, mean in (("force_cutting", force), ("force_thrust", 0.7 * force))},
        "air_share": ((), 0.1),
        "damage_depth": ((), 0.1e-3),
        "damage_depth_most": ((), 0.08e-3),
        **{
            f"cracks_{mode}_{place}": ((), cracks // 4) for mode in ("tension", "shear") for place in ("total", "below")
        },
        "chip_count": ((), 7),
        "chip_area_largest": ((), 0.01e-6),
        "chip_area_total": ((), 0.03e-6),
    }
    x, y, radius, first, second = _discs(case, snapshots, random)
    floor = case.packing.height - case.cut_depth
    chip = (y[-1] > floor) & (x[-1] > case.packing.width - case.travel)
    x[-1, chip] -= 0.1e-3
    y[-1, chip] += 0.08e-3 + 0.1e-3 * random.random(chip.sum())
    crack_x = case.packing.width - case.travel * random.random(cracks)
    crack_y = floor + 0.05e-3 * random.standard_normal(cracks)
    duration = case.travel / case.cut_speed
    data |= _scene(snapshots, random, x, y, radius, first, second, crack_x, crack_y, duration)
    data["disc_fixed"] = (("disc",), (np.minimum(x[0], y[0]) < 2 * radius).astype(np.int8))
    data["tool_tip_snapshot"] = (("snapshot",), case.packing.width - np.linspace(0, case.travel, snapshots))
    return _finish(case, data, wall_time)


def dem_test_run(kind="dem_tension", cracks=40, wall_time=5.0, **values):
    """A strength test with a parabola for its curve and cracks in a band."""
    case = make_case(kind, **{"packing.radius_min": "20 um", **values})
    random = np.random.default_rng(case.packing.seed)
    sign, strength = (-1, 330e6) if kind == "dem_compression" else (1, 42e6)
    strain = np.linspace(0, 2 * strength / 71e9 * 0.9, SAMPLES)
    stress = 71e9 * strain * (1 - strain * 71e9 / (4 * strength)) * (1 + 0.02 * case.packing.seed)
    x, y, radius, first, second = _discs(case, 2, random)
    crack_x = case.packing.width * random.random(cracks)
    crack_y = 0.5 * case.packing.height + 0.03e-3 * random.standard_normal(cracks)
    data = {
        "time": (HISTORY, strain * case.packing.height / (2 * case.grip_speed)),
        "strain_axial": (HISTORY, sign * strain),
        "strain_gauge": (HISTORY, 0.9 * sign * strain),
        "strain_lateral": (HISTORY, -0.23 * sign * strain),
        "stress_axial": (HISTORY, sign * stress),
        "stress_grip": (HISTORY, sign * stress * 1.01),
        "modulus_young": ((), 71e9),
        "ratio_poisson": ((), 0.23),
        "strength_ultimate": ((), stress.max()),
        "cracks_tension_total": ((), cracks // 2),
        "cracks_shear_total": ((), cracks // 3),
        **_scene(2, random, x, y, radius, first, second, crack_x, crack_y, 1e-3),
    }
    if kind == "dem_toughness":
        data["toughness_fracture"] = ((), 0.45e6 * (1 + 0.02 * case.packing.seed))
    return _finish(case, data, wall_time)


def failed(run):
    """The same run with every float lost, as a solver that broke down would leave it."""
    lost = run.copy(deep=True)
    for name, variable in lost.data_vars.items():
        if np.issubdtype(variable.dtype, np.floating):
            lost[name][...] = np.nan
    return lost
