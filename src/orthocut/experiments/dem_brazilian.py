"""Brazilian disc: a disc of bonded discs between two platens splits along its loaded diameter.

An elastic disc of diameter D under a force P for unit width has the tensile stress 2P/(pi D) across the middle of its
loaded diameter. It is reported as ``stress_grip`` from the platens and as ``stress_axial`` from the measurement region,
the middle half of the height, both negative as the load is. Its largest magnitude is the indirect tensile strength,
``strength_ultimate``, which in bonded-particle models differs from the direct one by tens of per cent. With flats under
the platens the tension in the middle is a few per cent less than 2P/(pi D).
"""

from __future__ import annotations

import math

import numpy as np
import xarray as xr

from orthocut.dem.packing import PackedDiscs
from orthocut.experiments.dem_platens import between_platens, read_platens
from orthocut.experiments.dem_specimen import Progress, specimen_dataset
from orthocut.experiments.packing_shelf import packed_discs
from orthocut.io.checkpoint import Checkpoint
from orthocut.params.dem import DemBrazilian


def select_discs(case: DemBrazilian, packed: PackedDiscs) -> np.ndarray:
    """Discs with their centres in the round specimen, and wholly between its flats; bool, shape (n_discs,)."""
    x, y = packed.x - 0.5 * case.packing.width, packed.y - 0.5 * case.packing.height
    half = 0.5 * case.diameter
    reach = half * math.sqrt(1 - case.flat_ratio**2)
    return (np.hypot(x, y) <= half) & (np.abs(y) + packed.radius <= reach)


def simulate(
    case: DemBrazilian, progress: Progress, checkpoint: Checkpoint | None = None, snapshots: int = 2
) -> xr.Dataset:
    """Split a disc; see `orthocut.variables` for what the dataset holds. Snapshots are start and end."""
    discs = packed_discs(case.packing, checkpoint)
    kept = select_discs(case, discs)
    scene = between_platens(case, discs.x[kept], discs.y[kept], discs.radius[kept])
    section = 0.5 * math.pi * case.diameter
    title = "Brazilian test of bonded discs"
    run = specimen_dataset(case, title, discs, scene, -1, read_platens, progress, checkpoint, snapshots, section)
    return run.drop_vars(["modulus_young", "ratio_poisson"])
