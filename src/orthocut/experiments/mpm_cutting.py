"""Orthogonal cut of a ductile strip along a cohesive path (Nairn 2015)."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import xarray as xr

from orthocut.io.checkpoint import Checkpoint, packed, unpacked
from orthocut.io.datasets import build
from orthocut.kernels.mpm import interface, layout, step
from orthocut.measure.chip import shape
from orthocut.measure.guard import Diverged
from orthocut.measure.points import snapshot
from orthocut.measure.steady import block_mean, is_known, steady_from
from orthocut.mpm import setup
from orthocut.mpm.solver import Solver
from orthocut.mpm.state import State
from orthocut.params.mpm import LEAST_WINDOW, MpmCutting

SAMPLES = 500
"""Output intervals of a run."""
CLOSURE_LIMIT = 0.05
"""Share of the tool's work that may remain unaccounted for after a travel of one depth of cut; the run stops beyond."""
GAIN_LIMIT = 0.05
"""Share of the tool's work that transfers and contact may make, after the same travel; the run stops beyond."""
MOMENTUM_LIMIT = 0.05
"""Share of the tool's mean impulse on an output interval by which the momentum of the points may change without a
force on them; the run stops beyond. Ordinary cuts keep to 1e-5."""
WEIGHED = 50
"""Output intervals from one in which momentum is watched to the next; a look costs a twentieth of an interval."""
ROUNDING = 1e-9
"""Share of the momentum of the whole workpiece at the speed of the tool that is taken for rounding."""
TOUCHING_CELLS = 1.5
"""Mean distance from tool tip to crack tip below which the tool touches, in cells; contact reaches 1.25 cells ahead."""

_IMPULSES = {
    "force_cutting_chip": step.CHIP_X,
    "force_thrust_chip": step.CHIP_Y,
    "force_cutting_base": step.BASE_X,
    "force_thrust_base": step.BASE_Y,
    "reaction_cutting": step.CLAMP_X,
    "reaction_thrust": step.CLAMP_Y,
}
_ENERGIES = {
    "work_tool": step.WORK,
    "energy_cohesive": step.COHESIVE,
    "energy_friction": step.FRICTION,
    "energy_contact": step.IMPACT,
    "energy_numerical": step.NUMERICAL,
    "energy_damping": step.DAMPED,
}


def simulate(
    case: MpmCutting,
    progress: Callable[[float], None] = lambda fraction: None,
    checkpoint: Checkpoint | None = None,
    snapshots: int = 6,
) -> xr.Dataset:
    """Run a cut.

    Parameters
    ----------
    case : MpmCutting
        The case.
    progress : callable
        Receives the fraction done.
    checkpoint : Checkpoint, optional
        Where the run goes on from, and leaves its state now and then.
    snapshots : int
        Snapshots to take, evenly spaced, the last one at the end.

    Returns
    -------
    xarray.Dataset
        Histories (forces are means over the output intervals), snapshots and steady-state means.

    Raises
    ------
    Diverged
        If energies stop being finite or do not balance, if momentum does not, if a point leaves the grid or the chip
        sinks into the base.
    """
    state = setup.build(case)
    start_x = state.field(layout.X)
    solver = Solver(state)
    frame = state.frame
    ends = [case.steps * sample // SAMPLES for sample in range(SAMPLES + 1)]
    face = state.totals[step.TIP]
    histories, shots = _restore(solver, checkpoint)
    wanted = {round(SAMPLES * k / snapshots) for k in range(1, snapshots + 1)}
    for sample in range(1 + len(histories.get("time", ())), SAMPLES + 1):
        before = state.totals.copy()
        steps = ends[sample] - ends[sample - 1]
        weighed = sample % WEIGHED == 0 and before[step.TIME] > state.wedge.ramp_time
        kept = solver.momentum_open if weighed else None
        solver.advance(steps)
        record = _sample(solver, before, steps * frame.time_step, face)
        _check(solver, record, case)
        if kept is not None:
            _check_momentum(solver, kept, record, steps * frame.time_step, case)
        for name, value in record.items():
            histories.setdefault(name, []).append(value)
        if sample in wanted:
            _shoot(state, shots)
        if case.error_target and _enough(case, histories):
            if snapshots and sample not in wanted:
                _shoot(state, shots)
            break
        progress(sample / SAMPLES)
        if checkpoint:
            checkpoint.offer(lambda: _state(solver, histories, shots))
    progress(1.0)
    arrays = {name: np.array(values) for name, values in histories.items()}
    data = {name: (("sample",), values) for name, values in arrays.items()}
    data |= {name: ((), value) for name, value in _results(case, solver, arrays, start_x).items()}
    if snapshots:
        for name, (dims, _) in snapshot(state).items():
            data[name] = (("snapshot", *dims), np.stack(shots[name]))
        data["point_half_width"] = ((), frame.half_point * frame.cell)
    dataset = build(case, "Orthogonal cut with material points", data, {"time": data.pop("time")})
    dataset.attrs |= {
        "particles": state.point_count,
        "steps": ends[len(histories["time"])],
        "time_step_s": frame.time_step,
        "cell_m": frame.cell,
    }
    return dataset


Histories = dict[str, list[float]]
Shots = dict[str, list[np.ndarray]]


def _shoot(state: State, shots: Shots) -> None:
    """Add a snapshot."""
    for name, (_, values) in snapshot(state).items():
        shots.setdefault(name, []).append(values)


def _enough(case: MpmCutting, histories: Histories) -> bool:
    """Whether the steady cutting force is known as well as the case asks."""
    travel = np.array(histories["tool_travel"])
    window = _window(case, travel, np.array(histories["force_cutting"]))
    long = travel[-1] - travel[window][0] >= LEAST_WINDOW * case.cut_depth if window.any() else False
    return bool(long) and is_known(block_mean(np.array(histories["force_cutting"])[window]), case.error_target)


def _window(case: MpmCutting, travel: np.ndarray, force: np.ndarray) -> np.ndarray:
    """Samples that count for the steady state, as flags."""
    window = travel >= case.window_ratio * case.cut_depth
    if case.window == "detected" and window.any():
        window[: np.argmax(window) + steady_from(force[window])] = False
    return window


def _state(solver: Solver, histories: Histories, shots: Shots) -> dict[str, np.ndarray]:
    """All that a run needs to go on."""
    columns = {name: np.array(values) for name, values in histories.items()}
    frames = {name: np.stack(values) for name, values in shots.items()}
    return packed("solver", solver.freeze()) | packed("history", columns) | packed("shot", frames)


def _restore(solver: Solver, checkpoint: Checkpoint | None) -> tuple[Histories, Shots]:
    """Bring a solver to the last checkpoint, if there is one; return the histories and snapshots until then."""
    saved = checkpoint.restore() if checkpoint else None
    if saved is None:
        return {}, {}
    solver.thaw(unpacked("solver", saved))
    histories = {name: values.tolist() for name, values in unpacked("history", saved).items()}
    return histories, {name: list(values) for name, values in unpacked("shot", saved).items()}


def _sample(solver: Solver, before: np.ndarray, interval: float, face: float) -> dict[str, float]:
    """Values at the end of an output interval; forces are means over it, on the tool."""
    now = solver.state.totals
    bodies = solver.energies()
    elastic, plastic, kinetic = bodies.sum(axis=0).tolist()
    record = {"time": now[step.TIME], "tool_travel": face - now[step.TIP]}
    record |= {name: -(now[row] - before[row]) / interval for name, row in _IMPULSES.items()}
    record["force_cutting"] = record["force_cutting_chip"] + record["force_cutting_base"]
    record["force_thrust"] = record["force_thrust_chip"] + record["force_thrust_base"]
    record["tool_tip"] = now[step.TIP]
    record["crack_tip"] = solver.crack_tip
    record["crack_gap"] = record["tool_tip"] - record["crack_tip"]
    record |= {name: now[row] for name, row in _ENERGIES.items()}
    record |= {"energy_elastic": elastic, "energy_plastic": plastic, "energy_kinetic": kinetic}
    known = sum(value for name, value in record.items() if name.startswith("energy_"))
    record["work_plastic_base"] = float(bodies[layout.BASE, 1])
    record["energy_residual"] = record["work_tool"] - known
    return record


def _check(solver: Solver, record: dict[str, float], case: MpmCutting) -> None:
    """Stop a run whose numbers can no longer be trusted."""
    when = f"at a travel of {record['tool_travel'] / case.cut_depth:.2f} depths of cut"
    finer = f"try a smaller numerics.courant than {case.numerics.courant:g}"
    if not all(math.isfinite(value) for value in record.values()):
        raise Diverged(f"energies are no longer finite {when}; {finer}")
    if solver.sunken:
        raise Diverged(f"the chip sinks into the base {when}; try more numerics.points_per_depth")
    if solver.escaped:
        raise Diverged(f"a point crosses the {solver.escaped} edge of the grid {when}; try a smaller travel_ratio")
    if record["tool_travel"] <= case.cut_depth:
        return
    lost = record["energy_residual"] / record["work_tool"]
    if abs(lost) > CLOSURE_LIMIT:
        raise Diverged(f"{lost:.0%} of the tool's work is not accounted for {when}; {finer}")
    taken = (record["energy_numerical"] + record["energy_contact"]) / record["work_tool"]
    if taken < -GAIN_LIMIT:
        raise Diverged(f"transfers and contact make {-taken:.0%} of the tool's work {when}; {finer}")


def _check_momentum(
    solver: Solver, before: np.ndarray, record: dict[str, float], interval: float, case: MpmCutting
) -> None:
    """Stop a run whose points gain or lose momentum in an output interval without a force of tool or clamp.

    Before the end of the ramp damping takes some.
    """
    mass = float(solver.state.field(layout.MASS).sum())
    lost = float(np.abs(solver.momentum_open - before).max())
    mean = record["work_tool"] / record["tool_travel"] * interval
    if not lost <= MOMENTUM_LIMIT * abs(mean) + ROUNDING * mass * case.cut_speed:
        raise Diverged(
            f"momentum changes without a force, by {lost / abs(mean):.0%} of the tool's impulse, at a travel of "
            f"{record['tool_travel'] / case.cut_depth:.2f} depths of cut; try a smaller numerics.courant than "
            f"{case.numerics.courant:g}"
        )


def _results(case: MpmCutting, solver: Solver, arrays: dict[str, np.ndarray], start_x: np.ndarray) -> dict[str, float]:
    """Steady-state means over the window of travel, and the energy balance of the whole run."""
    window = _window(case, arrays["tool_travel"], arrays["force_cutting"])
    cutting, thrust, rubbing, gap = (
        block_mean(arrays[name][window]) for name in ("force_cutting", "force_thrust", "force_thrust_base", "crack_gap")
    )
    reach = TOUCHING_CELLS * solver.state.frame.cell
    pairs = solver.state.interface
    start = arrays["time"][window][0] if window.any() else math.inf
    deformation = np.stack(
        [solver.state.field(row) for row in (layout.FXX, layout.FXY, layout.FYX, layout.FYY)], axis=1
    )
    of_chip = solver.state.of_body(layout.CHIP)
    chip = shape(start_x[of_chip], deformation[of_chip], arrays["tool_tip"][-1], case.cut_depth, case.tool.rake_angle)
    failed = pairs[interface.FAILED_AT] >= start
    return {
        "force_cutting_mean": cutting.value,
        "force_cutting_error": cutting.error,
        "force_cutting_drift": cutting.drift,
        "force_thrust_mean": thrust.value,
        "force_thrust_error": thrust.error,
        "force_rubbing_mean": rubbing.value,
        "force_rubbing_error": rubbing.error,
        "window_start": arrays["tool_travel"][window][0] if window.any() else math.nan,
        "crack_gap_mean": gap.value,
        "touching": float(gap.value < reach) if math.isfinite(gap.value) else math.nan,
        "mode_one_fraction": float(pairs[interface.MODE_ONE, failed].mean()) if failed.any() else math.nan,
        "chip_thickness_ratio": chip.thickness_ratio,
        "angle_shear": chip.angle_shear,
        "shear_largest": chip.shear_largest,
        "energy_closure": arrays["energy_residual"][-1] / arrays["work_tool"][-1],
    }
