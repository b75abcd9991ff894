"""Cracks of a scene of bonded discs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from orthocut.dem.state import Scene
from orthocut.kernels.dem.layout import CRACK


class CrackList(NamedTuple):
    """Broken elements in order of time."""

    crack_x: np.ndarray
    """[m]"""
    crack_y: np.ndarray
    """[m]"""
    crack_normal: np.ndarray
    """Direction of the normal to the x axis, between -pi/2 and pi/2 [rad]."""
    crack_time: np.ndarray
    """[s]"""
    crack_mode: np.ndarray
    """0 tension, 1 shear."""
    crack_bond: np.ndarray
    """Index of the joint."""


def cracks(scene: Scene) -> CrackList:
    """All cracks so far."""
    rows = scene.cracks.log.reshape(-1, CRACK)[: int(scene.cracks.count[0])]
    code = rows[:, 5].astype(np.int64)
    angle = np.arctan2(rows[:, 4], rows[:, 3])
    return CrackList(
        crack_x=rows[:, 1].copy(),
        crack_y=rows[:, 2].copy(),
        crack_normal=(angle + np.pi / 2) % np.pi - np.pi / 2,
        crack_time=rows[:, 0] * scene.time_step,
        crack_mode=(code % 2).astype(np.int8),
        crack_bond=code // 2,
    )


def count_cracks(scene: Scene) -> tuple[int, int]:
    """Numbers of elements broken in tension and in shear so far."""
    codes = scene.cracks.log.reshape(-1, CRACK)[: int(scene.cracks.count[0]), 5].astype(np.int64)
    shear = int(np.sum(codes % 2))
    return len(codes) - shear, shear
