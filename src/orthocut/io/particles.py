"""Snapshots of a run as particles, joints and cracks, whatever method made them: what other programs can show."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

from orthocut.io.collect import case_of

Fields = dict[str, np.ndarray]


class Frame(NamedTuple):
    """One snapshot, in SI."""

    time: float
    """[s]"""
    tool_tip: float
    """Position of the tool tip along the cut [m]; NaN where there is no tool."""
    position: np.ndarray
    """Centres of material points or discs [m], shape (n, 3); z is 0."""
    fields: Fields
    """Values of each particle, shape (n,) or (n, 9)."""
    joints: np.ndarray
    """Pairs of particles that are bonded, int, shape (m, 2)."""
    joint_fields: Fields
    """Values of each joint, shape (m,); none where the method has no joints."""
    cracks: np.ndarray
    """Ends of the broken elements until now [m], shape (k, 2, 3)."""
    crack_fields: Fields
    """Values of each crack, shape (k,); none where the method has no cracks."""


def frames(run: xr.Dataset) -> list[Frame]:
    """All snapshots of a run of any kind.

    Parameters
    ----------
    run : xarray.Dataset
        One run, or the part of it with the snapshots.

    Returns
    -------
    list of Frame
        Empty if the run has no snapshots.
    """
    make = next((make for name, make in (("point_x", _points), ("disc_x", _discs)) if name in run.variables), None)
    return [] if make is None else [make(run, run.isel(snapshot=index)) for index in range(run.sizes["snapshot"])]


def _points(run: xr.Dataset, shot: xr.Dataset) -> Frame:
    half = float(run["point_half_width"]) if "point_half_width" in run.variables else 0.25 * run.attrs["cell_m"]
    plane = shot["point_deformation"].values
    deformation = np.zeros((len(plane), 9))
    deformation[:, [0, 1, 3, 4]] = plane
    deformation[:, 8] = 1.0
    fields = {
        "radius": np.full(len(plane), half),
        "stress_equivalent": shot["point_stress"].values,
        "strain_plastic": shot["point_strain_plastic"].values,
        "deformation": deformation,
    }
    return _frame(shot, _space(shot["point_x"].values, shot["point_y"].values), fields)


def _discs(run: xr.Dataset, shot: xr.Dataset) -> Frame:
    position = _space(shot["disc_x"].values, shot["disc_y"].values)
    pairs = np.column_stack([run["bond_first"].values, run["bond_second"].values]).astype(np.int64)
    intact = shot["bond_intact"].values.astype(float)
    count = np.bincount(pairs.ravel(), minlength=len(position))
    held = np.bincount(pairs.ravel(), np.repeat(intact, 2), minlength=len(position))
    fields = {"radius": run["disc_radius"].values, "intact": held / np.maximum(count, 1)}
    bonded = intact > 0
    frame = _frame(shot, position, fields)._replace(joints=pairs[bonded], joint_fields={"intact": intact[bonded]})
    return _with_cracks(frame, run) if "crack_x" in run.variables else frame


def _with_cracks(frame: Frame, run: xr.Dataset) -> Frame:
    """Add the cracks until the time of a frame, as lines across their normals, as long as an element of a mean disc."""
    known = run["crack_time"].values <= frame.time
    normal = run["crack_normal"].values[known]
    half = float(run["disc_radius"].mean()) / case_of(run).joint.elements
    centre = _space(run["crack_x"].values[known], run["crack_y"].values[known])
    along = half * _space(-np.sin(normal), np.cos(normal))
    fields = {name: run[f"crack_{name}"].values[known] for name in ("time", "mode", "normal")}
    return frame._replace(cracks=np.stack([centre - along, centre + along], axis=1), crack_fields=fields)


def _frame(shot: xr.Dataset, position: np.ndarray, fields: Fields) -> Frame:
    """Frame without joints and cracks."""
    tip = float(shot["tool_tip_snapshot"]) if "tool_tip_snapshot" in shot.variables else np.nan
    nothing = np.zeros((0, 2), np.int64), {}, np.zeros((0, 2, 3)), {}
    return Frame(float(shot["time_snapshot"]), tip, position, fields, *nothing)


def _space(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.column_stack([x, y, np.zeros(len(x))])
