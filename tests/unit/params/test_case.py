"""Cases: unknown fields, overrides, files, identity."""

import json

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from orthocut.params.block import ConfigError
from orthocut.params.case import KINDS, fields, load, override, validate
from orthocut.params.identity import canonical, case_id


@pytest.mark.parametrize("kind", KINDS)
def test_defaults_are_valid_and_round_trip(kind):
    case = load(kind)
    again = validate(json.loads(canonical(case)))
    assert again == case
    assert case_id(again) == case_id(case)


def test_identity_does_not_depend_on_units_or_order():
    one = validate({"kind": "mpm", "cut_depth": "0.9 mm", "tool": {"rake_angle": "30 deg", "friction": 0}})
    two = validate(
        {"tool": {"friction": 0.0, "rake_angle": "0.523598775598299 rad"}, "cut_depth": "900 um", "kind": "mpm"}
    )
    assert case_id(one) == case_id(two)


PAPER = {"affine": 0.0, "support": 0.0, "reach_ratio": 0.0}
CHOICES = {
    "hardening": "voce",
    "law": "triangular",
    "failure_criterion": "coupled",
    "window": "fixed",
    "bottom": "silent",
    "contact": "cells",
    "scheme": "usavg",
}
NEEDS = {
    "hardening_modulus": {"hardening": "ludwik"},
    "hardening_exponent": {"hardening": "ludwik"},
    "stress_saturation": {"hardening": "voce"},
    "strain_saturation": {"hardening": "voce"},
    "peak_ratio": {"law": "triangular"},
    "scheme": PAPER,
    "bottom": {"reach_ratio": 0.0},
    "gapped_opening": {"fraction_gapped": 0.1},
    "flip": {"scheme": "usavg", **PAPER},
    "position_order": {"scheme": "usavg", **PAPER},
}
"""Fields that only some choices use."""


def different(kind, name):
    """Return another valid value for a field of the default case, as a user writes it."""
    if (leaf := name.rsplit(".", 1)[-1]) in CHOICES:
        return CHOICES[leaf]
    case = load(kind)
    value = case
    for part in name.split("."):
        value = getattr(value, part, None)
    if name.startswith("grooves"):
        fields = {"grooves.width": "0.05 mm", "grooves.distance": "0.1 mm", "grooves.bottom_ratio": 0.5}
        return {"grooves": {}, **fields}[name]
    if isinstance(value, int):
        return value + 1 if name != "numerics.position_order" else 1
    text = case.model_dump(mode="json")
    for part in name.split("."):
        text = text[part]
    if name == "workpiece.path_ratio":
        return 14.0
    if isinstance(text, str):
        number, unit = text.split(" ", 1)
        return f"{0.97 * float(number)!r} {unit}"
    return value * 0.97 if value else 0.1


@pytest.mark.parametrize(
    ("kind", "name"),
    [
        (kind, name)
        for kind, model in KINDS.items()
        for name in fields(model)
        if name.rsplit(".", 1)[-1] != "kind"
        and name not in {"tool", "packing", "joint", "material", "interface", "workpiece", "numerics"}
    ],
)
def test_identity_depends_on_every_field(kind, name):
    needs = NEEDS.get(name.rsplit(".", 1)[-1], {})
    assert case_id(load(kind, {**needs, name: different(kind, name)})) != case_id(load(kind, needs))


@given(st.permutations(["cut_depth", "cut_speed", "tool", "kind"]))
def test_identity_does_not_depend_on_key_order(order):
    data = {"cut_depth": "1 mm", "cut_speed": "2 m/s", "tool": {"friction": 0.3}, "kind": "mpm_cutting"}
    assert case_id(validate({key: data[key] for key in order})) == case_id(validate(data))


def test_unknown_field_suggests_the_nearest():
    with pytest.raises(
        ConfigError, match=r"^cut.yaml: tool.rake_angel = '1 deg': no such field; did you mean tool.rake"
    ):
        validate({"kind": "mpm", "tool": {"rake_angel": "1 deg"}}, "cut.yaml")
    with pytest.raises(ConfigError, match=r"cut_dept: mpm_cutting has no such field; did you mean cut_depth"):
        load("mpm", {"cut_dept": "1 mm"})


def test_short_names_must_be_unique():
    assert load("mpm", {"rake_angle": "15 deg"}) == load("mpm", {"tool.rake_angle": "15 deg"})
    with pytest.raises(ConfigError, match=r"friction: several fields have this name \(joint.friction, tool.friction\)"):
        load("dem", {"friction": 0.1})


@pytest.mark.parametrize("kind", [None, "fem", 3, ["mpm"], {}])
def test_kind_must_be_known(kind):
    with pytest.raises(ConfigError, match=r"kind = .*must be one of mpm_cutting, dem_cutting"):
        validate({"kind": kind})


def test_fields_of_other_laws_may_be_given_with_their_defaults():
    assert load("mpm", {"hardening": "none", "modulus_tangent": "100 MPa"}) == load("mpm", {"hardening": "none"})


def test_override_does_not_change_its_input():
    data = {"kind": "mpm", "tool": {"friction": 0.1}}
    override(data, {"friction": 0.2, "rake_angle": "10 deg"}, "x")
    assert data == {"kind": "mpm", "tool": {"friction": 0.1}}


def test_override_inside_something_that_is_no_block():
    with pytest.raises(ConfigError, match="tool = 3: must hold fields"):
        override({"kind": "mpm", "tool": 3}, {"friction": 0.2}, "x")


def test_grooves_default_to_none_and_take_a_block():
    assert load("dem").grooves is None
    assert load("dem", {"grooves": {}}).grooves.width == 0.06e-3
    assert load("dem", {"grooves.width": "0.05 mm"}).grooves.width == 0.05e-3


def test_grooves_widen_towards_the_surface_only():
    assert load("dem", {"grooves.bottom_ratio": 0}).grooves.bottom_ratio == 0
    with pytest.raises(ConfigError, match=r"grooves.bottom_ratio = 1.5.*\(allowed: 0 to 1\)"):
        load("dem", {"grooves": {"bottom_ratio": 1.5}})


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("- 1\n- 2\n", "must hold the fields of a case"),
        ("kind: mpm\ncut_depth: 1 mm\ncut_depth: 2 mm\n", "line 3: field 'cut_depth' is given twice"),
        ("kind: [mpm\n", "line 2"),
        ("kind: mpm\n1: 2\n", "field names must be words"),
        ("kind: mpm\ntool:\n  1: 2\n", "field names must be words"),
        ("kind: mpm\ntool: sharp\n", "tool = 'sharp'"),
        ("", "must hold the fields of a case"),
    ],
)
def test_bad_files(tmp_path, content, words):
    path = tmp_path / "cut.yaml"
    path.write_text(content)
    with pytest.raises(ConfigError) as caught:
        load(path)
    assert words in str(caught.value)
    assert str(path) in str(caught.value)


def test_missing_file():
    with pytest.raises(ConfigError, match=r"none.yaml: cannot be read: No such file"):
        load("none.yaml")


def test_numbers_in_files_may_be_written_with_exponents(tmp_path):
    path = tmp_path / "cut.yaml"
    path.write_text(yaml.safe_dump({"kind": "dem"}) + "packing: {pressure_ratio: 1e-2}\n")
    assert load(path).packing.pressure_ratio == 0.01


@pytest.mark.parametrize(
    ("kind", "values", "words"),
    [
        ("mpm", {"travel_ratio": 15.0}, "travel_ratio = 15 ends less than 3 depths"),
        ("mpm", {"window_ratio": 11.0}, "window_ratio = 11 leaves no travel"),
        ("mpm", {"flip": 0.5}, r"flip = 0.5 is of no use with scheme = consistent \(allowed: 0, or scheme = usavg\)"),
        ("mpm", {"position_order": 1}, r"position_order = 1 is of no use.*allowed: 2, or scheme = usavg"),
        ("mpm", {"scheme": "usavg"}, r"affine = 1 is of no use with scheme = usavg \(allowed: 0\)"),
        (
            "mpm",
            {"scheme": "usavg"},
            r"affine = 1 .*; support = 0.05 .*; reach_ratio = 8 is of no use with scheme = usavg \(allowed: 0\)",
        ),
        ("mpm", {"scheme": "usavg", "affine": 0.0}, r"support = 0.05 is of no use with scheme = usavg"),
        ("mpm", {"scheme": "usavg", "affine": 0.0, "support": 0.0}, r"reach_ratio = 8 is of no use with scheme"),
        ("mpm", {"reach_ratio": 3.0}, r"reach_ratio = 3 holds material .*allowed: 0, or at least 4"),
        ("mpm", {"bottom": "silent"}, r"reach_ratio = 8 would hold a base on dashpots \(allowed: 0, or"),
        ("mpm", {"scheme": "usavg", "position_order": 3}, "position_order"),
        ("mpm", {"contact": "near"}, "contact"),
        ("mpm", {"rake_angle": "70 deg", "clearance_angle": "20 deg"}, "leave a wedge of"),
        ("mpm", {"modulus_tangent": "950 MPa"}, "modulus_tangent = 950 MPa is too large"),
        (
            "mpm",
            {"hardening": "voce", "modulus_tangent": "0 MPa"},
            r"modulus_tangent is of no use with hardening = voce",
        ),
        ("mpm", {"hardening_exponent": 0.5}, r"hardening = linear \(allowed: leave it out, or hardening = ludwik\)"),
        ("mpm", {"hardening": "none", "stress_yield": "1 MPa"}, r"or hardening = linear, ludwik, voce\)"),
        ("mpm", {"hardening": "voce", "stress_yield": "50 MPa"}, "stress_saturation = 50 MPa is too small"),
        (
            "mpm",
            {"peak_ratio": 0.2},
            r"peak_ratio is of no use with law = cubic \(allowed: leave it out, or law = tri",
        ),
        ("mpm", {"hardening": "swift"}, "hardening = 'swift'"),
        ("mpm", {"modulus_bulk": "1 TPa", "modulus_shear": "1 GPa"}, "Poisson"),
        ("dem", {"cut_depth": "0.6 mm"}, "more than half of the block"),
    ],
)
def test_fields_must_fit_together(kind, values, words):
    with pytest.raises(ConfigError, match=words):
        load(kind, values)
