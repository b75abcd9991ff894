"""Series along one field, and rubbing forces on straight lines."""

import math

import numpy as np
import pytest
from synthetic import failed, mpm_run

from orthocut.figures.rubbing import FIT_ABOVE, rubbing_at, rubbing_between, rubbing_line
from orthocut.figures.sweep import dimensionless_depth
from orthocut.figures.varied import series_along, value_of, words
from orthocut.io.collect import collect


def cut(**values):
    return mpm_run(snapshots=0, **values)


def test_a_series_differs_in_one_field_alone():
    runs = [cut(points_per_depth=n, affine=a, cut_depth=h) for n in (6, 4) for a in (0, 0.9) for h in ("1 mm", "2 mm")]
    runs += [cut(points_per_depth=5, courant=0.2), failed(cut(points_per_depth=9, affine=0, cut_depth="1 mm"))]
    series = series_along(collect(runs), "points_per_depth", "force_cutting_mean")
    assert len(series) == 4
    for _, members in series:
        assert [value_of(run, "points_per_depth") for run in members] == [4, 6]
    names = [name for name, _ in series]
    assert "$h$ = 1 mm, PIC" in names
    assert "$h$ = 2 mm, 0.9 of the gradient" in names


def test_short_series_are_left_out_and_a_lone_one_needs_no_name():
    runs = [cut(points_per_depth=n) for n in (4, 6)]
    assert series_along(collect(runs), "points_per_depth", least=3) == []
    assert series_along(collect(runs), "points_per_depth")[0][0] == "runs"


@pytest.mark.parametrize(
    ("field", "value", "text"),
    [
        ("rake_angle", math.radians(30), r"$\alpha$ = 30°"),
        ("modulus_tangent", 25e6, "$E_T$ = 25 MPa"),
        ("courant", 0.5, "$C$ = 0.5"),
        ("law", "triangular", "triangular"),
        ("unheard_of", 3, "unheard of 3"),
    ],
)
def test_words_for_a_field(field, value, text):
    assert words(field, value) == text


def rubbed(depth, force, touching=0):
    run = cut(cut_depth=f"{depth} mm", touching=touching)
    run["force_rubbing_mean"] = force
    return run


def test_rubbing_line_takes_deep_bending_runs():
    runs = [rubbed(0.5, 900.0, 1), rubbed(1.5, 5000.0), rubbed(3, 2000.0), rubbed(5, 3000.0), rubbed(7, 4000.0)]
    assert dimensionless_depth(runs[1]) < FIT_ABOVE < dimensionless_depth(runs[2])
    np.testing.assert_allclose(rubbing_line(runs, FIT_ABOVE), [500e3, 500.0])
    np.testing.assert_allclose(rubbing_at(runs, np.array([4e-3, -2e-3]), FIT_ABOVE), [2500.0, 0.0])


def test_rubbing_without_enough_runs_is_zero():
    runs = [rubbed(0.5, 900.0, 1), rubbed(3, 2000.0)]
    assert rubbing_line(runs) is None
    assert rubbing_at(runs, np.array([1e-3])) == [0.0]
    assert rubbing_between([runs[1]], np.array([1e-3])) == [0.0]


def test_rubbing_of_touching_runs_is_interpolated():
    runs = [rubbed(0.5, 900.0, 1), rubbed(1.5, 1900.0, 1), rubbed(3, 7000.0)]
    np.testing.assert_allclose(rubbing_between(runs, np.array([0.1e-3, 1e-3, 9e-3])), [900.0, 1400.0, 1900.0])
