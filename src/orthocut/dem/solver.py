"""The order of kernel calls in a step, and what happens between steps."""

from __future__ import annotations

from orthocut.kernels.dem.contacts import add_contact_forces, renew_contacts
from orthocut.kernels.dem.integrate import accelerate, farthest, fastest, move, sum_reactions
from orthocut.kernels.dem.joint_removal import remove_joints
from orthocut.kernels.dem.joints import add_joint_forces
from orthocut.kernels.dem.layout import SPEED_X, SPEED_Y
from orthocut.kernels.dem.walls import add_wall_forces, find_near_walls, move_walls
from orthocut.kernels.jit import jit, part

DONE, TOO_FAST, OUTRUN, CROWDED = 0, 1, 2, 3
"""How a run ended: all steps done; a disc above the speed limit; discs moved out of the list of neighbours between two
checks; too many neighbours for the list."""

CHECK = 10
"""Steps between checks of the list of neighbours."""
REMOVAL = 10 * CHECK
"""Steps between removals of joints whose faces have left each other."""


@part
def step_once(scene):
    """One leap-frog step of the whole scene."""
    dt, law, walls = scene.time_step, scene.law, scene.walls
    move(scene.position, scene.velocity, dt)
    move_walls(walls.rows, dt)
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


@part
def renew_lists(scene):
    """Search for close pairs and for discs near walls; return the number of contacts or -1."""
    scene.reference[:] = scene.position
    scene.clock[1] = scene.clock[0]
    scene.clock[2] += 1
    find_near_walls(scene.walls.start, scene.walls.disc, scene.walls.rows, scene.position, scene.radius, scene.skin)
    return renew_contacts(scene.contacts, scene.joints, scene.position, scene.radius, scene.skin, scene.grid)


@part
def keep_lists(scene):
    """Renew the lists if a disc or wall may leave them before the next check; return how the check ended."""
    speed = fastest(scene.velocity)
    if not speed < scene.speed_limit:
        return TOO_FAST
    stale = scene.clock[1] < 0
    if not stale:
        moved, second = farthest(scene.position, scene.reference)
        if moved + second > scene.skin:
            return OUTRUN
        ahead = CHECK * scene.time_step
        stale = moved + second + 4.0 * ahead * speed > scene.skin
        elapsed = (scene.clock[0] - scene.clock[1]) * scene.time_step
        for w in range(scene.walls.rows.shape[0]):
            wall_x, wall_y = scene.walls.rows[w, SPEED_X], scene.walls.rows[w, SPEED_Y]
            stale |= (elapsed + ahead) * (wall_x * wall_x + wall_y * wall_y) ** 0.5 > 0.5 * scene.skin
    if scene.clock[0] % REMOVAL == 0 and scene.cracks.count[0] > 0:
        stale |= remove_joints(scene.joints, scene.tally, scene.position, scene.radius, scene.law) > 0
    if stale and renew_lists(scene) < 0:
        return CROWDED
    return DONE


@jit
def advance(scene, steps):
    """Do `steps` steps.

    Returns
    -------
    int
        `DONE`, or why the run stopped early.
    """
    for _ in range(steps):
        if scene.clock[0] % CHECK == 0 or scene.clock[1] < 0:
            status = keep_lists(scene)
            if status != DONE:
                return status
        step_once(scene)
    return DONE
