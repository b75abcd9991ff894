"""Write particles, joints and cracks for ParaView: VTK PolyData files and time series of them."""

from __future__ import annotations

from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np

from orthocut.io.files import replacing, write_text
from orthocut.io.particles import Fields, Frame


def write_vtp(frame: Frame, path: str | Path) -> list[Path]:
    """Write one snapshot: particles under the name given, joints and cracks, where a method has them, beside it.

    Parameters
    ----------
    frame : Frame
    path : str or Path
        File that ends in .vtp; joints and cracks get ``_joints`` and ``_cracks`` before the ending.

    Returns
    -------
    list of Path
        The files; each is written whole or not at all.

    Raises
    ------
    ImportError
        If vtk is not installed.
    """
    path = Path(path)
    order = np.arange(len(frame.position))
    _write(path, frame, frame.position, order[:, None], points=frame.fields)
    paths = [path]
    if frame.joint_fields:
        paths.append(path.with_name(f"{path.stem}_joints.vtp"))
        _write(paths[-1], frame, frame.position, frame.joints, cells=frame.joint_fields)
    if frame.crack_fields:
        paths.append(path.with_name(f"{path.stem}_cracks.vtp"))
        ends = frame.cracks.reshape(-1, 3)
        _write(paths[-1], frame, ends, np.arange(len(ends)).reshape(-1, 2), cells=frame.crack_fields)
    return paths


def write_pvd(frames: list[Frame], path: str | Path) -> list[Path]:
    """Write a time series; its files lie in a folder beside it, and the series itself is written last.

    Parameters
    ----------
    frames : list of Frame
    path : str or Path
        File that ends in .pvd; ``cut.pvd`` has its files in ``cut_vtp``.

    Returns
    -------
    list of Path
        All files, the series first.
    """
    path = Path(path)
    folder = path.with_name(f"{path.stem}_vtp")
    entries, written = [], []
    for index, frame in enumerate(frames):
        files = write_vtp(frame, folder / f"particles_{index:04d}.vtp")
        written += files
        for file in files:
            part = file.stem.rpartition("_")[2]
            number = {"joints": 1, "cracks": 2}.get(part, 0)
            name = part if number else "particles"
            place = quoteattr(f"{folder.name}/{file.name}")
            entries.append(f'    <DataSet timestep="{frame.time!r}" part="{number}" name="{name}" file={place}/>')
    head = ['<?xml version="1.0"?>', '<VTKFile type="Collection" version="0.1">', "  <Collection>"]
    write_text("\n".join([*head, *entries, "  </Collection>", "</VTKFile>", ""]), path)
    return [path, *written]


def _write(
    path: Path, frame: Frame, position: np.ndarray, cells_of: np.ndarray, points: Fields | None = None, cells=None
) -> None:
    """Write PolyData of vertices (one point a cell) or lines (two points a cell)."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    def named(name: str, values: np.ndarray):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        return array

    data, places, shapes = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(position), deep=True))
    data.SetPoints(places)
    count, size = cells_of.shape
    offsets = np.arange(0, size * (count + 1), size, dtype=np.int64)
    corners = np.ascontiguousarray(cells_of.ravel(), dtype=np.int64)
    shapes.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(corners, deep=True))
    (data.SetVerts if size == 1 else data.SetLines)(shapes)
    for name, values in (points or {}).items():
        data.GetPointData().AddArray(named(name, values))
    for name, values in (cells or {}).items():
        data.GetCellData().AddArray(named(name, values))
    for name, value in (("TimeValue", frame.time), ("tool_tip", frame.tool_tip)):
        if np.isfinite(value):
            data.GetFieldData().AddArray(named(name, np.array([value])))
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    with replacing(path) as temporary:
        writer.SetFileName(str(temporary))
        if not writer.Write():
            raise OSError(f"{path}: vtk could not write it")
