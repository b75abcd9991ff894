"""``orthocut run``, interrupted and started again."""

import functools

import pytest
import xarray as xr
from typer.testing import CliRunner

from orthocut import run
from orthocut.cli import app
from orthocut.io import checkpoint
from orthocut.measure.guard import Diverged

SHORT = ("points_per_depth=4", "length_ratio=8", "travel_ratio=4", "window_ratio=2")
COMMAND = ["run", "mpm", *(word for setting in SHORT for word in ("--set", setting)), "--output"]


@pytest.fixture
def stop(monkeypatch):
    """Return a function: from now on runs save their state now and then, and end with an error half way, or do not."""
    whole, kind = run.run_case, checkpoint.Checkpoint

    def stop_with(error, every=0.0):
        def broken(case, progress, *rest):
            def until_half(fraction):
                progress(fraction)
                if error and fraction > 0.5:
                    raise error

            return whole(case, until_half, *rest)

        monkeypatch.setattr(run, "run_case", broken)
        monkeypatch.setattr(checkpoint, "Checkpoint", functools.partial(kind, every=every))

    return stop_with


def invoke(path):
    return CliRunner().invoke(app, [*COMMAND, str(path)])


def test_an_interrupted_run_goes_on_to_the_same_bits(tmp_path, stop):
    assert invoke(tmp_path / "calm.nc").exit_code == 0
    stop(KeyboardInterrupt())
    first = invoke(tmp_path / "cut.nc")
    assert first.exit_code == 130
    assert "the same command goes on from" in first.output
    stop(None)
    second = invoke(tmp_path / "cut.nc")
    assert second.exit_code == 0, second.output
    assert "going on after" in second.output
    with xr.open_dataset(tmp_path / "calm.nc") as calm, xr.open_dataset(tmp_path / "cut.nc") as cut:
        assert cut.drop_attrs().identical(calm.drop_attrs())
    assert sorted(path.name for path in tmp_path.iterdir()) == ["calm.nc", "cut.nc"]


def test_what_was_not_saved_is_not_promised(tmp_path, stop):
    stop(KeyboardInterrupt(), every=60.0)
    first = invoke(tmp_path / "cut.nc")
    assert first.exit_code == 130
    assert "interrupted; no file is half-written" in first.output
    assert "goes on" not in first.output
    assert list(tmp_path.iterdir()) == []


def test_a_state_of_another_case_is_not_called_a_start(tmp_path, stop):
    (tmp_path / ".cut.nc.checkpoint.npz").write_bytes(b"not a checkpoint")
    with pytest.warns(UserWarning, match="not used"):
        done = invoke(tmp_path / "cut.nc")
    assert done.exit_code == 0
    assert "going on after" not in done.output


def test_a_failed_run_leaves_nothing(tmp_path, stop):
    stop(Diverged("the chip sinks"))
    failed = invoke(tmp_path / "cut.nc")
    assert failed.exit_code == 1
    assert "the chip sinks" in failed.output
    assert list(tmp_path.iterdir()) == []
