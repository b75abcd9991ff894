"""``orthocut store gc``: what a study wants stays, all else goes."""

import json
import re
import subprocess
import sys
import tarfile

import pytest
import yaml
from synthetic import dem_cut_run
from typer.testing import CliRunner

from orthocut.cli import app
from orthocut.experiments.packing_shelf import FOLDER, shelf_path
from orthocut.io.store import IN_USE, Store
from orthocut.params.case import validate


@pytest.fixture
def shelf(tmp_path):
    """A store with a wanted result, an unwanted one, a checkpoint, and a packing of each; and a study of the first."""
    store = Store(tmp_path / "store")
    wanted = validate(json.loads(dem_cut_run().attrs["case"]))
    other = wanted.model_copy(update={"packing": wanted.packing.model_copy(update={"seed": 77})})
    folder = store.root / FOLDER
    folder.mkdir(parents=True)
    keep, drop = [], [store.root / "x.checkpoint.npz", store.root / "x.snapshots.nc", folder / ".packing-x.npy.1.part"]
    drop += [store.root / ".x.checkpoint.npz.1.part", store.root / ".import-x" / "y.nc"]
    (store.root / ".import-x").mkdir()
    for case, files in ((wanted, keep), (other, drop)):
        files += [store.path(store.put(case, dem_cut_run(), 0).key), shelf_path(folder, case.packing)]
    for path in (*keep, *drop):
        path.touch()
    study = tmp_path / "one.yaml"
    case = wanted.model_dump()
    study.write_text(yaml.safe_dump({"title": "one", "sweeps": {"cut": {"base": case}}, "figures": {}}))
    return store, study, keep, drop


def gc(store, study, *options):
    result = CliRunner().invoke(app, ["store", "gc", "--store", str(store.root), "--study", str(study), *options])
    assert result.exit_code == 0, result.output
    return result


def test_gc_removes_what_no_case_of_the_study_wants(shelf):
    store, study, keep, drop = shelf
    gc(store, study)
    assert all(path.exists() for path in keep)
    assert not any(path.exists() for path in drop)
    assert not (store.root / ".import-x").exists()


def test_gc_on_trial_names_files_and_leaves_them(shelf):
    store, study, keep, drop = shelf
    result = gc(store, study, "--dry-run")
    lines = result.stdout.splitlines()
    assert len(lines) == len(set(lines))
    named = set(result.output.split())
    assert {str(path) for path in drop} <= named
    assert not named & {str(path) for path in keep}
    assert all(path.exists() for path in (*keep, *drop))


def test_gc_waits_for_workflows_that_use_the_store(shelf):
    store, study, keep, drop = shelf
    program = f"import time; from orthocut.io.files import hold; hold({str(store.root / IN_USE)!r}, shared=True)"
    with subprocess.Popen([sys.executable, "-c", f"{program}; print(flush=True); time.sleep(60)"], stdout=-1) as user:
        user.stdout.readline()
        command = ["store", "gc", "--store", str(store.root), "--study", str(study)]
        result = CliRunner().invoke(app, command)
        user.kill()
    assert result.exit_code == 2
    assert f"in use by process {user.pid}" in result.output
    assert all(path.exists() for path in (*keep, *drop))
    gc(store, study)
    assert not any(path.exists() for path in drop)


@pytest.mark.parametrize("name", ["results.zip", "results.tar.gz"])
def test_what_is_no_archive_of_results_is_refused(name, tmp_path):
    source = tmp_path / name
    with tarfile.open(source, "w:gz") as archive:
        archive.add(__file__, arcname="x.nc")
    source.write_bytes(source.read_bytes()[:-40])
    result = CliRunner().invoke(app, ["store", "import", str(source), "--store", str(tmp_path / "store")])
    assert result.exit_code == 2
    assert re.search(f"error: .*{name}: is not ", result.output)
