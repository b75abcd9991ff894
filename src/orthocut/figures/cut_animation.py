"""One cut in motion: the scene at each snapshot over the forces on the tool until then."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import matplotlib.style
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from orthocut.figures.canvas import PAGE, STYLE, cases, nothing, page, shown, styled, values
from orthocut.figures.scene import draw_cracks, draw_discs, draw_points, draw_tool, frame, last_snapshot, parallelograms
from orthocut.figures.specimen import crack_legend, draw_forces, extent
from orthocut.io.collect import case_of
from orthocut.io.files import replacing

CAPTION = (
    "One cut: the workpiece and the tool from start to end, and the forces on the tool. Material points are shaded by "
    "equivalent stress, from light grey at zero to black at twice the yield stress; lines between discs are cracks. "
    "The animation of the same name shows all snapshots."
)
STILLS = 4
WIDTH = 640  # pixels of the animation
COLOURS = 96
MILLISECONDS = 120  # between frames

Paint = Callable[[Axes, int], None]


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """Some snapshots of the first cut, evenly spaced."""
    run = _first(dataset)
    if run is None:
        figure = page(2.0)
        nothing(figure.subplots())
        return figure
    paint, aspect, last = _painter(run)
    figure = page(2 * (0.5 * PAGE * aspect + 0.5), PAGE)
    chosen = np.linspace(0, last, STILLS).round().astype(int)
    for index, ax in zip(chosen, figure.subplots(2, 2).flat, strict=True):
        paint(ax, int(index))
        ax.label_outer()
    return figure


def animate(dataset: xr.Dataset, path: str | Path) -> None:
    """Write an animation of the first cut; one still that says so if there is none.

    Parameters
    ----------
    dataset : xarray.Dataset
        Runs with snapshots.
    path : str or Path
        GIF file; it appears whole.
    """
    with matplotlib.style.context(["default", STYLE]):
        run = _first(dataset)
        pictures = [_image(draw(dataset))] if run is None else list(_frames(run))
    colours = pictures[-1].quantize(COLOURS)
    first, *others = [picture.quantize(palette=colours, dither=Image.Dither.NONE) for picture in pictures]
    with replacing(path) as temporary, open(temporary, "wb") as file:
        durations = [MILLISECONDS] * len(others) + [10 * MILLISECONDS]
        first.save(file, "GIF", save_all=True, append_images=others, duration=durations, loop=0, optimize=True)


def _first(dataset: xr.Dataset) -> xr.Dataset | None:
    """First cut that has snapshots."""
    for run in cases(dataset, "force_cutting"):
        if _last(run) >= 0:
            return run
    return None


def _last(run: xr.Dataset) -> int:
    return max(last_snapshot(run, "point_x"), last_snapshot(run, "disc_x"))


def _painter(run: xr.Dataset) -> tuple[Paint, float, int]:
    """How to paint a snapshot, height over width of the scene, index of the last snapshot."""
    case = case_of(run)
    paint, (low, high) = (_points if last_snapshot(run, "point_x") >= 0 else _discs)(run, case)
    times = np.atleast_1d(values(run, "time_snapshot"))

    def framed(ax: Axes, index: int) -> None:
        paint(ax, index)
        frame(ax, (low[0], high[0]), (low[1], high[1]))
        ax.set_title(f"$t$ = {times[index]:.3g} ms", loc="left")

    return framed, (high[1] - low[1]) / (high[0] - low[0]), _last(run)


def _points(run: xr.Dataset, case) -> tuple[Paint, tuple[np.ndarray, np.ndarray]]:
    corners = [parallelograms(run, index)[0].reshape(-1, 2) for index in range(_last(run) + 1)]
    depth = shown("cut_depth", case.cut_depth)
    low = np.min([points.min(axis=0) for points in corners], axis=0) - 0.3 * depth
    high = np.max([points.max(axis=0) for points in corners], axis=0) + np.array([1.5, 0.5]) * depth
    tips = np.atleast_1d(values(run, "tool_tip_snapshot"))

    def paint(ax: Axes, index: int) -> None:
        draw_points(ax, run, index, 2e-6 * case.material.stress_yield)
        draw_tool(ax, case.tool, float(tips[index]), 0.0, float(high[0] - low[0]))

    return paint, (low, high)


def _discs(run: xr.Dataset, case) -> tuple[Paint, tuple[np.ndarray, np.ndarray]]:
    width, height, depth = (1e3 * float(side) for side in (case.packing.width, case.packing.height, case.cut_depth))
    ranges = np.array([extent(run, index) for index in range(_last(run) + 1)])
    low, high = ranges[:, :, 0].min(axis=0), ranges[:, :, 1].max(axis=0)
    low, high = np.maximum(low, 0) - 0.02 * width, high + 0.04 * width
    tips = np.atleast_1d(values(run, "tool_tip_snapshot"))
    times = np.atleast_1d(run["time_snapshot"].values)

    def paint(ax: Axes, index: int) -> None:
        draw_discs(ax, run, index, width=0.12)
        counts = draw_cracks(ax, run, float(times[index]), width=0.8)
        draw_tool(ax, case.tool, float(tips[index]), height - depth, 2 * (width + height), filled=False)
        ax.legend(handles=crack_legend(*counts), loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2, borderaxespad=0)

    return paint, (low, high)


def _frames(run: xr.Dataset):
    """Pictures of all snapshots."""
    paint, aspect, last = _painter(run)
    dpi = WIDTH / PAGE
    times, now = np.atleast_1d(run["time_snapshot"].values), run["time"].values
    highest = 1.1 * np.nanmax(np.abs(values(run, "force_cutting")))
    for index in range(last + 1):
        figure = Figure(figsize=(PAGE, 0.86 * PAGE * aspect + 2.4), dpi=dpi)
        scene, curves = figure.subplots(2, 1, height_ratios=[0.86 * PAGE * aspect, 1.5])
        paint(scene, index)
        draw_forces(curves, run.isel(sample=now <= times[index]), lw=0.9)
        curves.set_xlim(0, float(np.nanmax(values(run, "tool_travel"))))
        lowest = min(float(np.nanmin(values(run, "force_thrust"))), 0.0)
        curves.set_ylim(1.1 * lowest if math.isfinite(lowest) else 0.0, highest)
        curves.axhline(0, color="0.4", lw=0.6)
        curves.legend(loc="upper left", ncols=2)
        yield _image(figure)


def _image(figure: Figure) -> Image.Image:
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3])
