"""Pictures of a scene: material points, discs, joints, cracks and the tool, to scale in mm."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.patches import Polygon

from orthocut.figures.canvas import values
from orthocut.figures.palette import DISC_EDGE, DISC_FACE, SHEAR, TENSION, TOOL_EDGE, TOOL_FACE
from orthocut.io.collect import case_of
from orthocut.params.tool import Tool

STRESS_MAP = LinearSegmentedColormap.from_list("stress", ["#E8E8E8", "#9A9A9A", "#000000"])
_CORNERS = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])


def parallelograms(run: xr.Dataset, snapshot: int) -> tuple[np.ndarray, np.ndarray]:
    """Corners of the deformed material points [mm] and the equivalent stress [MPa] in them.

    Returns
    -------
    corners : array, shape (n_points, 4, 2)
    stress : array, shape (n_points,)
    """
    frame = run.isel(snapshot=snapshot)
    centre = np.stack([values(frame, "point_x"), values(frame, "point_y")], axis=-1)
    deformation = frame["point_deformation"].values.reshape(-1, 2, 2)
    half = float(values(run, "point_half_width"))
    corners = centre[:, None, :] + half * np.einsum("pij,cj->pci", deformation, _CORNERS)
    good = np.isfinite(corners).all(axis=(1, 2))
    return corners[good], values(frame, "point_stress")[good]


def draw_points(ax: Axes, run: xr.Dataset, snapshot: int, stress_max: float) -> PolyCollection:
    """Material points as deformed parallelograms, shaded from 0 to `stress_max` [MPa]."""
    corners, stress = parallelograms(run, snapshot)
    points = PolyCollection(
        corners,
        array=stress,
        cmap=STRESS_MAP,
        norm=Normalize(0, stress_max),
        edgecolors="none",
        antialiased=False,
        zorder=2,
    )
    points.set_rasterized(True)
    ax.add_collection(points, autolim=False)
    return points


def wedge(tool: Tool, tip_x: float, tip_y: float, size: float) -> np.ndarray:
    """Corners of the tool, which moves towards -x, cut off at a distance `size` from the tip; shape (4, 2)."""
    rake, clearance = tool.rake_angle, tool.clearance_angle
    up = np.array([math.sin(rake), math.cos(rake)]) * size / math.cos(rake)
    back = np.array([math.cos(clearance), math.sin(clearance)]) * size / math.cos(clearance)
    tip = np.array([tip_x, tip_y])
    outer = np.array([max(up[0], back[0]), up[1]])
    return tip + np.array([np.zeros(2), up, outer, back])


def draw_tool(ax: Axes, tool: Tool, tip_x: float, tip_y: float, size: float, filled: bool = True) -> None:
    """The wedge, filled behind the material, or outlined and shaded before it; nothing if its place is not known."""
    if math.isfinite(tip_x):
        corners = wedge(tool, tip_x, tip_y, size)
        if filled:
            ax.add_patch(Polygon(corners, closed=True, fc=TOOL_FACE, ec=TOOL_EDGE, zorder=1.5))
            return
        ax.add_patch(Polygon(corners, closed=True, fc=TOOL_FACE, ec="none", alpha=0.35, zorder=2.9))
        ax.add_patch(Polygon(corners, closed=True, fc="none", ec=TOOL_EDGE, lw=1.2, zorder=3))


def draw_discs(ax: Axes, run: xr.Dataset, snapshot: int, face=DISC_FACE, edge=DISC_EDGE, width=0.15) -> None:
    """Discs to true scale; `face` is one colour or one a disc."""
    frame = run.isel(snapshot=snapshot)
    x, y = values(frame, "disc_x"), values(frame, "disc_y")
    diameter = 2 * run["disc_radius"].values * 1e3
    good = np.isfinite(x) & np.isfinite(y) & np.isfinite(diameter)
    face = face if isinstance(face, str) else np.asarray(face)[good]
    discs = EllipseCollection(
        diameter[good],
        diameter[good],
        np.zeros(good.sum()),
        units="xy",
        offsets=np.column_stack([x, y])[good],
        offset_transform=ax.transData,
        facecolors=face,
        edgecolors=edge,
        linewidths=width,
    )
    discs.set_rasterized(True)
    ax.add_collection(discs, autolim=False)


def draw_bonds(ax: Axes, run: xr.Dataset, snapshot: int, **style) -> int:
    """Joints that are still bonded, as lines between centres; return their number."""
    frame = run.isel(snapshot=snapshot)
    first, second = run["bond_first"].values, run["bond_second"].values
    good = np.isfinite(first) & (first >= 0) & (np.nan_to_num(frame["bond_intact"].values) > 0)
    first, second = first[good].astype(int), second[good].astype(int)
    centre = np.column_stack([values(frame, "disc_x"), values(frame, "disc_y")])
    segments = np.stack([centre[first], centre[second]], axis=1)
    segments = segments[np.isfinite(segments).all(axis=(1, 2))]
    lines = LineCollection(segments, **{"linewidths": 0.3, "colors": "#3A3A3A", **style})
    lines.set_rasterized(True)
    ax.add_collection(lines, autolim=False)
    return len(segments)


def draw_cracks(ax: Axes, run: xr.Dataset, before: float = math.inf, width: float = 0.7) -> tuple[int, int]:
    """Broken elements where and how they broke, as lines of their length; return the numbers in tension and in shear.

    Parameters
    ----------
    before : float
        Only cracks up to this time [s].
    """
    x, y, normal = values(run, "crack_x"), values(run, "crack_y"), np.atleast_1d(run["crack_normal"].values)
    mode, time = np.atleast_1d(run["crack_mode"].values), np.atleast_1d(run["crack_time"].values)
    good = np.isfinite(np.atleast_1d(x)) & np.isfinite(normal) & (mode >= 0) & ~(time > before)
    half = 1e3 * float(np.nanmean(run["disc_radius"].values)) / case_of(run).joint.elements
    along = half * np.column_stack([-np.sin(normal), np.cos(normal)])
    centre = np.column_stack([x, y])
    counts = []
    for wanted, colour, level in ((0, TENSION, 2.6), (1, SHEAR, 2.5)):
        chosen = good & (mode == wanted)
        segments = np.stack([centre[chosen] - along[chosen], centre[chosen] + along[chosen]], axis=1)
        ax.add_collection(LineCollection(segments, colors=colour, linewidths=width, zorder=level), autolim=False)
        counts.append(int(chosen.sum()))
    return counts[0], counts[1]


def frame(ax: Axes, x: tuple[float, float], y: tuple[float, float]) -> None:
    """True scale, limits in mm, both axes named."""
    ax.set_aspect("equal")
    ax.set_xlim(*x)
    ax.set_ylim(*y)
    ax.grid(False)
    ax.set_xlabel("$x$ [mm]")
    ax.set_ylabel("$y$ [mm]")


def last_snapshot(run: xr.Dataset, name: str) -> int:
    """Index of the last snapshot that holds finite values of a variable, -1 if none does."""
    if name not in run.variables or "snapshot" not in run[name].dims:
        return -1
    data = run[name]
    finite = np.isfinite(data).any([dim for dim in data.dims if dim != "snapshot"]).values
    return int(np.flatnonzero(finite)[-1]) if finite.any() else -1
