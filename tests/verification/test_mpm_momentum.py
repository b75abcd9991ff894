"""Free bodies: momentum, angular momentum, rotation and mirror images (T3, T16, T17)."""

import math

import numpy as np
import pytest
from bodies import ELASTIC, PLASTIC, Bodies, rectangle

from orthocut.kernels.mpm import layout, step
from orthocut.mpm import setup
from orthocut.mpm.solver import Solver
from orthocut.params.case import load

CELL = 1e-3


def block(support, affine=0.9, solid=ELASTIC, shift=0.3):
    return Bodies(
        rectangle(shift, 6 + shift, shift, 4 + shift, CELL), cell=CELL, support=support, affine=affine, solid=solid
    )


def stir(body, size=3.0):
    """Velocities that deform a body in all ways; scale of the momentum that they hold."""
    body.set_velocity(
        lambda x, y: (size * np.sin(700 * x + 900 * y) - 2e3 * x, size * np.cos(1100 * x - 600 * y) - 1e3 * y)
    )
    return math.sqrt(2 * body.state.totals[step.KINETIC] * body.mass.sum())


@pytest.mark.parametrize("support", [0.0, 0.1])
def test_uniform_force_accelerates_a_body_as_a_whole(support):
    """Exact: all points fall with g, whatever the place of the surfaces in their cells."""
    body = block(support)

    def gravity(nodes, _):
        nodes[..., layout.NFY] -= 1000.0 * nodes[..., layout.NM]

    body.run(100, gravity)
    fall = body.momentum[1] / (-1000.0 * body.time * body.mass.sum())
    print(f"support {support}: falls with {fall:.6f} g")
    assert fall == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("support", [0.0, 0.1])
def test_free_body_keeps_its_momentum_while_it_deforms(support):
    """Exact: internal forces have no sum, but for nodes of a billionth of a cell's mass, which are left out."""
    body = block(support)
    scale = stir(body)
    before = body.momentum
    body.run(200)
    change = abs(body.momentum - before).max() / scale
    print(f"support {support}: momentum changes by {change:.1e} of its scale in 200 steps")
    assert change < 1e-8


@pytest.mark.parametrize("support", [0.0, 0.1])
def test_momentum_of_a_cut_is_the_impulse_of_tool_and_clamp(support):
    """Exact, with the feedback damping off: nodes hold what tool and clamp gave, to the mass of nodes left out."""
    short = {"points_per_depth": 4, "length_ratio": 8.0, "travel_ratio": 4.0, "window_ratio": 2.0}
    solver = Solver(setup.build(load("mpm", {**short, "support": support, "ramp_feedback": "0 mm^-2"})))
    solver.advance(3000)
    frozen, totals = solver.freeze(), solver.state.totals
    nodes = frozen["grids"][:, int(frozen["current"])].reshape(-1, layout.NODE).sum(0)
    for momentum, rows in (
        (layout.NPX, [step.CHIP_X, step.BASE_X, step.CLAMP_X]),
        (layout.NPY, [step.CHIP_Y, step.BASE_Y, step.CLAMP_Y]),
    ):
        missing = abs(nodes[momentum] - totals[rows].sum()) / abs(totals[step.CHIP_X])
        print(f"support {support}: {missing:.1e} of the tool's impulse is not accounted for")
        assert missing < 2e-6


@pytest.mark.parametrize("support", [0.0, 0.1])
def test_block_that_turns_by_ninety_degrees_comes_out_as_it_was(support):
    """Exact: a quarter turn in the time pi/(2 omega), no stress but that of the rotation, about density v^2.

    All of the velocity gradient is handed on; the rim moves at 0.25 m/s, and 1e-6 of the shear modulus is six times
    the stress of the rotation.
    """
    half = 4 * CELL
    body = Bodies(rectangle(-4, 4, -4, 4, CELL), cell=CELL, affine=1.0, support=support)
    rate = 0.25 / half
    body.set_velocity(lambda x, y: (-rate * y, rate * x))
    start, spin = body.place, body.spin
    body.run(round(math.pi / 2 / rate / body.state.frame.time_step))
    turned = np.array([[0, -1], [1, 0]]) @ start
    misplaced = np.abs(body.place - turned).max() / CELL
    stress = np.abs(body.stress()).max() / ELASTIC.modulus_shear
    change = body.spin / spin - 1
    print(f"support {support}: misplaced by {misplaced:.1e} cells, stress {stress:.1e} G, change of spin {change:.1e}")
    assert misplaced < 1e-2
    assert stress < 1e-6
    assert abs(change) < (1e-3 if support else 1e-5)


@pytest.mark.parametrize("shift", [0.0, 0.3])
def test_whole_gradients_keep_the_spin_of_a_step_and_pic_loses_the_spin_within_cells(shift):
    """Exact: with affine = 1 a rigid rotation passes through a step unchanged.

    PIC takes the inertia of the nodes about their points, 3/8 cell^2 per mass, from that of the block; what comes
    from the surfaces is a tenth of it.
    """
    kept = {}
    for affine in (0.0, 0.9, 1.0):
        body = Bodies(rectangle(-4 + shift, 4 + shift, -4 + shift, 4 + shift, CELL), cell=CELL, affine=affine)
        centre = shift * CELL
        body.set_velocity(lambda x, y, centre=centre: (centre - y, x - centre))
        inertia = body.mass @ ((body.place - centre) ** 2).sum(0)
        within = 3 / 8 * CELL**2 * body.mass.sum()
        before = body.spin
        body.run(1)
        kept[affine] = 1 - body.spin / before, (1 - affine) * within / (inertia + within)
    print(f"shift {shift}: (lost, expected) share of the spin in a step {kept}")
    assert abs(kept[1.0][0]) < 1e-14
    for affine in (0.0, 0.9):
        assert kept[affine][0] == pytest.approx(kept[affine][1], rel=0.1)
    assert kept[0.0][0] > 0.03


@pytest.mark.parametrize("support", [0.0, 0.1])
@pytest.mark.parametrize("mirror", [(-1, 1), (1, -1), (-1, -1)], ids=["x", "y", "both"])
def test_mirrored_body_moves_as_the_mirror_image(support, mirror):
    """Exact to round-off: 300 steps of a body that yields and bounces."""
    sides = np.array(mirror)[:, None]
    runs = []
    for sign in (np.ones((2, 1)), sides):
        place = rectangle(-3, 3, -2, 2, CELL) + CELL * np.array([[0.13], [0.21]])
        body = Bodies(sign * place, cell=CELL, support=support, solid=PLASTIC)

        def field(x, y, sign=sign):
            x, y = sign[0] * x, sign[1] * y
            return sign[0] * 20 * np.sin(700 * x + 900 * y), sign[1] * 30 * np.cos(1100 * x - 600 * y)

        body.set_velocity(field)
        body.run(300)
        runs.append(body)
    plain, image = runs
    assert plain.state.field(layout.EPS).max() > 0.01
    assert abs(plain.velocity).max() > 1.0
    np.testing.assert_allclose(sides * image.place, plain.place, atol=1e-12 * CELL)
    np.testing.assert_allclose(sides * image.velocity, plain.velocity, atol=1e-10)
