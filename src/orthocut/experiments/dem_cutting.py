"""Orthogonal cut of a block of bonded discs by a rigid tool (Yang et al. 2018, section 4).

The block stands on y = 0 with its left side at x = 0; both are fixed. The tool enters from the free right side and
moves towards -x, its tip at the height of the block less the depth of cut.
"""

from __future__ import annotations

import math
import time
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from orthocut.dem.packing import PackedDiscs
from orthocut.dem.setup import build, wall
from orthocut.dem.state import Scene
from orthocut.experiments.dem_run import closure, energy_data, field_data, packing_data, proceed, timing
from orthocut.experiments.dem_specimen import Progress
from orthocut.experiments.packing_shelf import packed_discs
from orthocut.io.checkpoint import Checkpoint, packed, unpacked
from orthocut.io.datasets import build as build_dataset
from orthocut.kernels.dem.layout import ROW, TIP_X, WALL_PEAK_X, WALL_PEAK_Y, WALL_SUM_X, WALL_SUM_Y
from orthocut.measure.dem_chips import Chips, chips
from orthocut.measure.dem_contact import reduce, touching
from orthocut.measure.dem_cracks import count_cracks, cracks
from orthocut.measure.dem_damage import damage
from orthocut.measure.dem_energy import Energies, energies, forces
from orthocut.measure.dem_watch import watch
from orthocut.params.dem import DemCutting

SAMPLES = 500
"""Intervals of the history; forces are means over all steps of an interval."""


class Sample(NamedTuple):
    """One row of the history."""

    time: float
    tool_travel: float
    tool_tip: float
    force_cutting: float
    force_thrust: float
    cracks_tension: int
    cracks_shear: int
    energies: Energies


class Snapshot(NamedTuple):
    """Discs and joints at an instant."""

    time: float
    tool_tip: float
    places: np.ndarray
    intact: np.ndarray


def select_discs(case: DemCutting, packed: PackedDiscs) -> np.ndarray:
    """Discs that remain when the grooves, as deep as the cut, are made; bool, shape (n_discs,)."""
    keep = np.ones(len(packed.x), dtype=bool)
    if case.grooves is None:
        return keep
    height = (packed.y - (case.packing.height - case.cut_depth)) / case.cut_depth
    narrowing = (1 - case.grooves.bottom_ratio) * (1 - height)
    half_width = 0.5 * case.grooves.width * (1 - narrowing)
    for left, right in case.grooves.edges(case.packing.width):
        keep &= ~((np.abs(packed.x - 0.5 * (left + right)) < half_width) & (height > 0))
    return keep


def make_scene(case: DemCutting, packed: PackedDiscs) -> Scene:
    """Block with fixed rows of discs at its left side and bottom, and the tool where its rake face just touches."""
    keep = select_discs(case, packed)
    x, y, radius = packed.x[keep], packed.y[keep], packed.radius[keep]
    row = 0.5 * float(radius.min())
    fixed = np.flatnonzero((x - radius < row) | (y - radius < row))

    tool, tip_y = case.tool, case.packing.height - case.cut_depth
    cosine, sine = math.cos(tool.rake_angle), math.sin(tool.rake_angle)
    above = y - tip_y
    by_face = x + (radius - sine * above) / cosine
    by_tip = x + np.sqrt(np.maximum(radius**2 - above**2, 0.0))
    meets_face = above > radius * sine
    tip_x = float(np.max(np.where(meets_face, by_face, by_tip)[above > -radius]))
    rake = (-cosine, sine)
    clearance = (math.sin(tool.clearance_angle), -math.cos(tool.clearance_angle))
    wedge = wall((tip_x, tip_y), (rake, clearance), (-case.cut_speed, 0.0), tool.friction, case.joint.modulus)
    return build(x, y, radius, case.joint, walls=[wedge], driven=fixed, group=np.zeros(len(fixed), dtype=np.int64))


def read_tool(scene: Scene, steps: int) -> tuple[float, float]:
    """Mean cutting and thrust force over the last steps [N/m]: along the motion, and down into the block."""
    row = scene.walls.rows[0]
    cutting, thrust = row[WALL_SUM_X] / steps, row[WALL_SUM_Y] / steps
    row[WALL_SUM_X] = row[WALL_SUM_Y] = 0.0
    return float(cutting), float(thrust)


class Progressed(NamedTuple):
    """What a run has gathered so far."""

    samples: list[Sample]
    snapshots: list[Snapshot]
    advancing: float
    """CPU time of the steps [s]."""


def simulate(
    case: DemCutting, progress: Progress, checkpoint: Checkpoint | None = None, snapshots: int = 6
) -> xr.Dataset:
    """Cut a block; see `orthocut.variables` for what the dataset holds.

    Parameters
    ----------
    case : DemCutting
    progress : callable
        Receives the fraction done.
    checkpoint : Checkpoint, optional
        Where the run goes on from, and leaves its state now and then.
    snapshots : int
        Snapshots to take, evenly spaced: the first before the cut, the last at its end.

    Raises
    ------
    Diverged
        If a disc gets too fast, energy does not balance or discs overlap too far.
    """
    discs = packed_discs(case.packing, checkpoint)
    scene = make_scene(case, discs)
    proceed(scene, 0)
    steps = math.ceil(case.travel / case.cut_speed / scene.time_step)
    ends = [steps * (k + 1) // SAMPLES for k in range(SAMPLES)]
    tip_start = float(scene.walls.rows[0, TIP_X])
    start, whole = energies(scene), forces(scene).intact
    samples, shots, advancing = _restore(scene, checkpoint) or Progressed([], [_shoot(scene)], 0.0)

    for k in range(len(samples), SAMPLES):
        ran = ends[k] - int(scene.clock[0])
        resumed = time.thread_time()
        proceed(scene, ran)
        advancing += time.thread_time() - resumed
        tip = float(scene.walls.rows[0, TIP_X])
        balance = energies(scene)
        watch(scene, balance, start)
        samples.append(Sample(scene.time, tip_start - tip, tip, *read_tool(scene, ran), *count_cracks(scene), balance))
        if (k + 1) * (snapshots - 1) // SAMPLES == len(shots):
            shots.append(_shoot(scene))
        progress((k + 1) / SAMPLES)
        if checkpoint:
            checkpoint.offer(partial(_state, scene, Progressed(samples, shots, advancing)))

    loose = _chips(scene, whole)
    data = _data(case, discs, scene, samples, start) | _chip_data(loose)
    if snapshots:
        data |= _fields(scene, shots) | {"chip_area": (("chip",), loose.areas)}
    dataset = build_dataset(case, "Orthogonal cut of bonded discs", data, {"time": data.pop("time")})
    dataset.attrs.update(timing(advancing, scene))
    return dataset


def _shoot(scene: Scene) -> Snapshot:
    return Snapshot(scene.time, float(scene.walls.rows[0, TIP_X]), scene.places.copy(), forces(scene).intact)


def _state(scene: Scene, done: Progressed) -> dict[str, np.ndarray]:
    """All that a run needs to go on."""
    shots = {name: np.array([getattr(shot, name) for shot in done.snapshots]) for name in Snapshot._fields}
    samples = np.array([[*sample[:-1], *sample.energies] for sample in done.samples])
    numbers = {"samples": samples, "advancing": np.array(done.advancing)}
    return numbers | packed("scene", scene.freeze()) | packed("shot", shots)


def _restore(scene: Scene, checkpoint: Checkpoint | None) -> Progressed | None:
    """Bring a scene to the last checkpoint, if there is one; return what was gathered until then."""
    saved = checkpoint.restore() if checkpoint else None
    if saved is None:
        return None
    scene.thaw(unpacked("scene", saved))
    shots = unpacked("shot", saved)
    last = len(Sample._fields) - 1
    return Progressed(
        [Sample(*row[:last], Energies(*row[last:])) for row in saved["samples"].tolist()],
        [Snapshot(*shot) for shot in zip(*(shots[name] for name in Snapshot._fields), strict=True)],
        float(saved["advancing"]),
    )


def _data(
    case: DemCutting,
    discs: PackedDiscs,
    scene: Scene,
    samples: list[Sample],
    start: Energies,
) -> dict[str, tuple[tuple[str, ...], Any]]:
    """Histories and results."""
    column = {name: np.array([getattr(s, name) for s in samples], dtype=float) for name in Sample._fields[:-1]}
    history = {**column, **energy_data([s.energies for s in samples], start)}
    contact = touching(column["force_cutting"], column["force_thrust"])
    below = damage(cracks(scene), case.packing.height - case.cut_depth)
    tension, shear = count_cracks(scene)
    tool = scene.walls.rows[0]
    results: dict[str, Any] = {"air_share": ((), float(1 - contact.mean()))}
    for name, peak in (("force_cutting", WALL_PEAK_X), ("force_thrust", WALL_PEAK_Y)):
        force = reduce(column[name], contact, case.travel, case.cut_depth)
        results |= {f"{name}_{key}": ((), value) for key, value in force._asdict().items()}
        results[f"{name}_peak"] = ((), float(tool[peak]))
    return {
        **{name: (("sample",), values) for name, values in history.items()},
        **results,
        "damage_depth": ((), below.depth),
        "damage_depth_most": ((), below.depth_most),
        "cracks_tension_below": ((), below.tension),
        "cracks_shear_below": ((), below.shear),
        "cracks_tension_total": ((), tension),
        "cracks_shear_total": ((), shear),
        "energy_closure": ((), closure(samples[-1].energies, start)),
        **packing_data(discs, scene),
    }


def _chips(scene: Scene, whole: np.ndarray) -> Chips:
    """What has come off the block so far; `whole` are the fractions of bonded elements before the cut."""
    first, second = (index.astype(np.int64) // ROW for index in (scene.joints.first, scene.joints.second))
    return chips(first, second, forces(scene).intact, whole, scene.radius, scene.driven // ROW)


def _chip_data(loose: Chips) -> dict[str, tuple[tuple[str, ...], Any]]:
    """Number and areas of the chips."""
    return {
        "chip_count": ((), len(loose.areas)),
        "chip_area_largest": ((), float(loose.areas.max(initial=0.0))),
        "chip_area_total": ((), float(loose.areas.sum())),
        "grain_count": ((), loose.grains),
        "grain_area_total": ((), loose.grain_area),
    }


def _fields(scene: Scene, snapshots: list[Snapshot]) -> dict[str, tuple[tuple[str, ...], Any]]:
    """Snapshots, discs, joints and cracks."""
    fixed = np.zeros(len(scene.radius), dtype=np.int8)
    fixed[scene.driven // ROW] = 1
    return {
        "disc_fixed": (("disc",), fixed),
        "time_snapshot": (("snapshot",), [s.time for s in snapshots]),
        "tool_tip_snapshot": (("snapshot",), [s.tool_tip for s in snapshots]),
        "disc_x": (("snapshot", "disc"), [s.places[:, 0] for s in snapshots]),
        "disc_y": (("snapshot", "disc"), [s.places[:, 1] for s in snapshots]),
        "bond_intact": (("snapshot", "bond"), [s.intact for s in snapshots]),
        **field_data(scene),
    }
