"""YAML as people mean it, and no bombs."""

import os
import time

import pytest

from orthocut.params.block import ConfigError
from orthocut.params.case import load
from orthocut.params.text import MAX_BYTES, parse_yaml, read_yaml


@pytest.mark.parametrize(
    ("text", "value"),
    [("1e-3", 1e-3), ("-1.5E+2", -150.0), (".5e1", 5.0), ("9e-4 m", "9e-4 m"), ("1e400 mm", "1e400 mm")],
)
def test_numbers_and_quantities_with_an_exponent(text, value):
    assert parse_yaml(f"field: {text}", "test") == {"field": value}
    assert parse_yaml(text, "test") == value


@pytest.mark.parametrize(
    ("text", "value"),
    [
        *((text, None) for text in ("", "~", "null", "Null")),
        ("true", True),
        ("False", False),
        ("0", 0),
        ("-12", -12),
        ("1.", 1.0),
        *((text, text) for text in ("yes", "on", "n", "010", "0x10", "0o7", "1_000", "1:30", "2020-01-01", "=")),
        *((text, text) for text in (".nan", ".inf", "-.Inf", "nan", "１")),
    ],
)
def test_plain_words_and_numbers(text, value):
    found = parse_yaml(text, "test")
    assert (type(found), found) == (type(value), value)


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
    with pytest.raises(ConfigError, match=r"test, line 2: field '<<' is given twice"):
        parse_yaml("a: &a {x: 1}\nb: {<<: *a, <<: *a}\n", "test")


def test_merged_maps_may_be_merged_again_before_they_are_used():
    found = parse_yaml("x: {y: [&low {a: 1, b: 1}, &high {<<: *low, b: 2}]}\nz: {<<: *high, c: 3}\n", "test")
    assert found == {"x": {"y": [{"a": 1, "b": 1}, {"a": 1, "b": 2}]}, "z": {"a": 1, "b": 2, "c": 3}}


def chain(form):
    """Twenty lines, each of which holds the one before it ten times."""
    lines = "".join(f"a{k}: &a{k} {form.format(', '.join([f'*a{k - 1}'] * 10))}\n" for k in range(1, 20))
    return "a0: &a0 {x: 1}\n" + lines


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (chain("[{}]"), r"line 6: too many values, aliases counted in full \(allowed: up to 100000\)"),
        (chain("{{<<: [{}]}}"), "too many values, aliases counted in full"),
        ("[" * 900_000, r"line 1: too many levels of lists and maps \(allowed: up to 20\)"),
        ("{a: " * 200_000, "line 1: too many levels"),
        ("- " * 400_000, "line 1: too many levels"),
        ("\n".join(" " * k + "a:" for k in range(1300)), "line (19|20): too many levels"),
        (
            "a0: &a0 [1]\n" + "".join(f"a{k}: &a{k} [*a{k - 1}]\n" for k in range(1, 99)),
            "line (19|20): too many levels",
        ),
        ("[" + "1," * 400_000 + "]", "line 1: too many values"),
        ("a: &a [*a]", r"line 1: alias '\*a' stands for something that holds it"),
        ("&a {a: {b: {<<: *a}}}", r"line 1: alias '\*a' stands for something that holds it"),
        ("a: *b", "line 1: found undefined alias"),
        ("a: !!python/object/apply:os.system [id]", "line 1: tag '.*os.system' is not allowed"),
        ("a: !!binary aGk=", "tag .* is not allowed"),
        ("a: !mine 1", "tag '!mine' is not allowed"),
        ("a: ! 1", "is not allowed|could not"),
        ("a: !" + "x" * 900_000 + " 1", "tag '!x{59}...' is not allowed"),
        ("? [a]\n: 1\n", "line 1: a name of a field must be a word"),
        ("<<: 3\n", "line 1: expected a mapping"),
        ("a: 1\n---\nb: 1\n", "found another document"),
        ("a: " + "9" * 5000, "a number has thousands of digits"),
        ("a: 1\nb: \0", r"line 2: is not text \(character '\\x00'\)"),
        ("a: \x1b[31m", "line 1: is not text"),
    ],
    ids=range(22),
)
def test_bombs_and_tricks_are_refused_at_once(text, words):
    began = time.process_time()
    with pytest.raises(ConfigError, match=f"^test.*{words}") as caught:
        parse_yaml(text, "test")
    assert time.process_time() - began < 5.0
    assert len(str(caught.value)) < 300


def test_a_long_scalar_is_read_in_no_time():
    began = time.process_time()
    assert len(parse_yaml("x" * (MAX_BYTES - 1), "test")) == MAX_BYTES - 1
    assert time.process_time() - began < 5.0


@pytest.mark.parametrize("content", [b"\xef\xbb\xbfa: 1\n", b"a: 1\r\n", b"\xef\xbb\xbfa:\r\n  1"])
def test_files_of_other_editors(tmp_path, content):
    (tmp_path / "a.yaml").write_bytes(content)
    assert read_yaml(tmp_path / "a.yaml") == {"a": 1}


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"\x7fELF\x02\x01\x01\x00", "is not text"),
        (b"\x89HDF\r\n\x1a\n", "is not text in UTF-8"),
        ("a: é".encode("latin-1"), "is not text in UTF-8"),
        ("a: 1".encode("utf-16"), "is not text in UTF-8"),
    ],
)
def test_files_that_are_no_text(tmp_path, content, words):
    (tmp_path / "a.yaml").write_bytes(content)
    with pytest.raises(ConfigError, match=rf"a.yaml.*{words}"):
        read_yaml(tmp_path / "a.yaml")


def test_a_huge_file_is_not_read(tmp_path):
    path = tmp_path / "huge.yaml"
    with path.open("wb") as file:
        file.truncate(100_000_000_000)
    began = time.process_time()
    with pytest.raises(ConfigError, match=r"huge.yaml: is too large \(allowed: up to 1000 kB\)"):
        read_yaml(path)
    assert time.process_time() - began < 0.1


def test_things_that_are_no_files(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    for path, words in [
        (tmp_path, "is not a file"),
        (tmp_path / "pipe", "is not a file"),
        (tmp_path / "loop", "Too many levels of symbolic links"),
        (tmp_path / ("x" * 300), "File name too long"),
        (tmp_path / "a\0b", "is not the name of a file"),
        ("/dev/zero", "is not a file"),
    ]:
        with pytest.raises(ConfigError, match=rf"cannot be read: {words}") as caught:
            read_yaml(tmp_path / path)
        assert len(str(caught.value)) < 300
