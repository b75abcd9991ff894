"""Whatever stands in a study or a case: it is taken, or refused with one clear line a fault; nothing else happens."""

import time

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import FIELDS, spell, studies

from orthocut.params.block import MAX_LINES, ConfigError
from orthocut.params.case import KINDS, fields, load, override, validate
from orthocut.params.study import load_study
from orthocut.params.text import parse_yaml
from orthocut.plan import load_plan

JUNK = [
    None, True, False, -1, 0, 10**9, 10**400, 1.5, -0.0, float("nan"), float("inf"), -float("inf"),
    "", "x", "nan mm", "inf mm", "1e999 mm", "-1 mm", "0 m", "1", "1 kg", "1 mm mm", "1 mm^99999", "1 cm^-99999",
    "yes", "0x10", "1:30", "2020-01-01", "1_000 mm", "１ mm", "../../etc", "a\0b", "a\nb", "\x1b[31m", "é" * 200, [],
    ["1 mm"], {}, {"x": 1}, {"x": {"x": {"x": {}}}}, [[[]]],
]  # fmt: skip
SCALARS = st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=30)
ANYTHING = st.sampled_from(JUNK) | st.recursive(
    SCALARS,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=10), inner, max_size=4),
    max_leaves=8,
)
"""Values that YAML can hold, most of them wrong anywhere."""


def check(error, source):
    """Every line names the source, and none is long, broken or full of control characters."""
    lines = str(error).splitlines()
    assert 0 < len(lines) <= MAX_LINES + 1
    assert all(line.startswith(f"{source}") and len(line) < len(source) + 1500 for line in lines)
    assert all(line.isprintable() for line in lines)


def attempt(path, content):
    """Plan a study; return whether it was taken."""
    path.write_bytes(content)
    began = time.process_time()
    try:
        load_plan(path)
    except ConfigError as error:
        check(error, str(path))
        return False
    finally:
        assert time.process_time() - began < 1.0
    return True


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return tmp_path_factory.mktemp("bad") / "study.yaml"


@given(st.data())
@settings(max_examples=150, deadline=None)
def test_a_study_in_which_one_thing_is_something_else(path, data):
    study = spell(data.draw, data.draw(studies()))
    spot, key = study, data.draw(st.sampled_from(list(study)))
    while isinstance(spot[key], (dict, list)) and spot[key] and data.draw(st.integers(0, 3)):
        spot = spot[key]
        key = data.draw(st.sampled_from(list(spot) if isinstance(spot, dict) else range(len(spot))))
    spot[key] = data.draw(ANYTHING)
    attempt(path, yaml.safe_dump(study, allow_unicode=True).encode())


@given(st.data())
@settings(max_examples=80, deadline=None)
def test_a_field_too_many_at_any_level_is_refused(path, data):
    study = spell(data.draw, data.draw(studies()))
    sweep = next(iter(study["sweeps"].values()))
    axes = sweep.setdefault("axes", {})
    blocks = [block for block in sweep["base"].values() if isinstance(block, dict)]
    places = [study, sweep, sweep["base"], axes, axes.setdefault("product", {}), *blocks, *axes.get("list", [])]
    name = data.draw(st.text(min_size=1, max_size=12).map(lambda text: f"no_{text}"))
    data.draw(st.sampled_from(places))[name] = data.draw(st.sampled_from(JUNK))
    assert not attempt(path, yaml.safe_dump(study, allow_unicode=True).encode())


@given(st.data())
@settings(max_examples=80, deadline=None)
def test_names_that_are_no_names_are_refused(path, data):
    study = spell(data.draw, data.draw(studies()))
    bad = data.draw(
        st.sampled_from(
            ["..", "../x", "/etc", "a/b", "a\0b", "a\nb", "-a", "x" * 65, "é", "", " a", "a ", "{x}", "1", 1]
        )
    )
    table = data.draw(st.sampled_from(["sweeps", "figures"]))
    study[table] = {bad: next(iter(study[table].values()))}
    assert not attempt(path, yaml.safe_dump(study, allow_unicode=True).encode())


@given(st.binary(max_size=300) | st.text(max_size=300).map(lambda text: text.encode("utf-8", "replace")))
@settings(max_examples=150, deadline=None)
def test_any_bytes_are_no_study(path, content):
    assert not attempt(path, content)


@given(st.text(alphabet="abkm:-?[]{}&*!|>'\"%@`#, \t\n<1.~\\", max_size=60))
@settings(max_examples=400, deadline=None)
def test_any_scraps_of_yaml_are_read_or_refused(text):
    try:
        parse_yaml(text, "scraps")
    except ConfigError as error:
        check(error, "scraps")


@given(st.data())
@settings(max_examples=100, deadline=None)
def test_a_study_with_some_characters_changed(path, data):
    study = yaml.safe_dump(spell(data.draw, data.draw(studies())), allow_unicode=True)
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(study)))
        study = study[:at] + data.draw(st.sampled_from([*"&*!|>{}[]:-#'\"\\\n\t9", ""])) + study[at + 1 :]
    attempt(path, study.encode())


@given(st.data())
@settings(max_examples=300, deadline=None)
def test_any_value_of_any_field_of_a_case_is_taken_or_refused(data):
    kind = data.draw(st.sampled_from(sorted(KINDS)))
    name = data.draw(st.sampled_from(sorted(fields(KINDS[kind]))))
    value = data.draw(ANYTHING)
    try:
        validate(override({"kind": kind}, {name: value}, "case"), "case")
    except ConfigError as error:
        check(error, "case")


@given(
    st.sampled_from([(kind, name) for kind, made in FIELDS.items() for name, field in made.items() if field.unit]),
    st.one_of(
        st.floats(max_value=-1e-12).map(lambda number: f"{number!r} {{unit}}"),
        st.floats(width=16).map(str),
        st.floats(),
        st.integers(),
        st.sampled_from(["nan {unit}", "inf {unit}", "-inf {unit}", ".nan", ".inf", "-.Inf", "NaN", "1e999 {unit}"]),
        st.sampled_from(["1 kg", "1 mm^2", "1 K", "1 s", "1 parsec", "1 {unit} 1", "{unit}", "1 {unit}; rm", "1 %"]),
    ),
)
@settings(max_examples=200, deadline=None)
def test_quantities_without_unit_or_sign_or_end_are_refused(field, value):
    kind, name = field
    unit = "furlong" if name == "tool.rake_angle" and str(value).startswith("-") else FIELDS[kind][name].unit
    text = value.replace("{unit}", unit) if isinstance(value, str) else value
    with pytest.raises(ConfigError, match=r"allowed: ") as caught:
        load(kind, {name: text})
    assert name in str(caught.value)


@given(st.integers(50, 2000), st.integers(1, 2000), st.integers(1, 1000))
@settings(max_examples=30, deadline=None)
def test_absurd_numbers_of_cases_are_counted_and_not_made(path, first, second, replicates):
    path.write_text(
        f"title: t\nfigures: {{nairn2015_fig07: []}}\nsweeps:\n  many:\n    base: {{kind: dem}}\n"
        f"    replicates: {replicates}\n    axes: {{product: {{cut_depth: &a [{'1, ' * first}], "
        f"travel: *a, cut_speed: *a, width: [{'1, ' * second}]}}}}\n"
    )
    began = time.process_time()
    with pytest.raises(ConfigError, match=rf"has {first**3 * second * replicates} cases") as caught:
        load_study(path)
    assert time.process_time() - began < 1.0
    check(caught.value, str(path))
