"""Unconfined compression of a specimen of bonded discs (Yang et al. 2018, section 3.2).

The compressive strength (UCS, ``strength_ultimate``) is the magnitude of the largest axial stress in the measurement
region, the middle half of the height over the whole width of the packing, before the stress has dropped to the stated
fraction. Young's modulus and Poisson's ratio are secants of this test, as in tension; those reported for the material
are of the tension test.
"""

from __future__ import annotations

import xarray as xr

from orthocut.experiments.dem_platens import between_platens, read_platens
from orthocut.experiments.dem_specimen import Progress, specimen_dataset
from orthocut.experiments.packing_shelf import packed_discs
from orthocut.io.checkpoint import Checkpoint
from orthocut.params.dem import DemCompression


def simulate(
    case: DemCompression, progress: Progress, checkpoint: Checkpoint | None = None, snapshots: int = 2
) -> xr.Dataset:
    """Crush a specimen; see `orthocut.variables` for what the dataset holds. Snapshots are start and end."""
    discs = packed_discs(case.packing, checkpoint)
    scene = between_platens(case, discs.x, discs.y, discs.radius)
    title = "Unconfined compression of bonded discs"
    return specimen_dataset(case, title, discs, scene, -1, read_platens, progress, checkpoint, snapshots)
