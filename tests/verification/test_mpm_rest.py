"""Material far from the tool rests: the cut stays the same, and momentum and energy keep their balance."""

import numpy as np
import pytest

from orthocut.experiments.mpm_cutting import simulate
from orthocut.kernels.mpm import layout, step
from orthocut.mpm import setup
from orthocut.mpm.solver import Solver
from orthocut.params.case import load

CUT = {"points_per_depth": 5, "travel_ratio": 14.0, "window_ratio": 7.0, "length_ratio": 24.0}


@pytest.fixture(scope="module", params=["0 MPa", "100 MPa"])
def cuts(request):
    """The same cut, all moving and with rest."""
    base = {**CUT, "modulus_tangent": request.param}
    return [simulate(load("mpm", {**base, "reach_ratio": reach}), snapshots=0) for reach in (0.0, 8.0)]


def test_forces_stay(cuts):
    """Within two standard errors, up to 4 % for so coarse a cut; the study has finer ones."""
    moving, resting = cuts
    noise = float(np.hypot(moving.force_cutting_error, resting.force_cutting_error))
    assert noise < 0.04 * float(moving.force_cutting_mean)
    assert float(resting.force_cutting_mean) == pytest.approx(float(moving.force_cutting_mean), abs=2 * noise)
    assert float(resting.touching) == float(moving.touching)


def test_energies_keep_their_balance(cuts):
    """What the seams take is part of the numerical loss, and small."""
    _, resting = cuts
    assert abs(float(resting.energy_closure)) < 5e-3
    shares = [float(run.energy_numerical[-1] / run.work_tool[-1]) for run in cuts]
    assert shares[1] == pytest.approx(shares[0], abs=0.01)


def test_clamp_and_seams_carry_the_force_of_the_tool(cuts):
    late = slice(300, None)
    for run in cuts:
        reaction = float(run.reaction_cutting[late].mean())
        assert reaction == pytest.approx(-float(run.force_cutting[late].mean()), rel=0.02)


def test_material_put_to_rest_leaves_its_momentum_to_the_clamp():
    """Exact, after the ramp: the momentum of all points changes by the impulses of tool and clamp."""
    shaken = {"points_per_depth": 4, "reach_ratio": 4.0, "rake_angle": "-15 deg", "modulus_tangent": "0 MPa"}
    solver = Solver(setup.build(load("mpm", {**CUT, **shaken, "ramp_feedback": "0 mm^-2"})))
    solver.advance(8000)
    before, totals, asleep = solver.momentum_open, solver.state.totals.copy(), solver.freeze()["awake"][layout.BASE, 1]
    solver.advance(8000)
    assert solver.freeze()["awake"][layout.BASE, 1] < asleep
    change = abs(solver.momentum_open - before) / abs(solver.state.totals - totals)[[step.CHIP_X, step.CHIP_Y]]
    print(f"{change} of the tool's impulse is not accounted for")
    assert change.max() < 1e-6


def test_steps_in_pieces_are_the_same_steps():
    """What is awake hangs on the place of the tool, not on how many steps are asked for at once."""
    case = load("mpm", {**CUT, "points_per_depth": 4, "reach_ratio": 4.0})
    states = []
    for piece in (4000, 250):
        solver = Solver(setup.build(case))
        for _ in range(16000 // piece):
            solver.advance(piece)
        states.append(solver.freeze())
    assert states[0]["awake"][layout.BASE, 1] < solver.state.blocks[layout.BASE, 1]
    for name, values in states[0].items():
        np.testing.assert_array_equal(values, states[1][name])
