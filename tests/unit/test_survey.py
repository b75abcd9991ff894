"""What is missing, how long it takes, and how it is shared out."""

import pytest
from synthetic import mpm_run

from orthocut.cost import estimate_seconds
from orthocut.io.datasets import failed
from orthocut.io.store import Store
from orthocut.params.identity import result_key
from orthocut.plan import load_plan
from orthocut.survey import read_batch, survey

STUDY = """
title: t
sweeps:
  cuts: {base: {kind: mpm, numerics: {points_per_depth: 4}}, axes: {product: {cut_depth: [0.5 mm, 1 mm, 2 mm]}}}
  glass: {base: {kind: dem}, replicates: 4}
figures: {nairn2015_fig08: [cuts], yang2018_fig11: [glass]}
"""


@pytest.fixture
def plan(tmp_path):
    path = tmp_path / "s.yaml"
    path.write_text(STUDY)
    return load_plan(path)


@pytest.fixture
def store(tmp_path):
    return Store(tmp_path / "store")


def test_snapshots_are_wanted_by_figures_that_draw_them(plan):
    wanted = {case_id.split("-")[0]: count for case_id, count in plan.snapshots.items()}
    assert wanted == {"mpm": 0, "dem": 6}


def test_states(plan, store, monkeypatch):
    cuts = [case for case in plan.cases.values() if case.kind == "mpm_cutting"]
    store.put(cuts[0], mpm_run(cut_depth="0.5 mm"), 0)
    store.put(cuts[1], failed(cuts[1], "it blew up", 0.1), 0)
    monkeypatch.setattr("orthocut.params.identity.digest_numbers", lambda kind: "0" * 16)
    store.put(cuts[2], mpm_run(cut_depth="2 mm"), 0)
    monkeypatch.undo()
    found = survey(plan, store)
    assert found.counts == {"done": 1, "failed": 1, "stale": 1, "missing": 4}
    assert found.entries[next(iter(found.entries))].key == result_key(cuts[0])
    assert len(found.missing) == 5
    assert found.seconds_left == pytest.approx(sum(found.seconds(case) for case in found.missing))


def test_snapshots_that_a_new_figure_wants_are_missing(plan, store):
    cut = next(case for case in plan.cases.values() if case.kind == "mpm_cutting")
    store.put(cut, mpm_run(cut_depth="0.5 mm"), 0)
    assert survey(plan, store).counts["done"] == 1
    plan.snapshots.update(dict.fromkeys(plan.cases, 6))
    assert survey(plan, store).counts["done"] == 0


def test_predictions_follow_what_was_measured(plan, store):
    cuts = [case for case in plan.cases.values() if case.kind == "mpm_cutting"]
    for cut, depth in zip(cuts[:2], (0.5, 1), strict=True):
        run = mpm_run(cut_depth=f"{depth} mm", wall_time=3 * estimate_seconds(cut))
        store.put(cut, run, 0)
    found = survey(plan, store)
    assert found.factors == {"mpm_cutting": pytest.approx(3)}
    last = next(case_id for case_id, case in plan.cases.items() if case == cuts[2])
    assert found.seconds(last) == pytest.approx(3 * estimate_seconds(cuts[2]))


def test_every_missing_case_is_in_one_batch_of_its_method_longest_first(plan, store):
    found = survey(plan, store)
    for minutes in (1e-6, 0.5, 100):
        batches = found.batches(2, minutes)
        assert sorted(job.case_id for batch in batches for job in batch.jobs) == sorted(plan.cases)
        for batch in batches:
            assert {job.case_id.split("-")[0] for job in batch.jobs} == {batch.method}
            assert [job.seconds for job in batch.jobs] == sorted((job.seconds for job in batch.jobs), reverse=True)
    assert len(found.batches(2, 1e-6)) == len(plan.cases)
    assert len(found.batches(2, 100)) == 2


def test_a_batch_is_its_file(plan, store, tmp_path):
    for batch in survey(plan, store).batches(2, 100):
        batch.write(tmp_path)
        assert read_batch(tmp_path / f"{batch.name}.json") == batch
        assert batch.memory_mb >= 500
