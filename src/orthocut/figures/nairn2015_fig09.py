"""Nairn (2015), Fig. 9: tool tip and crack tip at two depths of cut, on either side of the transition."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from orthocut.figures.canvas import PAGE, nothing, page, styled, values
from orthocut.figures.discretisation import finest
from orthocut.figures.regimes import transition
from orthocut.figures.scene import draw_tool, frame, last_snapshot, parallelograms
from orthocut.figures.snapshots import with_points
from orthocut.figures.sweep import cut_depth, touches
from orthocut.io.collect import case_of
from orthocut.theory.hardening import yield_stress

CAPTION = (
    "Tool tip and crack tip in a steady cut, after Nairn (2015), Fig. 9: the deepest cut that touches (left) and the "
    "shallowest that bends (right) of the runs, 2.0 and 2.1 mm in the paper. Black: points that yield (equivalent "
    "stress within 1 % of the yield stress, hardening included); dark grey: points that have yielded before; light "
    "grey: elastic. The triangle marks the crack tip. In the paper the transition is the collapse of a chip that "
    "yields all through to one that does not."
)
DIMS = ("sample", "snapshot", "point", "component")
SHADES = {"elastic": "#DCDCDC", "has yielded": "#8F8F8F", "yields": "#000000"}
AT_YIELD = 0.99
"""Equivalent stress over yield stress from which a point counts as yielding [-]."""
STRAIN_YIELDED = 1e-3
"""Plastic strain from which a point counts as having yielded [-]."""
REACH = 2.2
"""Half-width of the picture, in depths of cut."""


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Two panels, or one where all runs are of one regime."""
    runs = _either_side(with_points(finest(dataset)))
    if not runs:
        figure = page(2.0)
        nothing(figure.subplots())
        return figure
    figure = page(0.5 * PAGE + 0.3 if len(runs) > 1 else 0.7 * PAGE, PAGE if len(runs) > 1 else 0.6 * PAGE)
    panels = figure.subplots(1, len(runs), squeeze=False)[0]
    for ax, run in zip(panels, runs, strict=True):
        _panel(ax, run)
    handles = [Patch(fc=shade, ec="none", label=name) for name, shade in SHADES.items()]
    figure.legend(handles=handles, loc="outside upper center", ncols=3)
    return figure


def _either_side(runs: list[xr.Dataset]) -> list[xr.Dataset]:
    """Deepest run that touches and shallowest that bends; one of them where there is no other."""
    runs = sorted(runs, key=cut_depth)
    change = transition([(cut_depth(run), touches(run)) for run in runs])
    return [run for run in runs if cut_depth(run) in (change.low, change.high)][:2]


def _panel(ax: Axes, run: xr.Dataset) -> None:
    last, case = last_snapshot(run, "point_x"), case_of(run)
    depth = 1e3 * case.cut_depth
    tip = float(np.atleast_1d(values(run, "tool_tip_snapshot"))[last])
    corners, _ = parallelograms(run, last)
    points = PolyCollection(
        corners,
        array=state_of_points(run, last),
        cmap=ListedColormap(list(SHADES.values())),
        norm=Normalize(0, 2),
        edgecolors="none",
        antialiased=False,
        zorder=2,
    )
    points.set_rasterized(True)
    ax.add_collection(points, autolim=False)
    frame(ax, (tip - REACH * depth, tip + REACH * depth), (-0.45 * REACH * depth, 1.55 * REACH * depth))
    draw_tool(ax, case.tool, tip, 0.0, 6 * depth)
    crack = _crack_tip(run, last)
    if np.isfinite(crack):
        ax.plot(crack, 0.0, "v", color="#D55E00", mec="white", mew=0.5, ms=6, zorder=4)
    ax.set_title(f"$h$ = {depth:.3g} mm, {'touching' if touches(run) else 'bending'}", loc="left")


def state_of_points(run: xr.Dataset, snapshot: int) -> np.ndarray:
    """0 where a point is elastic, 1 where it has yielded before, 2 where it yields; points that are there only."""
    frame_, material = run.isel(snapshot=snapshot), case_of(run).material
    deformation = frame_["point_deformation"].values.reshape(-1, 2, 2)
    kirchhoff = frame_["point_stress"].values * np.linalg.det(deformation)
    strain = frame_["point_strain_plastic"].values
    limit = yield_stress(material, strain)
    state = np.where(kirchhoff >= AT_YIELD * limit, 2, np.where(strain > STRAIN_YIELDED, 1, 0))
    return state[np.isfinite(frame_["point_x"].values) & np.isfinite(deformation).all(axis=(1, 2))]


def _crack_tip(run: xr.Dataset, snapshot: int) -> float:
    """Position of the crack tip at a snapshot [mm]; NaN where the run does not say."""
    if "crack_tip" not in run:
        return np.nan
    time, place = run["time"].values, values(run, "crack_tip")
    good = np.isfinite(time) & np.isfinite(place)
    return float(np.interp(np.atleast_1d(run["time_snapshot"].values)[snapshot], time[good], place[good]))
