"""Neo-Hookean solid with von Mises yielding against closed forms and its own energy."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from orthocut.kernels.laws.hardening import energy_plastic
from orthocut.kernels.laws.neo_hookean_j2 import energy_elastic, pressure_kirchhoff, update
from orthocut.mpm.laws import hardening_of
from orthocut.params.material import ElasticPlastic

PAPER = {name: ElasticPlastic(modulus_tangent=f"{name} MPa") for name in (0, 100)}


class Sample:
    """One material point that is deformed step by step."""

    def __init__(self, material):
        self.material = material
        self.hardening = hardening_of(material)
        self.deformation = np.eye(2)
        self.state = (1.0, 1.0, 0.0, 0.0)
        self.deviator = (0.0, 0.0, 0.0)

    def step(self, increment):
        (fxx, fxy), (fyx, fyy) = increment
        *state, sxx, syy, sxy = update.py_func(
            *self.state, fxx, fxy, fyx, fyy, self.material.modulus_shear, self.hardening
        )
        self.state, self.deviator = tuple(state), (sxx, syy, sxy)
        self.deformation = increment @ self.deformation
        return self

    def to(self, target, steps=400):
        """Deform to a gradient in equal increments."""
        start = self.deformation
        for k in range(1, steps + 1):
            goal = start + (np.asarray(target) - start) * k / steps
            self.step(goal @ np.linalg.inv(self.deformation))
        return self

    @property
    def kirchhoff(self):
        p = pressure_kirchhoff.py_func(np.linalg.det(self.deformation), self.material.modulus_bulk)
        sxx, syy, sxy = self.deviator
        return np.array([[sxx + p, sxy], [sxy, syy + p]])

    @property
    def cauchy(self):
        return self.kirchhoff / np.linalg.det(self.deformation)

    @property
    def strain_plastic(self):
        return self.state[3]

    @property
    def elastic_energy(self):
        bxx, byy, bxy, _ = self.state
        trace = bxx + byy + 1 / (bxx * byy - bxy**2)
        m = self.material
        return energy_elastic.py_func(np.linalg.det(self.deformation), trace, m.modulus_bulk, m.modulus_shear)

    @property
    def plastic_work(self):
        return energy_plastic(self.hardening, self.strain_plastic)


@pytest.mark.parametrize(
    ("tangent", "stretch", "xx", "yy", "strain"),
    [
        (0, 1.10, 108.70, 85.97, 0.0425),
        (100, 1.10, 111.31, 84.66, 0.0388),
        (0, 1.05, 63.71, 39.91, 0.0109),
        (100, 1.05, 64.41, 39.56, 0.0099),
    ],
)
def test_uniaxial_strain(tangent, stretch, xx, yy, strain):
    """Finite-strain values computed independently for the paper's material; stresses in MPa."""
    sample = Sample(PAPER[tangent]).to(np.diag([stretch, 1.0]))
    assert sample.cauchy[0, 0] / 1e6 == pytest.approx(xx, abs=0.02)
    assert sample.cauchy[1, 1] / 1e6 == pytest.approx(yy, abs=0.02)
    assert sample.strain_plastic == pytest.approx(strain, abs=1e-4)


@pytest.mark.parametrize("tangent", [0, 100])
def test_uniaxial_strain_at_small_strain(tangent):
    """Closed form of small-strain plasticity; the stresses are a thousandth of the paper's."""
    material = ElasticPlastic(stress_yield="25 kPa", modulus_tangent=f"{tangent} MPa")
    strain, shear, slope = 1e-4, material.modulus_shear, material.modulus_plastic
    sample = Sample(material).to(np.diag([1 + strain, 1.0]))
    plastic = (2 * shear * strain - 25e3) / (3 * shear + slope)
    stress = material.modulus_bulk * strain + 2 / 3 * (25e3 + slope * plastic)
    assert sample.strain_plastic == pytest.approx(plastic, rel=1e-3)
    assert sample.cauchy[0, 0] == pytest.approx(stress, rel=3e-4)


def test_simple_shear_yields_at_the_von_mises_stress():
    shear = 25 / math.sqrt(3)
    before = Sample(PAPER[0]).to([[1.0, 0.0383], [0.0, 1.0]])
    after = Sample(PAPER[0]).to([[1.0, 0.0390], [0.0, 1.0]])
    assert before.strain_plastic == 0.0
    assert after.strain_plastic > 0.0
    assert Sample(PAPER[0]).to([[1.0, 0.2], [0.0, 1.0]]).kirchhoff[0, 1] / 1e6 == pytest.approx(shear, rel=0.02)


def test_plane_strain_tension_reaches_its_limit():
    """A perfectly plastic strip that is free to contract carries 2/sqrt(3) times the yield stress."""
    stretch, sample = 1.0, Sample(PAPER[0])
    for _ in range(200):
        stretch *= 1.0005

        def lateral(height, base=sample, goal=stretch):
            trial = Sample(base.material)
            trial.deformation, trial.state = base.deformation, base.state
            return trial.step(np.diag([goal, height]) @ np.linalg.inv(base.deformation)).kirchhoff[1, 1]

        height = brentq(lateral, 0.8, 1.1)
        sample.step(np.diag([stretch, height]) @ np.linalg.inv(sample.deformation))
    assert sample.kirchhoff[0, 0] / 1e6 == pytest.approx(2 / math.sqrt(3) * 25, rel=1e-3)


def test_rigid_rotation_is_free_of_stress():
    angle = math.pi / 2 / 1000
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    sample = Sample(PAPER[0])
    for _ in range(1000):
        sample.step(turn)
    assert np.abs(sample.kirchhoff).max() < 1e-6 * sample.material.modulus_shear


def test_rotation_carries_the_stress_along():
    """After a stretch and a quarter turn the principal stresses have changed axes."""
    sample = Sample(PAPER[100]).to(np.diag([1.1, 1.0]))
    before = sample.kirchhoff
    angle = math.pi / 2 / 1000
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    strain = sample.strain_plastic
    for _ in range(1000):
        sample.step(turn)
    np.testing.assert_allclose(sample.kirchhoff, [[before[1, 1], 0], [0, before[0, 0]]], atol=1e-4 * before[0, 0])
    assert sample.strain_plastic == pytest.approx(strain, abs=1e-9)


def share_unaccounted(yield_stress, steps=2000):
    """Elastic energy plus plastic work over stress power, less one, on a path with yielding and turning."""
    sample = Sample(ElasticPlastic(stress_yield=f"{yield_stress} MPa", modulus_tangent="0 MPa"))
    work = 0.0
    for k in range(steps):
        angle = (k + 0.5) / steps
        turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
        change = turn @ np.array([[0.3, 0.8], [0.0, -0.3]]) @ turn.T / steps
        before = sample.kirchhoff
        sample.step(np.eye(2) + change)
        work += (0.5 * (before + sample.kirchhoff) * change).sum()
    assert sample.plastic_work > sample.elastic_energy
    return (sample.elastic_energy + sample.plastic_work) / work - 1


def test_work_is_stored_or_dissipated():
    """The flow rule dissipates the yield stress times the plastic strain up to a part of order (stress/modulus)^2."""
    soft, stiff = share_unaccounted(12.5), share_unaccounted(25.0)
    assert abs(stiff) < 4e-3
    assert stiff / soft == pytest.approx(4.0, rel=0.15)


def test_determinant_of_elastic_strain_stays_one_through_plastic_flow():
    sample = Sample(PAPER[0]).to([[1.0, 1.5], [0.0, 1.0]], steps=3000)
    bxx, byy, bxy, _ = sample.state
    norm = sample.material.stress_yield * math.sqrt(2 / 3)
    sxx, syy, sxy = sample.deviator
    szz = -sxx - syy
    assert math.sqrt(sxx**2 + syy**2 + szz**2 + 2 * sxy**2) == pytest.approx(norm, rel=1e-6)
    # the deviator follows from the stored tensor only if its determinant, with bzz = 1/(bxx byy - bxy^2), is one
    bzz = 1 / (bxx * byy - bxy**2)
    third = (bxx + byy + bzz) / 3
    assert sample.material.modulus_shear * (bzz - third) == pytest.approx(szz, abs=1e-8 * norm)


def test_dilation_in_one_large_increment_keeps_the_isochoric_part():
    """The series for det(f)^(-2/3) is exact to third order in the change of volume."""
    stretch = 1.02
    sample = Sample(ElasticPlastic(stress_yield="100 GPa")).step(np.diag([stretch, stretch]))
    exact = stretch**2 / stretch ** (4 / 3)
    assert sample.state[0] == pytest.approx(exact, abs=3e-6)
    assert sample.state[1] == pytest.approx(exact, abs=3e-6)


def test_stress_stays_on_the_yield_surface_where_elastic_strains_are_of_order_one():
    """A yield stress of three times the shear modulus, and steps as those of a cut."""
    sample = Sample(ElasticPlastic(stress_yield="1128 MPa", modulus_tangent="0 MPa"))
    limit = math.sqrt(2 / 3) * sample.material.stress_yield
    for target in ([[1.0, 2.0], [0.0, 1.0]], [[1.8, 2.0], [0.0, 0.6]], [[0.8, -1.0], [0.3, 0.9]]):
        sample.to(target, steps=300)
        bxx, byy, bxy, _ = sample.state
        bzz = 1 / (bxx * byy - bxy**2)
        third = (bxx + byy + bzz) / 3
        deviator = np.array([bxx - third, byy - third, bzz - third, math.sqrt(2) * bxy])
        stress = sample.material.modulus_shear * np.linalg.norm(deviator)
        assert sample.strain_plastic > 0.1
        assert stress < limit * (1 + 1e-3)
