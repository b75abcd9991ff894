"""What all experiments with bonded discs share: running with a guard, energies and discs as data."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from orthocut.dem.joint_kinds import GAPPED, SLIT
from orthocut.dem.packing import PackedDiscs
from orthocut.dem.solver import CROWDED, DONE, TOO_FAST, advance
from orthocut.dem.state import Scene
from orthocut.kernels.dem.layout import ROW
from orthocut.measure.dem_cracks import cracks
from orthocut.measure.dem_energy import Energies
from orthocut.measure.guard import Diverged

_WHY = {
    TOO_FAST: "a disc is faster than {limit:.3g} m/s, a fifth of the speed of sound, or its velocity is not a number",
    CROWDED: "a disc has more neighbours than the list of contacts has room for",
}


def proceed(scene: Scene, steps: int) -> None:
    """Advance a scene.

    Raises
    ------
    Diverged
        If a disc gets too fast or the search for neighbours fails.
    """
    status = advance(scene, steps)
    if status != DONE:
        why = _WHY[status].format(limit=scene.speed_limit)
        raise Diverged(
            f"step {int(scene.clock[0])}, time {scene.time:.4g} s: {why}; try a smaller joint.time_step_factor"
        )


def energy_data(history: list[Energies], start: Energies) -> dict[str, np.ndarray]:
    """Histories of all energies and of what the balance leaves open."""
    data = {name: np.array([getattr(row, name) for row in history]) for name in Energies._fields}
    data["energy_residual"] = np.array([start.total - row.total for row in history])
    return data


def closure(last: Energies, start: Energies) -> float:
    """Energy not accounted for over the work done and the energy at the start; zero where a tool met nothing."""
    scale = abs(last.work_tool) + abs(start.energy_kinetic)
    return (start.total - last.total) / scale if scale else 0.0


def packing_data(packed: PackedDiscs, scene: Scene) -> dict[str, tuple[tuple[str, ...], Any]]:
    """What the packing reached, and how its discs are joined."""
    return {
        "disc_count": ((), len(packed.x)),
        "bond_count": ((), len(scene.joints.first)),
        "bonds_gapped": ((), int(np.sum(scene.joints.kind == GAPPED))),
        "bonds_slit": ((), int(np.sum(scene.joints.kind == SLIT))),
        "pressure_reached": ((), packed.pressure_ratio),
        "porosity": ((), packed.porosity),
        "coordination": ((), packed.coordination),
        "floaters": ((), packed.floaters),
    }


def field_data(scene: Scene) -> dict[str, tuple[tuple[str, ...], Any]]:
    """What belongs to snapshots: radii, joints, and all cracks along the dimension ``crack``."""
    return {
        "disc_radius": (("disc",), scene.radius),
        "bond_first": (("bond",), (scene.joints.first // ROW).astype(np.int32)),
        "bond_second": (("bond",), (scene.joints.second // ROW).astype(np.int32)),
        "bond_kind": (("bond",), scene.joints.kind),
        **{name: (("crack",), values) for name, values in cracks(scene)._asdict().items()},
    }


def timing(advancing: float, scene: Scene) -> Mapping[str, float]:
    """Attributes that tell the cost of a run: they differ between repeats and so are no variables.

    Parameters
    ----------
    advancing : float
        CPU time of the steps alone [s].
    scene : Scene
    """
    bond_steps = max(int(scene.clock[0]), 1) * max(len(scene.joints.first), 1)
    return {
        "particles": len(scene.places),
        "steps": int(scene.clock[0]),
        "time_step_s": scene.time_step,
        "ns_per_bond_step": 1e9 * advancing / bond_steps,
    }
