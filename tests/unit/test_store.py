"""The store: results are found by case and sources, checked, never half there."""

import errno
import json
import os
import shutil

import netCDF4
import pytest
import xarray as xr
from synthetic import dem_cut_run, make_case, mpm_run

from orthocut.io.datasets import failed
from orthocut.io.seal import Broken, seal, unseal
from orthocut.io.store import SNAPSHOTS, Store
from orthocut.io.transfer import export_results, import_results
from orthocut.params.case import validate
from orthocut.params.identity import result_key


@pytest.fixture
def store(tmp_path):
    return Store(tmp_path / "store")


def put(store, run, snapshots=6):
    case = validate(json.loads(run.attrs["case"]))
    return case, store.put(case, run, snapshots)


def test_a_result_comes_back_as_it_was(store):
    run = mpm_run()
    _, entry = put(store, run)
    assert entry == store.entry(entry.key)
    assert (entry.status, entry.reason, entry.seconds) == ("done", "", 3.5)
    back = store.read(entry.key, snapshots=True)
    assert set(back.variables) == set(run.variables)
    assert float(back["force_cutting_mean"]) == float(run["force_cutting_mean"])
    assert back.attrs["case"] == run.attrs["case"]
    assert "point_x" not in store.read(entry.key)


def test_the_name_tells_case_and_sources(store, monkeypatch):
    case, entry = put(store, mpm_run())
    assert entry.key == result_key(case)
    monkeypatch.setattr("orthocut.params.identity.digest_numbers", lambda kind: "f" * 16)
    assert result_key(case).rpartition("-")[0] == entry.key.rpartition("-")[0]
    assert result_key(case) != entry.key


def test_snapshots_are_apart_and_only_there_if_wanted(store):
    _, entry = put(store, mpm_run(), snapshots=0)
    assert not store.path(entry.key, SNAPSHOTS).exists()
    assert store.holds(entry.key)
    assert not store.holds(entry.key, snapshots=1)
    put(store, mpm_run(), snapshots=6)
    assert store.holds(entry.key, snapshots=6)
    assert not store.holds(entry.key, snapshots=7)


@pytest.mark.parametrize("run", [mpm_run(), dem_cut_run()], ids=["mpm", "dem"])
def test_any_reader_of_netcdf_opens_the_files(store, run):
    _, entry = put(store, run)
    with netCDF4.Dataset(store.path(entry.key)) as file:
        assert file.case_id == run.attrs["case_id"]
    with xr.open_dataset(store.path(entry.key, SNAPSHOTS)) as fields:
        assert "snapshot" in fields.dims


def test_a_failed_case_is_a_result_until_it_is_tried_again(store):
    case = make_case("mpm_cutting")
    entry = store.put(case, failed(case, "it blew up", 1.5), 6)
    assert (entry.status, entry.reason) == ("failed", "it blew up")
    assert store.holds(entry.key, snapshots=6)
    assert store.attempts() == {}
    assert store.retry(entry.key)
    assert store.entry(entry.key) is None
    assert store.attempts() == {entry.key: 1}
    assert not store.retry(entry.key)


def test_a_done_case_is_not_tried_again(store):
    _, entry = put(store, mpm_run())
    assert not store.retry(entry.key)
    assert store.holds(entry.key)


@pytest.mark.parametrize("damage", ["truncated", "bit", "emptied", "unsealed", "seal"])
@pytest.mark.parametrize("suffix", [".nc", SNAPSHOTS])
def test_broken_files_are_named_and_set_aside(store, damage, suffix):
    _, entry = put(store, mpm_run())
    path = store.path(entry.key, suffix)
    content = path.read_bytes()
    middle = len(content) // 2
    path.write_bytes(
        {
            "truncated": content[:-100],
            "bit": content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :],
            "emptied": b"",
            "unsealed": content[: content.rfind(b"\northocut-seal")],
            "seal": content.replace(b'"done"', b'"fine"').replace(b'"snapshots":6', b'"snapshots":9'),
        }[damage]
    )
    with pytest.warns(UserWarning, match=f"{path.name}.*moved to.*simulated again"):
        assert not store.holds(entry.key, snapshots=6)
    assert not path.exists()
    assert len(list((store.root / "aside").iterdir())) == 1


def test_every_changed_byte_is_noticed(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(bytes(range(200)))
    seal(path, {"status": "done"})
    content = path.read_bytes()
    for place in range(len(content)):
        path.write_bytes(content[:place] + bytes([content[place] ^ 0x10]) + content[place + 1 :])
        with pytest.raises(Broken):
            unseal(path)


def test_a_broken_file_in_a_read_only_store_counts_as_missing(store, monkeypatch):
    _, entry = put(store, mpm_run())
    store.path(entry.key).write_bytes(b"nonsense")

    def refuse(*_):
        raise OSError(errno.EROFS, "Read-only file system")

    monkeypatch.setattr(os, "replace", refuse)
    with pytest.warns(UserWarning, match="cannot be moved away: Read-only file system"):
        assert store.entry(entry.key) is None


def test_a_full_disk_leaves_no_file(store, monkeypatch):
    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        put(store, mpm_run())
    assert store.names() == []
    assert list(store.root.iterdir()) == []


@pytest.mark.parametrize("name", ["folder", "archive.tar", "archive.tar.gz"])
def test_results_travel(store, tmp_path, name):
    keys = [put(store, mpm_run(cut_depth=f"{h} mm"))[1].key for h in (1, 2)]
    target = tmp_path / name
    assert len(export_results(store, keys, target).copied) == 4
    other = Store(tmp_path / "other")
    assert len(import_results(target, other).copied) == 4
    assert other.names() == store.names()
    for key in keys:
        assert other.path(key).read_bytes() == store.path(key).read_bytes()
    again = import_results(target, other)
    assert (len(again.copied), len(again.present)) == (0, 4)


def test_broken_results_do_not_travel(store, tmp_path):
    _, entry = put(store, mpm_run(), snapshots=0)
    shutil.copytree(store.root, tmp_path / "copy")
    (tmp_path / "copy" / f"{entry.key}.nc").write_bytes(b"nonsense")
    other = Store(tmp_path / "other")
    assert import_results(tmp_path / "copy", other).broken == [f"{entry.key}.nc"]
    assert other.names() == []
