"""Random scenes of both solvers, over every range that a case allows and a little beyond, made small enough to try."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from scipy.stats import qmc

from orthocut.cost import estimate_seconds
from orthocut.params.case import Case, validate
from orthocut.params.size import particles, steps

BEYOND = 0.01
"""Share of a range by which numbers go beyond each of its ends."""
SECONDS = 0.8
"""Predicted run time to which a scene is cut down [s]."""
FASTEST = 0.02
"""Speed over that of waves up to which a tool is sped up to cut a scene down."""
MOST = {"mpm": 100.0, "dem": 20.0}
"""Largest speed of a tool that a case allows [m/s]."""
SEED = 6


class Range(NamedTuple):
    """Where a number is drawn from, evenly or evenly in its logarithm."""

    low: float
    high: float
    log: bool = False

    def at(self, share: float) -> float:
        """Value at a share of the range, which reaches a little beyond both ends."""
        wide = (share - 0.5) * (1 + 2 * BEYOND) + 0.5
        return self.low * (self.high / self.low) ** wide if self.log else self.low + wide * (self.high - self.low)


class Scene(NamedTuple):
    """A scene before it is validated: what was drawn, and the fields of a case."""

    solver: str
    number: int
    drawn: dict[str, float]
    fields: dict[str, Any]


MPM = {
    "cut_depth_mm": Range(0.02, 20.0, log=True),
    "rake_angle_deg": Range(-45.0, 70.0),
    "clearance_angle_deg": Range(0.0, 20.0),
    "friction": Range(0.0, 1.5),
    "modulus_young_MPa": Range(10.0, 200e3, log=True),
    "ratio_poisson": Range(0.0, 0.49),
    "stress_yield_share": Range(1e-3, 0.2, log=True),
    "modulus_tangent_share": Range(0.0, 0.9),
    "strength_MPa": Range(1.0, 400.0, log=True),
    "toughness_J_m2": Range(10.0, 1e5, log=True),
    "points_per_depth": Range(2, 20),
    "cut_speed_m_s": Range(0.05, 100.0, log=True),
    "courant": Range(0.05, 1.0, log=True),
    "affine": Range(0.0, 1.0),
    "support": Range(0.0, 0.1),
    "base_ratio": Range(0.5, 3.0),
    "laws": Range(0, 1),
    "bottom": Range(0, 1),
    "path": Range(0, 1),
}
"""Fields of ductile cuts and where they are drawn from; shares are of Young's modulus."""
DEM = {
    "kind": Range(0, 1),
    "radius_ratio": Range(1.0, 4.0),
    "elements": Range(1, 4),
    "stiffness_ratio": Range(1.0, 10.0),
    "strength_times": Range(0.01, 100.0, log=True),
    "cohesion_times": Range(0.01, 100.0, log=True),
    "friction_angle_deg": Range(0.0, 60.0),
    "friction": Range(0.0, 1.5),
    "rake_angle_deg": Range(-45.0, 70.0),
    "clearance_angle_deg": Range(0.0, 20.0),
    "friction_tool": Range(0.0, 1.5),
    "depth_grains": Range(0.95, 7.2, log=True),
    "travel_grains": Range(1.0, 10.0),
    "cut_speed_m_s": Range(0.01, 20.0, log=True),
    "modulus_GPa": Range(1.0, 1000.0, log=True),
    "damping": Range(0.0, 0.95),
    "time_step_factor": Range(0.05, 1.0, log=True),
    "groove_grains": Range(-10.0, 10.0),
    "distance_grains": Range(0.5, 6.0, log=True),
    "bottom_ratio": Range(0.0, 1.0),
    "porosity_cloud": Range(0.05, 0.2),
    "pressure_ratio": Range(1e-4, 0.1, log=True),
    "gap_ratio": Range(-0.3, 0.3),
    "loose": Range(-1.0, 1.0),
    "radius_multiplier": Range(0.1, 1.0),
}
"""Fields of scenes of bonded discs and where they are drawn from; strengths are over those of Table 1."""
RANGES = {"mpm": MPM, "dem": DEM}

LAWS = (
    {},
    {},
    {"interface": {"failure_criterion": "coupled"}},
    {"material": {"hardening": "none"}, "interface": {"failure_criterion": "dissipated"}},
    {"material": {"hardening": "voce"}, "interface": {"law": "triangular"}},
    {"material": {"hardening": "ludwik"}, "numerics": {"contact": "cells"}},
    {"numerics": {"scheme": "usavg"}},
    {"numerics": {"scheme": "usavg", "contact": "cells", "flip": 0.5}},
)
"""Laws and loops of ductile cuts, some of all there are: kernels are compiled for each."""
KINDS = (*7 * ("dem_cutting",), "dem_tension", "dem_compression", "dem_brazilian")


def draw(solver: str, count: int, seed: int = SEED) -> list[Scene]:
    """Scenes of a solver from a scrambled Sobol sequence: the first ones are the same however many are wanted."""
    ranges = RANGES[solver]
    sequence = qmc.Sobol(len(ranges), seed=seed)
    shares = sequence.random_base2(math.ceil(math.log2(max(count, 2))))[:count]
    scenes = []
    for number, row in enumerate(shares):
        drawn = {name: limits.at(float(share)) for (name, limits), share in zip(ranges.items(), row, strict=True)}
        scenes.append(Scene(solver, number, drawn, FIELDS[solver](drawn)))
    return scenes


def cut_down(scene: Scene) -> Case:
    """Case of a scene that is predicted to take no more than `SECONDS`: shorter, then faster, then coarser.

    Raises
    ------
    ConfigError
        If the scene as drawn is refused, or none of its small forms is valid.
    """
    fields = scene.fields
    case = validate(fields)
    travel = "travel_ratio" if scene.solver == "mpm" else "travel"
    if estimate_seconds(case) > SECONDS and travel in fields:
        fields = {**fields, **_shorter(fields)}
        case = validate(fields)
    speed = "grip_speed" if case.kind in ("dem_tension", "dem_compression", "dem_brazilian") else "cut_speed"
    if (excess := estimate_seconds(case) / SECONDS) > 1:
        now = getattr(case, speed)
        limit = min(FASTEST * _wave_speed(case), MOST[case.kind[:3]]) if speed == "cut_speed" else 1.0
        fields = {**fields, speed: f"{max(now, min(now * excess, limit))!r} m/s"}
        case = validate(fields)
    while estimate_seconds(case) > 3 * SECONDS and scene.solver == "mpm" and case.numerics.points_per_depth > 2:
        numerics = {**fields["numerics"], "points_per_depth": case.numerics.points_per_depth - 1}
        fields = {**fields, "numerics": numerics}
        case = validate(fields)
    return case


def describe(case: Case) -> dict[str, Any]:
    """What is left of a scene that was cut down: kind, size, speed over that of waves."""
    size = {"kind": case.kind, "particles": round(particles(case)), "steps": round(steps(case))}
    if case.kind == "mpm_cutting":
        size |= {"points_per_depth": case.numerics.points_per_depth, "travel_ratio": case.travel_ratio}
    speed = getattr(case, "cut_speed", None)
    return size if speed is None else size | {"speed over waves": speed / _wave_speed(case)}


def _shorter(fields: Mapping[str, Any]) -> dict[str, Any]:
    if fields["kind"] != "mpm_cutting":
        return {"travel": f"{GRAIN!r} m"} if "travel" in fields else {}
    return {"travel_ratio": 1.5, "window_ratio": 0.5, "workpiece": {**fields["workpiece"], "length_ratio": 6.0}}


def _wave_speed(case: Case) -> float:
    if case.kind == "mpm_cutting":
        return case.material.speed_pressure_wave
    return math.sqrt(case.joint.modulus / case.joint.density)


def _pick(options: tuple, share: float):
    return options[min(max(int(share * len(options)), 0), len(options) - 1)]


def _mpm(drawn: Mapping[str, float]) -> dict[str, Any]:
    """Fields of a ductile cut of three depths in a strip of eight."""
    young, poisson = drawn["modulus_young_MPa"], drawn["ratio_poisson"]
    bulk, shear = young / (3 * (1 - 2 * poisson)), young / (2 * (1 + poisson))
    laws = _pick(LAWS, drawn["laws"])
    hardening = laws.get("material", {}).get("hardening", "linear")
    usavg = laws.get("numerics", {}).get("scheme") == "usavg"
    stress = drawn["stress_yield_share"] * young
    silent = drawn["bottom"] > 0.85 and not usavg
    of_law = {
        "linear": {
            "stress_yield": f"{stress!r} MPa",
            "modulus_tangent": f"{drawn['modulus_tangent_share'] * young!r} MPa",
        },
        "ludwik": {"stress_yield": f"{stress!r} MPa", "hardening_modulus": f"{2 * stress!r} MPa"},
        "voce": {"stress_yield": f"{stress!r} MPa", "stress_saturation": f"{1.5 * stress!r} MPa"},
        "none": {},
    }[hardening]
    ours = {"affine": drawn["affine"], "support": drawn["support"], "reach_ratio": 0.0 if silent else 8.0}
    return {
        "kind": "mpm_cutting",
        "cut_depth": f"{drawn['cut_depth_mm']!r} mm",
        "cut_speed": f"{drawn['cut_speed_m_s']!r} m/s",
        "travel_ratio": 3.0,
        "window_ratio": 1.0,
        "tool": {
            "rake_angle": f"{drawn['rake_angle_deg']!r} deg",
            "clearance_angle": f"{drawn['clearance_angle_deg']!r} deg",
            "friction": drawn["friction"],
        },
        "material": {
            "modulus_bulk": f"{bulk!r} MPa",
            "modulus_shear": f"{shear!r} MPa",
            **laws.get("material", {}),
            **of_law,
        },
        "interface": {
            "strength": f"{drawn['strength_MPa']!r} MPa",
            "toughness": f"{drawn['toughness_J_m2']!r} J/m^2",
            **laws.get("interface", {}),
        },
        "workpiece": {
            "length_ratio": 8.0,
            "base_ratio": drawn["base_ratio"],
            "notch_ratio": 0.5,
            "path_ratio": 4.0 if drawn["path"] > 0.8 else 0.0,
            "bottom": "silent" if silent else "clamped",
        },
        "numerics": {
            "points_per_depth": round(drawn["points_per_depth"]),
            "courant": drawn["courant"],
            **({"affine": 0.0, "support": 0.0, "reach_ratio": 0.0} if usavg else ours),
            **laws.get("numerics", {}),
        },
    }


RADIUS = 10e-6
GRAIN = 2 * RADIUS
BLOCK = 14 * GRAIN
"""Smallest radius of a disc, diameter, and side of a block of discs of one size [m]."""


def _dem(drawn: Mapping[str, float]) -> dict[str, Any]:
    """Fields of a cut of a small block, or of a test of a small specimen."""
    kind = _pick(KINDS, drawn["kind"])
    ratio = max(drawn["radius_ratio"], 1.0)
    side = BLOCK * math.sqrt((1 + ratio + ratio**2) / 3)
    loose = abs(drawn["loose"])
    joint: dict[str, Any] = {
        "modulus": f"{drawn['modulus_GPa']!r} GPa",
        "stiffness_ratio": drawn["stiffness_ratio"],
        "strength_tensile": f"{200 * drawn['strength_times']!r} MPa",
        "cohesion": f"{113 * drawn['cohesion_times']!r} MPa",
        "friction_angle": f"{drawn['friction_angle_deg']!r} deg",
        "friction": drawn["friction"],
        "elements": round(drawn["elements"]),
        "radius_multiplier": drawn["radius_multiplier"],
        "gap_ratio": max(drawn["gap_ratio"], 0.0),
        "damping": drawn["damping"],
        "time_step_factor": drawn["time_step_factor"],
    }
    if drawn["loose"] < 0:
        joint |= {"fraction_slit": loose} if loose < 0.5 else {"fraction_gapped": 2 * loose - 1}
    fields: dict[str, Any] = {
        "kind": kind,
        "packing": {
            "width": f"{side!r} m",
            "height": f"{side * (2 if kind in ('dem_tension', 'dem_compression') else 1)!r} m",
            "radius_min": f"{RADIUS!r} m",
            "radius_ratio": drawn["radius_ratio"],
            "porosity_cloud": drawn["porosity_cloud"],
            "pressure_ratio": drawn["pressure_ratio"],
        },
        "joint": joint,
    }
    if kind != "dem_cutting":
        return fields | {"strain_max": 0.01, "grip_speed": f"{min(drawn['cut_speed_m_s'], 1.0)!r} m/s"}
    grooves = {
        "width": f"{drawn['groove_grains'] * GRAIN!r} m",
        "distance": f"{drawn['distance_grains'] * GRAIN!r} m",
        "bottom_ratio": drawn["bottom_ratio"],
    }
    return fields | {
        "cut_depth": f"{drawn['depth_grains'] * GRAIN!r} m",
        "travel": f"{drawn['travel_grains'] * GRAIN!r} m",
        "cut_speed": f"{drawn['cut_speed_m_s']!r} m/s",
        "tool": {
            "rake_angle": f"{drawn['rake_angle_deg']!r} deg",
            "clearance_angle": f"{drawn['clearance_angle_deg']!r} deg",
            "friction": drawn["friction_tool"],
        },
        **({"grooves": grooves} if drawn["groove_grains"] > 0 else {}),
    }


FIELDS: dict[str, Callable[[Mapping[str, float]], dict[str, Any]]] = {"mpm": _mpm, "dem": _dem}
