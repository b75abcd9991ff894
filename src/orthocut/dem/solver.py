"""The order of kernel calls in a step, and what happens between steps."""

from __future__ import annotations

from orthocut.kernels.dem.contacts import add_contact_forces, renew_contacts
from orthocut.kernels.dem.integrate import accelerate, count_strays, fastest, move, sum_reactions
from orthocut.kernels.dem.joint_order import keep_tidy
from orthocut.kernels.dem.joint_removal import remove_joints
from orthocut.kernels.dem.joints import add_joint_forces
from orthocut.kernels.dem.layout import SPEED_X, SPEED_Y
from orthocut.kernels.dem.walls import add_wall_forces, find_near_walls, move_walls
from orthocut.kernels.jit import jit, part

DONE, TOO_FAST, CROWDED = 0, 1, 2
"""How a run ended: all steps done; a disc above the speed limit; too many neighbours for the list."""

CHECK = 100
"""Steps between checks of the speeds and removals of joints whose faces have left each other."""


LOOK = 10
"""Most steps between looks at how far the discs have moved since the last search."""


@part
def lists_stale(scene):
    """Whether a disc or wall has moved so far since the last search that a pair could be missing from the lists.

    The lists hold until one has moved half the skin. They count as stale from two fifths on, and the next look is due
    before a disc of three times the largest speed has moved the rest.
    """
    clock = scene.clock
    if clock[1] < 0:
        return True
    if clock[0] < clock[3]:
        return False
    elapsed = (clock[0] + 1 - clock[1]) * scene.time_step
    limit = 0.4 * scene.skin
    speed = 3.0 * fastest(scene.velocity)
    for w in range(scene.walls.rows.shape[0]):
        speed_x, speed_y = scene.walls.rows[w, SPEED_X], scene.walls.rows[w, SPEED_Y]
        wall_speed = (speed_x * speed_x + speed_y * speed_y) ** 0.5
        speed = max(speed, wall_speed)
        if elapsed * wall_speed > limit:
            return True
    clock[3] = clock[0] + int(min(LOOK, 0.1 * scene.skin / (speed * scene.time_step + 1e-300)))
    return count_strays(scene.position, scene.reference, limit) > 0


@part
def renew_lists(scene):
    """Search for close pairs and for discs near walls; return the number of contacts or -1."""
    scene.reference[:] = scene.position
    scene.clock[1] = scene.clock[0] + 1
    scene.clock[2] += 1
    find_near_walls(scene.walls.start, scene.walls.disc, scene.walls.rows, scene.position, scene.radius, scene.skin)
    return renew_contacts(scene.contacts, scene.joints, scene.position, scene.radius, scene.skin, scene.grid)


@part
def step_once(scene):
    """One leap-frog step of the whole scene; return `DONE` or `CROWDED`."""
    dt, law, walls = scene.time_step, scene.law, scene.walls
    move(scene.position, scene.velocity, dt)
    move_walls(walls.rows, dt)
    if lists_stale(scene) and renew_lists(scene) < 0:
        return CROWDED
    add_joint_forces(
        scene.force, scene.joints, scene.cracks, scene.tally, scene.position, law, float(scene.clock[0] + 1)
    )
    add_contact_forces(
        scene.force, scene.contacts, scene.tally, scene.position, scene.velocity, scene.radius,
        law.modulus, law.stiffness_ratio, law.friction, dt,
    )  # fmt: skip
    add_wall_forces(
        scene.force, walls.rows, walls.shear, scene.tally, walls.start, walls.disc, scene.position, scene.velocity,
        scene.radius, law.stiffness_ratio, dt,
    )  # fmt: skip
    sum_reactions(scene.reaction, scene.tally, scene.force, scene.velocity, scene.driven, scene.group, dt)
    accelerate(scene.velocity, scene.force, scene.tally, scene.inverse_mass, law.damping, dt)
    scene.clock[0] += 1
    return DONE


@part
def too_fast(scene):
    """Whether a disc is above the speed limit or its velocity is not a number."""
    return not fastest(scene.velocity) < scene.speed_limit


@jit
def advance(scene, steps):
    """Do `steps` steps.

    Returns
    -------
    int
        `DONE`, or why the run stopped early; `TOO_FAST` also if the speeds are too high after the last step.
    """
    for _ in range(steps):
        if scene.clock[0] % CHECK == 0:
            if too_fast(scene):
                return TOO_FAST
            removed = remove_joints(scene.joints, scene.tally, scene.position, scene.radius, scene.law)
            if removed > 0:
                scene.clock[1] = -1
            keep_tidy(scene.joints, scene.law.elements)
        if step_once(scene) != DONE:
            return TOO_FAST if too_fast(scene) else CROWDED
    return TOO_FAST if too_fast(scene) else DONE
