"""Packings on disk: the same bits as fresh ones, made once, checked, safe when two processes make one."""

import subprocess
import sys

import numpy as np
import pytest

from orthocut.dem.packing import PackedDiscs, pack
from orthocut.experiments import dem_compression, dem_tension, packing_shelf
from orthocut.experiments.packing_shelf import FOLDER, packed_discs, shelf_path
from orthocut.io.checkpoint import Checkpoint
from orthocut.params import identity
from orthocut.params.case import load

SMALL = {"packing.width": "0.2 mm", "packing.height": "0.3 mm"}


@pytest.fixture
def packing():
    return load("dem_tension", SMALL).packing


@pytest.fixture
def checkpoint(tmp_path):
    return Checkpoint(tmp_path / "key.checkpoint.npz", "key")


@pytest.fixture
def made(monkeypatch):
    """Packings that were made anew."""
    count = []

    def counted(packing):
        count.append(packing)
        return pack(packing)

    monkeypatch.setattr(packing_shelf, "pack", counted)
    return count


def same(first, second):
    return all(np.asarray(a).tobytes() == np.asarray(b).tobytes() for a, b in zip(first, second, strict=True))


def test_packing_from_the_shelf_has_the_bits_of_a_fresh_one(packing, checkpoint, made):
    first, second = packed_discs(packing, checkpoint), packed_discs(packing, checkpoint)
    assert len(made) == 1
    assert same(first, second)
    assert same(first, pack(packing))
    assert [type(value) for value in second[3:]] == [type(value) for value in first[3:]]


def test_cases_of_several_kinds_share_a_packing_and_their_numbers_do_not_change(checkpoint, made):
    for module, kind in ((dem_tension, "dem_tension"), (dem_compression, "dem_compression")):
        case = load(kind, {**SMALL, "strain_max": 2e-5})
        kept, fresh = (module.simulate(case, lambda fraction: None, place, 0) for place in (checkpoint, None))
        assert all(kept[name].values.tobytes() == fresh[name].values.tobytes() for name in kept.variables)
    assert len(made) == 3


def test_another_seed_and_other_sources_are_other_files(packing, tmp_path, monkeypatch):
    other = load("dem_tension", {**SMALL, "packing.seed": 2}).packing
    names = {shelf_path(tmp_path, one) for one in (packing, other)}
    monkeypatch.setattr(packing_shelf, "digest_numbers", lambda kind: f"edited {kind}")
    assert len(names | {shelf_path(tmp_path, packing)}) == 3
    files = {file.name for file in identity.sources("packing")}
    assert {"packing.py", "pairs.py", "settle.py", "neighbours.py"} <= files
    assert not {"joints.py", "dem_specimen.py", "step.py"} & files


@pytest.mark.parametrize(
    "damage", [lambda content: content[:-100], lambda content: b"\1" + content[1:], lambda content: b""]
)
def test_broken_file_is_named_and_made_anew(packing, checkpoint, made, damage):
    first = packed_discs(packing, checkpoint)
    path = shelf_path(checkpoint.path.parent / FOLDER, packing)
    path.write_bytes(damage(path.read_bytes()))
    with pytest.warns(UserWarning, match=f"{path.name}: not used: .*made anew"):
        second = packed_discs(packing, checkpoint)
    assert same(first, second)
    assert len(made) == 2
    assert same(first, packed_discs(packing, checkpoint))
    assert len(made) == 2


@pytest.mark.filterwarnings("ignore:.*not used")
def test_run_goes_on_where_nothing_can_be_kept(packing, checkpoint):
    (checkpoint.path.parent / FOLDER).write_text("in the way")
    with pytest.warns(UserWarning, match="packing not kept"):
        assert same(packed_discs(packing, checkpoint), pack(packing))


def test_single_run_leaves_no_folder(packing, tmp_path, made):
    hidden = Checkpoint(tmp_path / ".cut.nc.checkpoint.npz", "key")
    assert isinstance(packed_discs(packing, hidden), PackedDiscs)
    assert isinstance(packed_discs(packing, None), PackedDiscs)
    assert list(tmp_path.iterdir()) == []
    assert len(made) == 2


SCRIPT = """
import sys
from pathlib import Path
from orthocut.experiments.packing_shelf import packed_discs
from orthocut.io.checkpoint import Checkpoint
from orthocut.params.case import load
case = load("dem_tension", {"packing.width": "0.2 mm", "packing.height": "0.3 mm"})
packed_discs(case.packing, Checkpoint(Path(sys.argv[1]) / "key.checkpoint.npz", "key"))
"""


def test_two_processes_at_once_leave_one_whole_file(packing, checkpoint, made):
    folder = checkpoint.path.parent
    running = [subprocess.Popen([sys.executable, "-c", SCRIPT, str(folder)]) for _ in range(2)]
    assert [process.wait() for process in running] == [0, 0]
    path = shelf_path(folder / FOLDER, packing)
    assert list((folder / FOLDER).iterdir()) == [path]
    assert same(packed_discs(packing, checkpoint), pack(packing))
    assert made == []
