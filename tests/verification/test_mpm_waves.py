"""Waves in bodies of material points: frequencies, speeds and damping against closed forms (T2, T7)."""

import math

import numpy as np
import pytest
from bodies import ELASTIC, SPEED, YOUNG_PLANE, Bodies, rectangle
from scipy.optimize import curve_fit

from orthocut.kernels.mpm import layout

LENGTH = 0.1
WAVE_NUMBER = math.pi / LENGTH
NO_LATERAL_STRAIN = ELASTIC._replace(modulus_bulk=2 / 3 * 500e6, modulus_shear=500e6)
"""Poisson's ratio 0: a bar is exactly one-dimensional. Young's modulus is 1000 MPa."""
BAR_SPEED = 1000.0
AFFINE = (0.0, 0.9, 1.0)
CELLS = (8, 16, 32)


def standing_wave(cells, height=2, shift=0.0, speed=BAR_SPEED, lateral=0.0, solid=NO_LATERAL_STRAIN, **options):
    """Frequency [rad/s], decay rate [1/s] and time step of the first mode of a free bar over two periods."""
    cell = LENGTH / cells
    bar = Bodies(rectangle(shift, cells + shift, shift, height + shift, cell), cell=cell, solid=solid, **options)
    left, middle = shift * cell, (shift + height / 2) * cell
    bar.set_velocity(
        lambda x, y: (
            0.1 * np.cos(WAVE_NUMBER * (x - left)),
            0.1 * lateral * WAVE_NUMBER * (y - middle) * np.sin(WAVE_NUMBER * (x - left)),
        )
    )
    shape = bar.mass * np.cos(WAVE_NUMBER * (bar.place[0] - left))
    unit = speed * WAVE_NUMBER
    every = max(1, int(4 * math.pi / unit / bar.state.frame.time_step) // 200)
    times, amplitudes = [], []
    for _ in range(200):
        bar.run(every)
        times.append(unit * bar.time)
        amplitudes.append(bar.velocity[0] @ shape)
    times, amplitudes = np.array(times), np.array(amplitudes) / amplitudes[0]
    found, _ = curve_fit(
        lambda t, size, frequency, decay, phase: size * np.exp(-decay * t) * np.cos(frequency * t + phase),
        times,
        amplitudes,
        p0=[1, 1, 0.02, 0],
    )
    return found[1] * unit, found[2] * unit, bar.state.frame.time_step


@pytest.fixture(scope="module")
def waves():
    """Standing waves in bars: free ends inside of a cell without support, and on nodes with it."""
    return {
        (support, affine, cells): standing_wave(cells, shift=shift, support=support, affine=affine)
        for support, shift in ((0.0, 0.3), (0.1, 0.0))
        for affine in AFFINE
        for cells in CELLS
    }


def orders_of(errors):
    return np.log2(np.abs(np.array(errors[:-1]) / errors[1:]))


@pytest.mark.parametrize("affine", AFFINE)
@pytest.mark.parametrize("support", [0.0, 0.1])
def test_standing_wave_has_the_frequency_of_a_bar_to_second_order(waves, support, affine):
    """Exact: v = A cos(pi x/L) cos(2 pi f t) with f = c/(2L), c = sqrt(E/density)."""
    errors = [waves[support, affine, cells][0] / (BAR_SPEED * WAVE_NUMBER) - 1 for cells in CELLS]
    orders = orders_of(errors)
    print(f"support {support}, affine {affine}: errors of the frequency {np.array(errors)}, orders {orders}")
    assert (abs(orders - 2.0) < 0.1).all()
    assert abs(errors[-1]) < 1e-3


def test_standing_wave_is_of_second_order_with_support_and_surfaces_inside_of_cells():
    """Exact: as above, with loose nodes all along the bar."""
    runs = [standing_wave(cells, shift=0.3, support=0.1) for cells in CELLS]
    orders = orders_of([run[0] / (BAR_SPEED * WAVE_NUMBER) - 1 for run in runs])
    assert (orders > 1.5).all()


@pytest.mark.parametrize("affine", [0.0, 0.9])
@pytest.mark.parametrize("support", [0.0, 0.1])
def test_transfers_damp_a_standing_wave_at_their_own_rate(waves, support, affine):
    """Exact for long waves: amplitudes decay at the rate (1 - affine) 3/32 (k h)^2/dt.

    A point at a quarter of a cell spreads its momentum over its nodes with the variance 3/16 h^2, and gathers with the
    same. Both together take (1 - affine) 3/16 (k h)^2 of the velocity in each step, and half of that of the amplitude.
    """
    cells = CELLS[-1]
    _, decay, time_step = waves[support, affine, cells]
    expected = (1 - affine) * 3 / 32 * (WAVE_NUMBER * LENGTH / cells) ** 2 / time_step
    print(f"support {support}, affine {affine}: decay {decay:.1f}/s, expected {expected:.1f}/s")
    assert decay == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize("support", [0.0, 0.1])
def test_whole_gradients_keep_a_standing_wave(waves, support):
    """Exact: with affine = 1 nothing of order (k h)^2 is lost; less than a thousandth of the damping of PIC is left."""
    assert abs(waves[support, 1.0, 32][1]) < 1e-3 * waves[support, 0.0, 32][1]


@pytest.mark.parametrize("support", [0.0, 0.1])
def test_bar_of_the_papers_material_has_the_plane_strain_speed(support):
    """Exact: c = sqrt(E'/density), less Rayleigh's part for the lateral inertia, 1 + (nu' k H)^2/24."""
    speed, height, cells = math.sqrt(YOUNG_PLANE / 1000), 4, 64
    ratio = YOUNG_PLANE / (2 * ELASTIC.modulus_shear) - 1  # nu' = nu/(1 - nu)
    frequency, *_ = standing_wave(cells, height, speed=speed, lateral=ratio, support=support, solid=ELASTIC)
    slower = 1 + (ratio * WAVE_NUMBER * height * LENGTH / cells) ** 2 / 24
    assert frequency * slower / (speed * WAVE_NUMBER) == pytest.approx(1.0, abs=5e-4)


@pytest.mark.parametrize("affine", [0.0, 0.9])
def test_pressure_pulse_travels_at_1217_metres_a_second(affine):
    """Exact: sqrt((K + 4G/3)/density) where sides are too far away to be felt; the pulse is seen at two times."""
    cell, width = 1e-3, 6.0
    block = Bodies(rectangle(0, 80, 0, 60, cell), affine=affine)
    block.set_velocity(lambda x, y: (np.exp(-(((x - 32 * cell) / (width * cell)) ** 2)), 0 * y))
    x, y = block.place
    middle = (abs(y - 30 * cell) < 2 * cell) & (x > 32 * cell)
    seen = []
    for steps in (32, 24):
        block.run(steps)
        weight = block.state.field(layout.VX)[middle] ** 2
        seen.append((block.time, weight @ x[middle] / weight.sum()))
    (early, first), (late, second) = seen
    speed = (second - first) / (late - early)
    print(f"affine {affine}: {speed:.1f} m/s")
    assert pytest.approx(1217.0, abs=0.5) == SPEED
    assert speed == pytest.approx(SPEED, rel=0.004)
