"""Random dense packings by radius scaling to a target pressure.

A cloud of overlapping discs is calmed and settled between smooth walls; then all radii are scaled together until the
mean stress reaches the target (grain scaling, the usual practice with Yang et al.'s program).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from orthocut.dem.pairs import close_pairs
from orthocut.kernels.dem.layout import ROW
from orthocut.kernels.dem.settle import settle
from orthocut.params.block import CaseFailed
from orthocut.params.dem import Packing

TOLERANCE = 0.01
"""Allowed relative error of the pressure."""
EQUILIBRIUM = 8e-3
"""Largest mean unbalanced over mean contact force of a settled packing."""
_ROUNDS, _STEPS = 60, 20_000


class PackingError(CaseFailed):
    """A packing did not reach its target; the message says how far it came."""


class PackedDiscs(NamedTuple):
    """Discs of a packing in a vessel whose lower left corner is the origin, ordered along a space-filling curve."""

    x: np.ndarray
    """(n_discs,) [m]"""
    y: np.ndarray
    """(n_discs,) [m]"""
    radius: np.ndarray
    """(n_discs,) [m]"""
    pressure_ratio: float
    """Mean stress reached over contact modulus."""
    unbalanced_ratio: float
    """Mean unbalanced over mean contact force."""
    porosity: float
    """One less the area of the discs over that of the vessel, overlaps counted twice."""
    coordination: float
    """Mean number of contacts of a disc with other discs."""
    floaters: int
    """Discs with fewer than three contacts, walls included."""


def pack(packing: Packing) -> PackedDiscs:
    """Make a packing; the same parameters give the same bits.

    Raises
    ------
    PackingError
        If the target pressure is not reached.
    """
    unit = packing.radius_min
    width, height = packing.width / unit, packing.height / unit
    x, y, radius = _cloud(packing, width, height)
    order = _space_filling_order(x, y, max(width, height))
    x, y, radius = x[order], y[order], radius[order]

    _, (x, y, radius) = _settle(x, y, radius, width, height, calm=5, overlap=0.25, ratio=np.inf)
    inside = (x > 0) & (x < width) & (y > 0) & (y < height)
    x, y, radius = x[inside], y[inside], radius[inside]
    sums, (x, y, radius) = _settle(x, y, radius, width, height)

    for _ in range(_ROUNDS):
        pressure = sums[3] / (2 * width * height)
        if abs(pressure / packing.pressure_ratio - 1) <= TOLERANCE:
            break
        growth = 2 * width * height * (packing.pressure_ratio - pressure) / sums[4]
        radius = radius * (1 + float(np.clip(growth, -0.05, 0.05)))
        sums, (x, y, radius) = _settle(x, y, radius, width, height)
    else:
        raise PackingError(
            f"packing of {len(x)} discs, seed {packing.seed}: pressure over modulus is {pressure:.4g} after {_ROUNDS} "
            f"rounds (target: {packing.pressure_ratio:.4g} within {TOLERANCE:.0%})"
        )
    order = _space_filling_order(x, y, max(width, height))
    return _describe(x[order], y[order], radius[order], width, height, unit, pressure)


def _cloud(packing: Packing, width: float, height: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Random positions and radii, in units of the smallest radius, until the porosity of the cloud is met."""
    random = np.random.default_rng(packing.seed)
    ratio = packing.radius_ratio
    area = (1 - packing.porosity_cloud) * width * height
    guess = int(2 * area / (np.pi * (1 + ratio + ratio**2) / 3)) + 10
    radius = random.uniform(1.0, ratio, guess)
    radius = radius[: int(np.searchsorted(np.cumsum(np.pi * radius**2), area))]
    if len(radius) < 2:
        raise PackingError(f"a vessel of {packing.width:.3g} m x {packing.height:.3g} m holds fewer than two discs")
    x = random.uniform(radius, width - radius)
    y = random.uniform(radius, height - radius)
    return x, y, radius


def _settle(x, y, radius, width, height, calm=0, overlap=np.inf, ratio=EQUILIBRIUM):
    """Settle discs; return the sums of the contacts and the new (x, y, radius)."""
    n = len(x)
    position = np.zeros((n, ROW))
    position[:, 0], position[:, 1] = x, y
    skin = 0.4
    size = 2 * float(radius.max()) + skin
    grid = (0.0, 0.0, size, int(width / size) + 1, int(height / size) + 1)
    room = 8 * n
    while True:
        place, velocity = position.flatten(), np.zeros(ROW * n)
        lists = (
            np.zeros(n + 1, dtype=np.int64),
            np.zeros(room, dtype=np.int64),
            np.zeros(grid[3] * grid[4] + 1, dtype=np.int64),
            np.zeros(n, dtype=np.int64),
            np.zeros(n, dtype=np.int64),
        )
        steps, sums = settle(
            place, velocity, radius, width, height, lists, grid, skin, _STEPS, calm, float(overlap), float(ratio)
        )
        if steps >= 0:
            break
        if not np.isfinite(place).all():
            raise PackingError(f"packing of {n} discs diverged: the position of a disc is not a number")
        room *= 2
    if steps == _STEPS:
        raise PackingError(
            f"packing of {n} discs did not settle in {_STEPS} steps; largest overlap over diameter {sums[2]:.3g}"
        )
    place = place.reshape(n, ROW)
    return sums, (place[:, 0].copy(), place[:, 1].copy(), radius)


def _space_filling_order(x: np.ndarray, y: np.ndarray, extent: float) -> np.ndarray:
    """Order of points along a Morton curve, so that neighbours in space are neighbours in memory."""

    def spread(values: np.ndarray) -> np.ndarray:
        cells = np.clip(values / extent * 2**15, 0, 2**15 - 1).astype(np.uint64)
        for shift, mask in ((8, 0x00FF00FF), (4, 0x0F0F0F0F), (2, 0x33333333), (1, 0x55555555)):
            cells = (cells | (cells << np.uint64(shift))) & np.uint64(mask)
        return cells

    return np.argsort(spread(x) | (spread(y) << np.uint64(1)), kind="stable")


def _describe(x, y, radius, width, height, unit, pressure) -> PackedDiscs:
    """Measure a settled packing and turn it to SI units."""
    pairs = close_pairs(x, y, radius)
    contacts = np.bincount(pairs.ravel(), minlength=len(x))
    at_walls = sum((gap <= radius).astype(int) for gap in (x, width - x, y, height - y))
    dx, dy = x[pairs[:, 1]] - x[pairs[:, 0]], y[pairs[:, 1]] - y[pairs[:, 0]]
    distance = np.hypot(dx, dy)
    reach = radius[pairs].sum(axis=1)
    push = 2 * radius[pairs].min(axis=1) / reach * (reach - distance)
    force = np.zeros((len(x), 2))
    for axis, component in enumerate((dx, dy)):
        np.subtract.at(force[:, axis], pairs[:, 0], push * component / distance)
        np.add.at(force[:, axis], pairs[:, 1], push * component / distance)
    wall_pushes = [2 * np.clip(radius - gap, 0, None) for gap in (x, width - x, y, height - y)]
    force[:, 0] += wall_pushes[0] - wall_pushes[1]
    force[:, 1] += wall_pushes[2] - wall_pushes[3]
    mean_contact = (push.sum() + sum(p.sum() for p in wall_pushes)) / (len(pairs) + at_walls.sum())
    return PackedDiscs(
        x=x * unit,
        y=y * unit,
        radius=radius * unit,
        pressure_ratio=float(pressure),
        unbalanced_ratio=float(np.hypot(*force.T).mean() / mean_contact),
        porosity=float(1 - np.pi * np.sum(radius**2) / (width * height)),
        coordination=float(contacts.mean()),
        floaters=int(np.sum(contacts + at_walls < 3)),
    )
