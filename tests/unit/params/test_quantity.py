"""Units, ranges and the words of their errors."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from orthocut.params.block import ConfigError
from orthocut.params.case import validate
from orthocut.params.identity import case_id
from orthocut.params.quantity import Number, Quantity, convert


def mpm(**fields):
    return validate({"kind": "mpm", **fields}, "cut.yaml")


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("0.9 mm", "m", 0.9e-3),
        ("900um", "m", 0.9e-3),
        ("9e-4 m", "m", 0.9e-3),
        ("25 MPa", "Pa", 25e6),
        ("25 N/mm^2", "Pa", 25e6),
        ("180 deg", "rad", math.pi),
        ("0.02 mm/min", "m/s", 0.02e-3 / 60),
        ("10 mm^-2", "m^-2", 1e7),
        ("30°", "rad", math.pi / 6),
        ("7.5 µm", "m", 7.5e-6),
        ("2 kJ/m**2", "J/m^2", 2e3),
        ("1 g / cm^3", "kg/m^3", 1e3),
        ("3 N m", "J", 3.0),
        ("10 /mm^2", "m^-2", 1e7),
    ],
)
def test_convert(text, unit, value):
    assert convert(text, unit) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize("text", ["", "mm", "0.9", "0.9 parsec_", "0.9 kg", "1 + 1 mm", "nan m", "0.9 mm 3", "0x1 m"])
def test_convert_refuses(text):
    with pytest.raises(ValueError, match=r"unit|quantity"):
        convert(text, "m")


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (0.9e-3, "needs a unit"),
        (1, "needs a unit"),
        ("0.9", "has no unit"),
        ("0.9 kg", "is not a quantity in m"),
        ("30 mm", "is out of range"),
        ("-1 mm", "is out of range"),
        (None, "needs a unit"),
        ([], "needs a unit"),
    ],
)
def test_error_names_file_field_value_and_range(value, words):
    with pytest.raises(ConfigError) as caught:
        mpm(cut_depth=value)
    message = str(caught.value)
    assert message.startswith(f"cut.yaml: cut_depth = {value!r}: ")
    assert words in message
    assert "(allowed: 0.02 mm to 20 mm)" in message


@pytest.mark.parametrize("value", [True, "0.3", 2.0, -0.1, float("nan"), None])
def test_numbers_are_strict(value):
    with pytest.raises(ConfigError, match=r"cut.yaml: tool.friction = .*allowed: 0 to 1.5"):
        mpm(tool={"friction": value})


def test_whole_numbers_are_whole():
    with pytest.raises(ConfigError, match=r"numerics.points_per_depth = 8.0: must be a whole number"):
        mpm(numerics={"points_per_depth": 8.0})


def test_limits_of_whole_numbers_are_exact():
    with pytest.raises(ConfigError, match=r"packing.seed = -1: is out of range \(allowed: 0 to 2147483647\)"):
        validate({"kind": "dem", "packing": {"seed": -1}})


def test_ends_of_the_range_are_allowed():
    assert mpm(cut_depth="20 mm").cut_depth == 0.02
    assert Number(0.0, 1.5).validate(1.5) == 1.5


@pytest.mark.parametrize("text", ["-1e-30 deg", "-2e-11 deg", "-1e-300 rad"])
def test_zero_is_an_exact_end(text):
    with pytest.raises(ConfigError, match=r"is out of range \(allowed: 0 deg to 45 deg\)"):
        mpm(tool={"clearance_angle": text})


@pytest.mark.parametrize("zero", ["-0 deg", "0.0 rad", "-0e5 mrad"])
def test_zero_has_no_sign(zero):
    plain = mpm(tool={"clearance_angle": "0 deg", "rake_angle": "0 deg", "friction": 0})
    assert case_id(mpm(tool={"clearance_angle": zero, "rake_angle": zero, "friction": -0.0})) == case_id(plain)


@given(st.floats(1e-5, 2e-2))
def test_shown_values_read_back_the_same(value):
    length = Quantity("m", "1 um", "1 m", "mm")
    value = float(f"{value:.15g}")
    assert length.validate(length.show(value)) == value
