"""Studies that are right expand, read back the same, and keep their identities however they are written."""

import json
import math

from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import studies, written

from orthocut.params.case import validate
from orthocut.params.identity import canonical, case_id, result_key
from orthocut.params.study import load_study
from orthocut.plan import load_plan


def expanded(folder, text):
    path = folder / "study.yaml"
    path.write_bytes(text.encode())
    return load_study(path).cases(str(path))


def count(sweep):
    axes = sweep.get("axes", {})
    points = math.prod(map(len, axes.get("product", {}).values()))
    points *= max(map(len, axes.get("zip", {}).values()), default=1) * max(len(axes.get("list", [])), 1)
    return points * sweep.get("replicates", 1)


@given(st.data())
@settings(max_examples=60, deadline=2000)
def test_right_studies_expand_to_as_many_cases_as_they_say(tmp_path_factory, data):
    study = data.draw(studies())
    cases = expanded(tmp_path_factory.getbasetemp(), data.draw(written(study)))
    assert {name: len(members) for name, members in cases.items()} == {
        name: count(sweep) for name, sweep in study["sweeps"].items()
    }


@given(st.data())
@settings(max_examples=60, deadline=2000)
def test_identities_do_not_depend_on_units_order_comments_and_style(tmp_path_factory, data):
    study = data.draw(studies())
    one, two = (expanded(tmp_path_factory.getbasetemp(), data.draw(written(study))) for _ in range(2))
    assert {name: set(members) for name, members in one.items()} == {
        name: set(members) for name, members in two.items()
    }


@given(st.data())
@settings(max_examples=60, deadline=2000)
def test_cases_read_back_from_their_canonical_json(tmp_path_factory, data):
    cases = expanded(tmp_path_factory.getbasetemp(), data.draw(written(data.draw(studies()))))
    for members in cases.values():
        for key, case in members.items():
            again = validate(json.loads(canonical(case)))
            assert again == case
            assert canonical(again) == canonical(case)
            assert case_id(again) == key
            assert result_key(again).startswith(f"{key}-")


@given(st.data())
@settings(max_examples=30, deadline=4000)
def test_right_studies_can_be_planned(tmp_path_factory, data):
    path = tmp_path_factory.getbasetemp() / "planned.yaml"
    path.write_bytes(data.draw(written(data.draw(studies()))).encode())
    plan = load_plan(path)
    assert set(plan.labels) == set(plan.cases)
    assert all(label.isprintable() for label in plan.labels.values())
