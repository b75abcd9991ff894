"""Numbers of Yang et al. (2018): Tables 1, 2, 4 and 6.

Forces are raw newtons: the simulated cut is 1 mm wide (Table 3), the one of the experiments 25.4 mm (Table 5).
"""

from __future__ import annotations

from typing import NamedTuple

FORCES = ("force_cutting", "force_thrust")
"""The two components of the force on the tool."""
NAMES = {"force_cutting": "main", "force_thrust": "thrust"}
"""What the paper calls them."""
WIDTHS = {"simulation": 1.0, "experiment": 25.4}
"""Widths of the cuts [mm]."""
Cut = tuple[float, bool]
"""Depth of cut [mm] and whether the surface is grooved."""

SIMULATION: dict[Cut, dict[str, tuple[float, ...]]] = {
    (0.1, False): {"force_cutting": (14.15, 15.40, 15.38), "force_thrust": (10.29, 9.27, 10.38)},
    (0.1, True): {"force_cutting": (1.72, 2.82, 1.60), "force_thrust": (2.84, 3.13, 2.87)},
    (0.2, False): {"force_cutting": (17.45, 17.24, 18.41), "force_thrust": (13.54, 12.16, 12.19)},
    (0.2, True): {"force_cutting": (3.68, 3.14, 3.73), "force_thrust": (2.98, 2.95, 1.06)},
}
"""Table 4: mean forces of three replicates [N]."""

EXPERIMENT: dict[Cut, dict[str, tuple[float, ...]]] = {
    (0.1, False): {"force_cutting": (17.8, 15.0, 16.7), "force_thrust": (14.1, 12.5, 14.0)},
    (0.1, True): {"force_cutting": (2.0, 2.9, 2.6), "force_thrust": (3.1, 4.0, 3.2)},
    (0.2, False): {"force_cutting": (19.9, 18.1, 19.2), "force_thrust": (15.5, 14.6, 14.8)},
    (0.2, True): {"force_cutting": (4.3, 4.6, 3.9), "force_thrust": (5.6, 6.4, 5.4)},
}
"""Table 6: mean forces of three experiments [N]."""


class Parameter(NamedTuple):
    """A row of Table 1."""

    words: str
    symbol: str
    """As in the paper, in mathtext."""
    value: float
    """In the unit named."""
    unit: str
    field: str
    """Name in `orthocut.io.collect.parameters`."""
    scale: float = 1.0
    """Number of units in one SI unit."""
    remark: str = ""


TABLE_1 = (
    Parameter("ball density", r"\rho", 2400.0, "kg/m3", "joint_density"),
    Parameter("sample height", "H", 2.0, "mm", "packing_height", 1e3),
    Parameter("sample width", "W", 1.0, "mm", "packing_width", 1e3),
    Parameter(
        "minimum ball radius",
        "R_{min}",
        15.0,
        "um",
        "packing_radius_min",
        1e6,
        "7406 discs of this radius do not fit into 1 mm x 2 mm; as a diameter they do",
    ),
    Parameter(
        "ratio of largest to smallest radius",
        "R_{max}/R_{min}",
        4 / 3,
        "-",
        "packing_radius_ratio",
        1.0,
        "R_max is printed as 2.0e-3 m; 2.0e-5 m is meant",
    ),
    Parameter("ball-ball contact modulus", "E_c", 107.0, "GPa", "joint_modulus", 1e-9),
    Parameter("ball stiffness ratio", "k_n/k_s", 3.1, "-", "joint_stiffness_ratio", 1.0, "printed as 3.1 x 10"),
    Parameter("flat-joint bond modulus", r"\bar E_c", 107.0, "GPa", "joint_modulus", 1e-9),
    Parameter("flat-joint bond stiffness ratio", r"\bar k_n/\bar k_s", 3.1, "-", "joint_stiffness_ratio"),
    Parameter("ball friction coefficient", r"\mu", 0.577, "-", "joint_friction"),
    Parameter("flat-joint normal strength", r"\sigma_c", 200.0, "MPa", "joint_strength_tensile", 1e-6),
    Parameter("flat-joint shear strength", "c", 113.0, "MPa", "joint_cohesion", 1e-6),
    Parameter(
        "friction angle", r"\phi", 25.0, "deg", "joint_friction_angle", 57.29577951308232, "printed as 25.0 x 10"
    ),
)
"""Table 1: parameters of the synthetic specimen."""


class Property(NamedTuple):
    """A row of Table 2."""

    words: str
    symbol: str
    unit: str
    kind: str
    """Kind of the test that gives it."""
    variable: str
    """Name in the table of variables."""
    glass: float
    """Value of soda-lime glass, in the unit named."""
    model: float
    """Value of the paper's model."""


TABLE_2 = (
    Property("elastic modulus", "E", "GPa", "dem_tension", "modulus_young", 71.0, 71.1),
    Property("Poisson's ratio", r"\nu", "-", "dem_tension", "ratio_poisson", 0.23, 0.228),
    Property("tensile strength", r"\sigma_t", "MPa", "dem_tension", "strength_ultimate", 41.0, 42.6),
    Property("compressive strength", r"\sigma_{uc}", "MPa", "dem_compression", "strength_ultimate", 330.0, 332.0),
)
"""Table 2: properties of glass and of the paper's model."""

CRACKS = {"dem_tension": 240, "dem_compression": 8070}
"""Elements broken at the end of the tests (Figs 7, 8); the number of elements of a joint is not stated."""
DISCS = {"specimen": 7406, "block": 2085}
"""Numbers of discs."""


def words(cut: Cut) -> str:
    """Depth of cut and surface in words."""
    return f"{cut[0]:g} mm {'grooved' if cut[1] else 'regular'}"


def mean(values: tuple[float, ...]) -> float:
    """Mean of the replicates."""
    return sum(values) / len(values)
