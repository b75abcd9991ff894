"""A run that is interrupted anywhere and goes on from its checkpoint has the same bits as one that was not."""

import errno
import itertools
import json
import os
import random
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

from orthocut.io.checkpoint import Checkpoint
from orthocut.measure.guard import Diverged, check_finite
from orthocut.params.case import KINDS, load
from orthocut.params.identity import canonical
from orthocut.run import SMALLEST, run_case

TESTS = {"strain_max": 3e-3, "grip_speed": "0.1 m/s"}
CASES = {kind: {**SMALLEST[kind], **(TESTS if "cutting" not in kind else {})} for kind in KINDS}
CASES["dem_toughness"] |= {"strength_tensile": "1 GPa", "cohesion": "1 GPa"}
"""Small cases, of specimens with more samples than a dataset holds."""


class Killed(Exception):
    """Stands for the death of a process."""


@pytest.fixture(scope="module")
def whole():
    """Return a function that gives the undisturbed run of the smallest case of a kind."""
    runs = {}

    def run(kind):
        if kind not in runs:
            runs[kind] = run_case(load(kind, CASES[kind]), snapshots=4)
        return runs[kind]

    return run


def interrupted(case, path, every=0.0, after=1):
    """Run with a checkpoint until some reports of progress after the start."""
    counter = itertools.count(1)

    def progress(_):
        if next(counter) > after:
            raise Killed

    return run_case(case, progress, Checkpoint(path, "key", every), snapshots=4)


@pytest.mark.parametrize("kind", KINDS)
def test_bits_are_the_same_wherever_it_is_interrupted(kind, whole, tmp_path):
    case, path = load(kind, CASES[kind]), tmp_path / "c.npz"
    chance = random.Random(1)
    kills, found = 0, None
    while found is None:
        try:
            found = interrupted(case, path, after=chance.choice([1, 2, 3, 30, 90]))
        except Killed:
            assert path.exists()
            kills += 1
    assert kills > 2
    assert found.drop_attrs().identical(whole(kind).drop_attrs())


@pytest.mark.parametrize("kind", KINDS)
def test_snapshots_change_no_number(kind, whole):
    bare = run_case(load(kind, CASES[kind]), snapshots=0)
    assert not {dim for dim in bare.dims if dim != "sample"}
    shared = whole(kind)[list(bare.variables)]
    assert bare.drop_attrs().identical(shared.drop_attrs())


@pytest.mark.parametrize("kind", ["mpm_cutting", "dem_cutting"])
@pytest.mark.parametrize("count", [2, 5, 12])
def test_as_many_snapshots_as_wanted_the_last_at_the_end(kind, count):
    run = run_case(load(kind, CASES[kind]), snapshots=count)
    assert run.sizes["snapshot"] == count
    assert float(run["time_snapshot"][-1]) == float(run["time"][-1])
    assert np.diff(run["time_snapshot"]).std() < 0.02 * float(run["time"][-1])


RUN = """
import sys
from orthocut.io.checkpoint import Checkpoint
from orthocut.io.netcdf import write
from orthocut.params.case import validate
from orthocut.run import run_case
import json, pathlib
case = validate(json.loads(pathlib.Path("case.json").read_text()))
write(run_case(case, checkpoint=Checkpoint("c.npz", "key", every=0.02), snapshots=4), "out.nc")
"""


@pytest.mark.parametrize("kind", ["mpm_cutting", "dem_cutting"])
def test_sigkill_at_any_moment(kind, tmp_path):
    values = {**SMALLEST[kind], **({"points_per_depth": 12} if kind == "mpm_cutting" else {"travel": "20 um"})}
    case = load(kind, values)
    (tmp_path / "case.json").write_text(canonical(case))
    chance = random.Random(2)
    kills = 0
    for _ in range(60):
        process = subprocess.Popen([sys.executable, "-c", RUN], cwd=tmp_path)
        if kills < 3:
            end = time.monotonic() + 60
            before = (tmp_path / "c.npz").stat().st_mtime_ns if (tmp_path / "c.npz").exists() else 0
            while process.poll() is None and time.monotonic() < end:
                if (tmp_path / "c.npz").exists() and (tmp_path / "c.npz").stat().st_mtime_ns != before:
                    break
                time.sleep(0.002)
            time.sleep(chance.uniform(0, 0.1))
            process.send_signal(signal.SIGKILL)
            kills += process.wait() == -signal.SIGKILL
        elif process.wait() == 0:
            break
    assert kills == 3
    assert (tmp_path / "out.nc").exists()
    (tmp_path / "c.npz").unlink()
    os.replace(tmp_path / "out.nc", tmp_path / "resumed.nc")
    subprocess.run([sys.executable, "-c", RUN], cwd=tmp_path, check=True)
    from orthocut.io.netcdf import read

    assert read(tmp_path / "resumed.nc").drop_attrs().identical(read(tmp_path / "out.nc").drop_attrs())


def test_a_value_that_is_no_number_fails_the_case(whole):
    run = whole("mpm_cutting").copy(deep=True)
    check_finite(run)
    run["force_cutting"][17] = np.nan
    with pytest.raises(Diverged, match=r"force_cutting is nan at time .* s, sample 17 of 500"):
        check_finite(run)
    run["time"] = run["time"] * np.nan
    with pytest.raises(Diverged, match="no samples"):
        check_finite(run)


def test_padding_is_no_failure(whole):
    check_finite(whole("dem_tension"))
    assert np.isnan(whole("dem_tension")["time"]).any()


def test_a_broken_checkpoint_is_set_aside(tmp_path):
    path = tmp_path / "c.npz"
    for content in (b"", b"nonsense", b"PK\x03\x04"):
        path.write_bytes(content)
        with pytest.warns(UserWarning, match="not used"):
            assert Checkpoint(path, "key").restore() is None
        assert not path.exists()


def test_a_truncated_or_altered_checkpoint_is_set_aside(tmp_path):
    path = tmp_path / "c.npz"
    Checkpoint(path, "key", every=0).offer(lambda: {"a": np.arange(1000.0)})
    content = path.read_bytes()
    for damaged in (content[:-200], content[:3000] + b"x" + content[3001:]):
        path.write_bytes(damaged)
        with pytest.warns(UserWarning, match="not used"):
            assert Checkpoint(path, "key").restore() is None


def test_a_checkpoint_of_another_result_is_not_used(tmp_path):
    path = tmp_path / "c.npz"
    Checkpoint(path, "other", every=0).offer(lambda: {"a": np.zeros(3)})
    with pytest.warns(UserWarning, match="belongs to another result"):
        assert Checkpoint(path, "key").restore() is None


def test_a_checkpoint_comes_by_a_clock_that_never_jumps(tmp_path):
    now = [0.0]
    checkpoint = Checkpoint(tmp_path / "c.npz", "key", every=60, clock=lambda: now[0])
    saved = []
    for now[0] in range(0, 200, 10):
        if checkpoint.offer(lambda: {"a": np.zeros(1)}):
            saved.append(now[0])
    assert saved == [60, 120, 180]
    again = Checkpoint(tmp_path / "c.npz", "key", clock=lambda: now[0])
    again.restore()
    assert again.seconds == 180


def test_a_full_disk_does_not_stop_a_run(tmp_path, monkeypatch):
    def full(*_, **__):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(np, "savez", full)
    checkpoint = Checkpoint(tmp_path / "c.npz", "key", every=0)
    with pytest.warns(UserWarning, match="no checkpoint: No space left on device; the run goes on"):
        assert not checkpoint.offer(lambda: {"a": np.zeros(1)})
    assert not checkpoint.offer(lambda: {"a": np.zeros(1)})
    assert json.dumps(os.listdir(tmp_path)) == "[]"
