"""Export of particles: what vtk and OVITO read is what the run holds."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest
from synthetic import dem_cut_run, dem_test_run, mpm_run
from typer.testing import CliRunner

from orthocut.cli import app
from orthocut.io.datasets import failed, split
from orthocut.io.export import export
from orthocut.io.netcdf import write
from orthocut.io.particles import frames
from orthocut.params.block import ConfigError
from orthocut.params.case import load

RUNS = {"mpm": mpm_run, "dem": dem_cut_run, "tension": dem_test_run}


@pytest.fixture(params=RUNS)
def run(request):
    return RUNS[request.param]()


def read_vtp(path):
    """Points, cells, point data, cell data and field data of a file, read by vtk."""
    pytest.importorskip("vtk")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    cells = data.GetVerts() if data.GetNumberOfVerts() else data.GetLines()
    size = 1 if data.GetNumberOfVerts() else 2
    points = vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.zeros((0, 3))
    corners = vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size)
    groups = []
    for group in (data.GetPointData(), data.GetCellData(), data.GetFieldData()):
        names = [group.GetArrayName(k) for k in range(group.GetNumberOfArrays())]
        groups.append({name: vtk_to_numpy(group.GetArray(name)) for name in names})
    return points, corners, *groups


def equal(found, wanted):
    assert found.keys() == wanted.keys()
    for name in wanted:
        np.testing.assert_array_equal(found[name], wanted[name], err_msg=name)


def check_files(frame, particles, joints=None, cracks=None):
    points, cells, fields, _, facts = read_vtp(particles)
    np.testing.assert_array_equal(points, frame.position)
    np.testing.assert_array_equal(cells[:, 0], np.arange(len(points)))
    equal(fields, frame.fields)
    assert facts["TimeValue"][0] == frame.time
    assert ("tool_tip" in facts) == np.isfinite(frame.tool_tip)
    assert (joints is None) == (cracks is None) == (not frame.joint_fields)
    if joints:
        points, cells, _, fields, _ = read_vtp(joints)
        np.testing.assert_array_equal(points, frame.position)
        np.testing.assert_array_equal(cells, frame.joints)
        equal(fields, frame.joint_fields)
        points, cells, _, fields, _ = read_vtp(cracks)
        np.testing.assert_array_equal(points[cells.ravel()].reshape(-1, 2, 3), frame.cracks)
        equal(fields, frame.crack_fields)


def test_vtk_reads_a_time_series(run, tmp_path):
    pytest.importorskip("vtk")
    files = export(run, tmp_path / "cut.pvd")
    found = frames(run)
    tree = ElementTree.parse(files[0]).getroot()
    steps = {}
    for entry in tree.iter("DataSet"):
        parts = steps.setdefault(float(entry.get("timestep")), {})
        parts[entry.get("name")] = tmp_path / entry.get("file")
        assert entry.get("part") == str(list(parts).index(entry.get("name")))
    assert list(steps) == [frame.time for frame in found] == run.time_snapshot.values.tolist()
    assert {path for parts in steps.values() for path in parts.values()} == set(files[1:])
    for frame, parts in zip(found, steps.values(), strict=True):
        check_files(frame, **parts)


@pytest.mark.parametrize("snapshot", [None, 0])
def test_vtk_reads_one_snapshot(run, snapshot, tmp_path):
    pytest.importorskip("vtk")
    files = export(run, tmp_path / "cut.vtp", snapshot)
    check_files(frames(run)[-1 if snapshot is None else snapshot], *files)
    assert set(tmp_path.iterdir()) == set(files)


def test_text_holds_all_digits(run, tmp_path):
    (path,) = export(run, tmp_path / "cut.xyz", 1)
    frame = frames(run)[1]
    table = np.loadtxt(path, skiprows=2, usecols=(2, 3, 4, 5))
    np.testing.assert_array_equal(table, np.column_stack([frame.position, frame.fields["radius"]]))


def test_ovito_reads_all_snapshots(run, tmp_path):
    """To one unit in the last place, which OVITO's reading of text can lose; it keeps radii in single precision."""
    ovito = pytest.importorskip("ovito.io")
    (path,) = export(run, tmp_path / "cut.xyz")
    pipeline = ovito.import_file(str(path))
    found = frames(run)
    assert pipeline.num_frames == len(found)
    for index, frame in enumerate(found):
        data = pipeline.compute(index)
        assert data.attributes["Time"] == pytest.approx(frame.time, rel=1e-15, abs=0)
        assert tuple(data.cell.pbc) == (False, False, False)
        np.testing.assert_allclose(data.particles["Position"], frame.position, rtol=1e-15, atol=0)
        low = data.cell[:, 3]
        assert (frame.position >= low).all()
        assert (frame.position <= low + np.diag(data.cell[:, :3])).all()
        np.testing.assert_array_equal(data.particles["Particle Identifier"], np.arange(1, len(frame.position) + 1))
        for name, values in frame.fields.items():
            held = data.particles["Radius" if name == "radius" else name]
            accuracy = 1.2e-7 if name == "radius" else 1e-15
            np.testing.assert_allclose(held, values, rtol=accuracy, atol=0, err_msg=name)


def test_frames_hold_the_values_of_material_points():
    run = mpm_run()
    for index, frame in enumerate(frames(run)):
        shot = run.isel(snapshot=index)
        np.testing.assert_array_equal(frame.position.T, [shot.point_x, shot.point_y, 0 * shot.point_x])
        np.testing.assert_array_equal(frame.fields["stress_equivalent"], shot.point_stress)
        np.testing.assert_array_equal(frame.fields["strain_plastic"], shot.point_strain_plastic)
        gradient = frame.fields["deformation"].reshape(-1, 3, 3)
        np.testing.assert_array_equal(gradient[:, :2, :2].reshape(-1, 4), shot.point_deformation)
        np.testing.assert_array_equal(gradient[:, 2], np.tile([0, 0, 1], (len(gradient), 1)))
        assert (frame.fields["radius"] == float(run.point_half_width)).all()
        assert frame.tool_tip == float(shot.tool_tip_snapshot)


def test_frames_hold_joints_and_cracks_of_their_time():
    run = dem_cut_run(snapshots=4)
    found = frames(run)
    pairs = np.column_stack([run.bond_first, run.bond_second])
    for index, frame in enumerate(found):
        intact = run.bond_intact.values[index]
        np.testing.assert_array_equal(frame.joints, pairs[intact > 0])
        for disc in (0, 17):
            own = (pairs == disc).any(axis=1)
            assert frame.fields["intact"][disc] == pytest.approx(intact[own].mean())
        known = run.crack_time.values <= frame.time
        np.testing.assert_allclose(frame.cracks.mean(axis=1)[:, 0], run.crack_x.values[known])
        along = np.diff(frame.cracks, axis=1)[:, 0]
        normal = run.crack_normal.values[known]
        np.testing.assert_allclose(along[:, 0] * np.cos(normal) + along[:, 1] * np.sin(normal), 0, atol=1e-18)
        length = 2 * run.disc_radius.values.mean() / load("dem_cutting").joint.elements
        np.testing.assert_allclose(np.hypot(*along.T[:2]), length)
    assert len(found[0].cracks) < len(found[1].cracks) < len(found[3].cracks) == run.sizes["crack"]


def test_fields_of_the_store_are_enough():
    """The file of snapshots in a store has no single numbers: the half-width follows from the cell."""
    run = mpm_run()
    run.attrs["cell_m"] = 4 * float(run.point_half_width)
    fields = split(run)[1]
    assert "point_half_width" not in fields
    for one, other in zip(frames(fields), frames(run), strict=True):
        equal(one.fields, other.fields)


def call(*arguments):
    return CliRunner().invoke(app, ["export", *map(str, arguments)])


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "run.nc"
    write(mpm_run(), path)
    return path


def refused(result, *words):
    assert result.exit_code == 2, result.output
    assert result.stderr.startswith("error: ")
    for word in words:
        assert word in result.stderr


def test_the_verb_names_the_file_to_open(file):
    result = call(file, "--output", file.with_name("cut.xyz"), "--snapshot", 2)
    assert (result.exit_code, result.stdout) == (0, f"{file.with_name('cut.xyz')}\n")
    count = int(file.with_name("cut.xyz").read_text().partition("\n")[0])
    assert len(file.with_name("cut.xyz").read_text().splitlines()) == count + 2


@pytest.mark.parametrize("number", [-1, 4])
def test_unknown_snapshots_are_refused(file, number):
    refused(call(file, "-o", file.with_name("cut.xyz"), "--snapshot", number), "0 to 3")
    assert list(file.parent.iterdir()) == [file]


def test_odd_names_and_files_are_refused(file, tmp_path):
    refused(call(file, "-o", tmp_path / "cut.stl"), ".pvd", ".vtp", ".xyz")
    refused(call(file, "-o", tmp_path / "none" / "cut.xyz"), "not a folder")
    refused(call(tmp_path / "none.nc", "-o", tmp_path / "cut.xyz"), "no such file")
    refused(call(Path(__file__), "-o", tmp_path / "cut.xyz"), "not a netCDF file")
    (tmp_path / "folder.xyz").mkdir()
    refused(call(file, "-o", tmp_path / "folder.xyz"), "is a folder")


def test_runs_without_snapshots_are_refused(tmp_path):
    for name, run in (("empty", mpm_run(snapshots=0)), ("small", split(mpm_run())[0])):
        write(run, tmp_path / f"{name}.nc")
        refused(call(tmp_path / f"{name}.nc", "-o", tmp_path / "cut.xyz"), "has no snapshots", "orthocut run")
    write(failed(load("mpm_cutting"), "the chip sinks", 1.0), tmp_path / "failed.nc")
    refused(call(tmp_path / "failed.nc", "-o", tmp_path / "cut.xyz"), "the chip sinks")


def test_a_missing_library_is_named(monkeypatch, tmp_path):
    for name in ("vtkmodules", "vtkmodules.util.numpy_support"):
        monkeypatch.setitem(sys.modules, name, None)
    for ending in ("pvd", "vtp"):
        with pytest.raises(ConfigError, match=r"orthocut\[export\]"):
            export(mpm_run(), tmp_path / f"cut.{ending}")
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]


def test_nothing_is_left_of_a_failed_export(monkeypatch, tmp_path):
    def broken(*arguments):
        raise OSError("no space")

    (tmp_path / "cut.xyz").write_text("old")
    monkeypatch.setattr("orthocut.io.extended_xyz._write", broken)
    with pytest.raises(OSError, match="no space"):
        export(mpm_run(), tmp_path / "cut.xyz")
    assert [path.read_text() for path in tmp_path.iterdir()] == ["old"]
