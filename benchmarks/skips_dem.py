"""Work of a cut of glass that is skipped: pairs of scenes that differ in the skip alone."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from skip import Skip

from orthocut.dem.packing import pack
from orthocut.dem.solver import CHECK, advance, step_once
from orthocut.dem.state import Scene
from orthocut.experiments.dem_cutting import make_scene
from orthocut.kernels.dem.joint_order import NEEDLESS, sort_joints
from orthocut.kernels.dem.layout import SPEED_X, TIP_X
from orthocut.kernels.jit import jit
from orthocut.measure.dem_energy import energies
from orthocut.params.case import validate

CASE = {
    "kind": "dem_cutting",
    "cut_speed": "2 m/s",
    "joint": {"modulus": "80 GPa", "strength_tensile": "73 MPa", "cohesion": "174 MPa", "damping": 0.1},
}
TRAVELLED = 0.75
"""Fraction of the travel after which a cut is measured."""
NEVER = -(10**12)
"""Needless work from which it takes for ever to the next sort of the joints."""
STEPS = 2000
"""Steps of a measurement."""


class Variant(NamedTuple):
    """A scene and what advances it."""

    scene: Scene
    advance: Callable[[Scene, int], object]
    steps: int = STEPS

    def cost(self) -> float:
        """CPU time of a step [ns]; the scene is left as it was."""
        before = _frozen(self.scene)
        start = time.thread_time()
        self.advance(self.scene, self.steps)
        spent = time.thread_time() - start
        self.scene.thaw(before)
        return 1e9 * spent / self.steps

    def velocities(self) -> np.ndarray:
        """Velocities one step later; the scene is left as it was."""
        before = _frozen(self.scene)
        self.advance(self.scene, 1)
        found = self.scene.velocity.copy()
        self.scene.thaw(before)
        return found


@jit
def step_plainly(scene, steps):
    """Steps without the checks between them."""
    for _ in range(steps):
        step_once(scene)


@jit
def step_looking(scene, steps):
    """Steps each of which looks how far all discs have moved."""
    for _ in range(steps):
        scene.clock[3] = 0
        step_once(scene)


@jit
def step_searching(scene, steps):
    """Steps each of which searches for neighbours."""
    for _ in range(steps):
        scene.clock[1] = -1
        step_once(scene)


def balance_each_step(scene: Scene, steps: int) -> None:
    """Steps each of which is followed by an energy balance."""
    for _ in range(steps):
        advance(scene, 1)
        energies(scene)


def skips() -> Iterator[Skip]:
    """All pairs, each ready to be measured."""
    case = validate(CASE)
    packed = pack(case.packing)

    def scene(like: Scene | None = None) -> Scene:
        made = make_scene(case, packed)
        if like is not None:
            made.thaw(_frozen(like))
        return made

    untidy = scene()
    untidy.joints.tidiness[NEEDLESS] = NEVER
    steps = int(TRAVELLED * case.travel / case.cut_speed / untidy.time_step) // CHECK * CHECK
    assert advance(untidy, steps) == 0
    late = scene(untidy)
    sort_joints(late.joints, late.law.elements)
    plain = Variant(late, step_plainly)
    yield _pair("general path for whole joints; removed joints", Variant(untidy, advance), Variant(late, advance))
    yield _pair("looks, in each step, how far discs have moved", Variant(late, step_looking), plain)
    yield _pair("search for neighbours in each step", Variant(late, step_searching, 200), plain)
    yield _pair("energy balance in each step", Variant(late, balance_each_step, 200), Variant(late, advance))

    away = scene()
    away.walls.rows[0, TIP_X] += case.packing.width
    away.walls.rows[0, SPEED_X] = 0.0
    bare = scene()
    bare = bare._replace(walls=bare.walls._replace(rows=bare.walls.rows[:0], shear=bare.walls.shear[:0]))
    for idle in (away, bare):
        idle.speeds[:, 0] = 1e-3 * (packed.x - packed.x.mean())
        assert advance(idle, CHECK) == 0
    yield _pair("tool that touches nothing", Variant(away, advance), Variant(bare, advance))


def _pair(what: str, without: Variant, skipping: Variant) -> Skip:
    def change() -> float:
        slow, fast = without.velocities(), skipping.velocities()
        return float(np.abs(slow - fast).max() / np.abs(slow).max())

    return Skip("glass", what, without.cost, skipping.cost, change)


def _frozen(scene: Scene) -> dict[str, np.ndarray]:
    return {name: values.copy() for name, values in scene.freeze().items()}
