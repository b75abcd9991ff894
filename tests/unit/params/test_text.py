"""YAML as people mean it."""

import pytest

from orthocut.params.block import ConfigError
from orthocut.params.case import load
from orthocut.params.text import parse_yaml


@pytest.mark.parametrize(
    ("text", "value"),
    [("1e-3", 1e-3), ("-1.5E+2", -150.0), (".5e1", 5.0), ("9e-4 m", "9e-4 m"), ("1e400 mm", "1e400 mm")],
)
def test_numbers_and_quantities_with_an_exponent(text, value):
    assert parse_yaml(f"field: {text}", "test") == {"field": value}
    assert parse_yaml(text, "test") == value


def test_quantity_with_an_exponent_in_a_file(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text("kind: mpm\ncut_depth: 9e-4 m\ntool: {friction: 1e-3}\n")
    case = load(path)
    assert (case.cut_depth, case.tool.friction) == (9e-4, 1e-3)
    path.write_text("kind: mpm\ncut_depth: 1e400 mm\n")
    with pytest.raises(ConfigError, match=r"cut_depth = '1e400 mm': is out of range"):
        load(path)


def test_a_field_given_twice_is_a_mistake():
    with pytest.raises(ConfigError, match=r"test, line 2: field 'a' is given twice"):
        parse_yaml("a: 1\na: 2\n", "test")
