"""Toughness of bonded discs: tension of a specimen with a central crack.

Joints that cross the crack are unbonded from the start, as slit joints are: they carry no tension. The toughness
follows from the largest stress over the whole width, for a crack of length 2a in a plate of width W, by

    K_Ic = stress sqrt(pi a sec(pi a/W)),

within 0.3 % for 2a/W up to 0.7 in a long plate under uniform stress (Tada, Paris & Irwin, The Stress Analysis of Cracks
Handbook, section 2.1).
"""

from __future__ import annotations

import math

import numpy as np
import xarray as xr

from orthocut.dem.joint_kinds import SLIT
from orthocut.dem.packing import PackedDiscs
from orthocut.dem.state import Scene
from orthocut.experiments import dem_tension
from orthocut.experiments.dem_specimen import Progress, specimen_dataset
from orthocut.experiments.packing_shelf import packed_discs
from orthocut.io.checkpoint import Checkpoint
from orthocut.kernels.dem.joint_order import sort_joints
from orthocut.kernels.dem.layout import BONDED, LANES, ROW
from orthocut.params.dem_toughness import DemToughness
from orthocut.variables import attributes


def crossing(case: DemToughness, scene: Scene) -> np.ndarray:
    """Joints whose line from centre to centre crosses the crack; int, shape (n,)."""
    first, second = (scene.places[ends // ROW] for ends in (scene.joints.first, scene.joints.second))
    below, above = (ends[:, 1] - 0.5 * case.packing.height for ends in (first, second))
    across = below * above < 0
    share = np.where(across, below / np.where(across, below - above, 1.0), 0.0)
    x = first[:, 0] + share * (second[:, 0] - first[:, 0])
    return np.flatnonzero(across & (np.abs(x - 0.5 * case.packing.width) < 0.5 * case.crack_length))


def make_scene(case: DemToughness, packed: PackedDiscs) -> Scene:
    """Specimen between its grips, with a crack in the middle of its height."""
    scene = dem_tension.make_scene(case, packed)
    joints = scene.joints
    slit = crossing(case, scene)
    block, lane = np.divmod(joints.place[slit], LANES)
    for element in range(case.joint.elements):
        joints.state[block, BONDED + element * LANES + lane] = 0.0
    joints.kind[slit] = SLIT
    sort_joints(joints, case.joint.elements)
    return scene


def stress_intensity(case: DemToughness, stress: float) -> float:
    """Stress intensity at the tips of the crack under a stress [Pa m^(1/2)]."""
    half = 0.5 * case.crack_length
    return stress * math.sqrt(math.pi * half / math.cos(math.pi * half / case.packing.width))


def simulate(
    case: DemToughness, progress: Progress, checkpoint: Checkpoint | None = None, snapshots: int = 2
) -> xr.Dataset:
    """Pull a cracked specimen apart; see `orthocut.variables` for what the dataset holds."""
    discs = packed_discs(case.packing, checkpoint)
    scene = make_scene(case, discs)
    title = "Tension of bonded discs with a central crack"
    run = specimen_dataset(case, title, discs, scene, 1, dem_tension.read_grips, progress, checkpoint, snapshots)
    toughness = stress_intensity(case, float(run.strength_ultimate))
    run = run.drop_vars(["modulus_young", "ratio_poisson"])
    return run.assign(toughness_fracture=((), toughness, attributes("toughness_fracture")))
