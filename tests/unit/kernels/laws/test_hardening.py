"""Hardening laws: the return to the yield surface, the plastic work, a path against scipy's integration."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from orthocut.kernels.jit import jit
from orthocut.kernels.laws.hardening import Elastic, Linear, Ludwik, Voce, energy_plastic, multiplier
from orthocut.kernels.laws.neo_hookean_j2 import update
from orthocut.params.material import ElasticPlastic

SHEAR = ElasticPlastic().modulus_shear
LAWS = [
    Linear(25e6, 0.0),
    Linear(25e6, 111e6),
    *(Ludwik(25e6, modulus, exponent) for modulus in (1e6, 50e6, 1e9) for exponent in (0.05, 0.3, 1.0)),
    *(Voce(25e6, limit, strain) for limit in (26e6, 50e6, 1e9) for strain in (1e-3, 0.1, 10.0)),
]


def named(law):
    return "-".join([type(law).__name__, *(f"{value:g}" for value in law)])


def stress_yield(law, strain):
    match law:
        case Linear():
            return law.stress_yield + law.modulus_plastic * strain
        case Ludwik():
            return law.stress_yield + law.modulus * strain**law.exponent
        case Voce():
            return law.stress_saturation - (law.stress_saturation - law.stress_yield) * np.exp(-strain / law.strain)


@jit
def multipliers(law, norms, shear, strains, result):
    for i in range(norms.size):
        result[i] = multiplier(law, norms[i], shear, strains[i])


def increments(law, excess):
    """Increments of plastic strain after trial stresses that exceed the yield stress by `excess`, from many states."""
    before = np.repeat([0.0, 1e-12, 1e-6, 1e-3, 0.02, 0.3, 2.0, 10.0], excess.size)
    trial = stress_yield(law, before) + np.tile(excess, 8)
    result = np.empty_like(trial)
    multipliers(law, math.sqrt(2 / 3) * trial, SHEAR, before, result)
    return before, trial, math.sqrt(2 / 3) * result


@pytest.mark.parametrize("law", LAWS, ids=named)
def test_stress_returns_to_the_yield_surface(law):
    """After increments of up to 5 % of strain."""
    before, trial, change = increments(law, 3 * SHEAR * np.geomspace(1e-9, 0.05, 60))
    target = stress_yield(law, before + change)
    np.testing.assert_allclose(trial - 3 * SHEAR * change, target, rtol=1e-10, atol=0)
    assert (change >= 0.0).all()


@pytest.mark.parametrize("law", LAWS, ids=named)
def test_no_flow_below_the_yield_stress(law):
    _, trial, change = increments(law, -np.geomspace(1e-3, 0.99, 20) * 25e6)
    assert (trial > 0.0).all()
    assert (change == 0.0).all()
    assert multiplier(law, 0.0, SHEAR, 0.0) == 0.0


@pytest.mark.parametrize("law", [Linear(25e6, 111e6), Ludwik(25e6, 50e6, 0.3), Voce(25e6, 50e6, 0.1)], ids=named)
@pytest.mark.parametrize("strain", [0.0, 0.01, 0.5, 5.0])
def test_plastic_work_is_the_integral_of_the_yield_stress(law, strain):
    area, _ = quad(lambda eps: stress_yield(law, eps), 0, strain)
    assert energy_plastic(law, strain) == pytest.approx(area, rel=1e-8)


def stretch_and_stress(law, strain_plastic):
    """Stretch and deviatoric stress in uniaxial strain at a plastic strain, by quadrature along the yield surface.

    The isochoric elastic strain is diag(a, 1/sqrt(a), 1/sqrt(a)) and the equivalent stress G (a - 1/sqrt(a)). The flow
    rule takes trace * d(eps) from d(a - 1/sqrt(a)), to which a stretch adds 4/3 (a + 1/(2 sqrt(a))) d(log stretch).
    """

    def elastic(eps):
        ratio = stress_yield(law, eps) / SHEAR
        return brentq(lambda a: a - a**-0.5 - ratio, 1.0, 10.0, xtol=1e-15)

    def share(eps):
        a = elastic(eps)
        return 0.75 * (a + 2 * a**-0.5) / (a + 0.5 * a**-0.5)

    plastic, _ = quad(share, 0, strain_plastic, epsrel=1e-10)
    return math.exp(0.75 * math.log(elastic(strain_plastic)) + plastic), 2 / 3 * stress_yield(law, strain_plastic)


@pytest.mark.parametrize(
    "law",
    [Linear(25e6, 0.0), Linear(25e6, 111e6), Ludwik(25e6, 50e6, 0.3), Ludwik(25e6, 90e6, 0.1), Voce(25e6, 60e6, 0.02)],
    ids=named,
)
@pytest.mark.parametrize("strain_plastic", [1e-3, 0.05])
def test_uniaxial_strain_follows_the_integral(law, strain_plastic):
    stretch, stress = stretch_and_stress(law, strain_plastic)
    state, steps = (1.0, 1.0, 0.0, 0.0), 1000
    growth = stretch ** (1 / steps)
    for _ in range(steps):
        *state, sxx, syy, sxy = update.py_func(*state, growth, 0.0, 0.0, 1.0, SHEAR, law)
    assert state[3] == pytest.approx(strain_plastic, rel=2e-3)
    assert sxx == pytest.approx(stress, rel=1e-4)
    assert syy == pytest.approx(-0.5 * stress, rel=1e-4)
    assert sxy == 0.0


def test_elastic_material_never_yields():
    state, steps, stretch = (1.0, 1.0, 0.0, 0.0), 200, 1.3
    growth = stretch ** (1 / steps)
    for _ in range(steps):
        *state, sxx, _, _ = update.py_func(*state, growth, 0.0, 0.0, 1.0, SHEAR, Elastic())
    a = stretch ** (4 / 3)
    assert state[3] == 0.0
    assert sxx == pytest.approx(2 / 3 * SHEAR * (a - a**-0.5), rel=1e-5)
    assert energy_plastic(Elastic(), 0.0) == 0.0
