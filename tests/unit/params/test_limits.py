"""Sizes that no machine runs and no packing gives."""

import pytest

from orthocut.params.block import ConfigError
from orthocut.params.case import KINDS, load
from orthocut.params.limits import MAX_PARTICLES, MAX_WORK
from orthocut.params.size import particles, steps
from orthocut.run import SMALLEST


@pytest.mark.parametrize("kind", KINDS)
def test_the_smallest_and_the_default_case_are_within_limits(kind):
    for case in (load(kind), load(kind, SMALLEST[kind])):
        assert particles(case) < MAX_PARTICLES
        assert particles(case) * steps(case) < MAX_WORK


@pytest.mark.parametrize(
    ("kind", "values", "words"),
    [
        ("dem", {"cut_depth": "19 um"}, r"cut_depth = 0.019 mm is less than a grain \(allowed: 0.02 mm or more\)"),
        ("dem", {"travel": "1 um", "cut_speed": "20 m/s"}, r"travel = 0.001 mm at cut_speed = 20 m/s takes 38 steps"),
        ("dem", {"grooves": {"width": "0.9 mm"}}, r"leave no room for a groove \(allowed: up to the .* block, 1 mm\)"),
        ("dem", {"grooves": {"distance": "5 mm"}}, "grooves.width [+] grooves.distance = 5.06 mm leave no room"),
        ("dem", {"radius_min": "25 um", "grooves": {"width": "12 um"}}, "grooves.width = 0.012 mm is less than half"),
        ("dem_tension", {"packing.width": "79 um"}, r"width = 0.079 mm holds too few discs .*\(allowed: 0.08 mm or"),
        ("dem_compression", {"radius_min": "10 mm"}, "packing.height = 2 mm holds too few discs side by side"),
        ("dem", {"radius_min": "0.1 um"}, r"packing.radius_min give 2.*e[+]07 discs \(allowed: up to 5e[+]06\)"),
        ("dem", {"stiffness_ratio": 1.0}, r"factor = 0.5 is unstable with .* damping = 0.7 \(.*up to 0.34\)"),
        ("dem_tension", {"time_step_factor": 0.6}, r"step_factor = 0.6 is unstable with .* \(allowed: up to 0.59\)"),
        ("mpm", {"points_per_depth": 60, "length_ratio": 200, "base_ratio": 20}, r"give 1.51e[+]07 material points"),
        ("dem_compression", {"grip_speed": "0.02 mm/min", "strain_max": 0.2}, r"discs for 6.03e[+]11 steps = "),
        ("dem_tension", {"radius_min": "20 um", "packing.height": "0.5 mm"},
         r"grip_ratio = 0.05 are grips of 0.025 mm, which may hold no disc \(allowed: 0.054 or more"),
        ("dem_toughness", {"radius_min": "20 um", "grip_ratio": 0.01}, r"grips of .* \(allowed: .* largest radius\)"),
        ("mpm", {"notch_ratio": 16}, r"notch_ratio = 16 leaves nothing to cut \(.*less than length_ratio = 16\)"),
        ("mpm", {"path_ratio": 16}, r"path_ratio = 16 is no shorter .*\(allowed: 0 for all of it, or less .* 16\)"),
        ("mpm", {"points_per_depth": 60, "strength": "400 MPa", "toughness": "1 J/m^2", "cut_speed": "0.05 m/s",
                 "length_ratio": 200, "travel_ratio": 180, "courant": 0.01}, r"material points for .* steps"),
    ],
)  # fmt: skip
def test_sizes_that_are_refused(kind, values, words):
    with pytest.raises(ConfigError, match=words):
        load(kind, values)


@pytest.mark.parametrize(
    ("kind", "values"),
    [
        ("dem", {"cut_depth": "20 um"}),
        ("dem", {"grooves": {"width": "0.8 mm", "distance": "0.2 mm"}}),
        ("dem_tension", {"packing.width": "80 um"}),
        ("dem_tension", {"radius_min": "15 um", "packing.height": "0.4 mm"}),
        ("mpm", {"notch_ratio": 12, "path_ratio": 15.9}),
        ("dem_tension", {"grip_speed": "0.02 mm/min", "strain_max": 1e-3}),
    ],
)
def test_sizes_at_the_limit_are_taken(kind, values):
    load(kind, values)


def test_every_fault_is_told():
    with pytest.raises(ConfigError) as caught:
        load("dem", {"cut_depth": "10 um", "travel": "1 um", "cut_speed": "20 m/s", "grooves": {"width": "5 mm"}})
    assert [line.split(" = ")[0] for line in str(caught.value).splitlines()] == [
        "dem --set: cut_depth",
        "dem --set: travel",
        "dem --set: grooves.width + grooves.distance",
    ]


@pytest.mark.parametrize("rake", range(40, 71))
def test_a_wedge_of_five_degrees_is_enough(rake):
    load("mpm", {"rake_angle": f"{rake} deg", "clearance_angle": f"{85 - rake} deg"})
    if rake > 41:
        with pytest.raises(ConfigError, match=r"leave a wedge of 4 deg \(allowed: 5 deg or more\)"):
            load("mpm", {"rake_angle": f"{rake} deg", "clearance_angle": f"{86 - rake} deg"})
