"""Cohesive interface: energy of rigid openings, unloading, closing contact, conservation."""

import numpy as np
import pytest
from scipy.optimize import brentq

from orthocut.kernels.laws import cohesive
from orthocut.kernels.mpm import interface as pairs
from orthocut.kernels.mpm import layout
from orthocut.kernels.mpm.frame import Frame
from orthocut.mpm.laws import cohesion_of
from orthocut.params.cohesive import CohesiveZone

ZONE = CohesiveZone()
RULES = ("area", "dissipated", "coupled")
ZONES = [CohesiveZone(law=law, failure_criterion=rule) for law in ("cubic", "triangular") for rule in RULES]
CELL = 1e-4
FRAME = Frame(-5 * CELL, -5 * CELL, CELL, 1 / CELL, 15, 11, -1, 1e-12, 0.0, 1e-8, 0.0)
NODES = FRAME.count_x * FRAME.count_y
AREA = CELL / 2


class Interface:
    """One pair between two bodies that fill all nodes."""

    def __init__(self, zone=ZONE):
        self.cohesion = cohesion_of(zone)
        self.state = np.zeros((pairs.INTERFACE_ROWS, 1))
        self.state[pairs.UPPER_X] = self.state[pairs.LOWER_X] = 0.3 * CELL
        self.state[pairs.NORMAL_Y] = 1.0
        self.state[pairs.ALIVE] = self.state[pairs.PRESENT] = 1.0
        self.closing = np.zeros(NODES, dtype=np.int64)
        self.normal = np.zeros((NODES, 2))
        self.slot = np.full(NODES, -1, dtype=np.int64)
        self.work = 0.0
        self.tip = 3 * CELL

    def bodies(self, chip_velocity=(0.0, 0.0)):
        chip, base = np.zeros((NODES, layout.NODE)), np.zeros((NODES, layout.NODE))
        chip[:, layout.NM] = base[:, layout.NM] = 1e-5
        chip[:, layout.NVX], chip[:, layout.NVY] = chip_velocity
        chip[:, layout.NPX], chip[:, layout.NPY] = 1e-5 * chip[:, layout.NVX], 1e-5 * chip[:, layout.NVY]
        return chip.ravel(), base.ravel()

    def pull(self, chip, base):
        return pairs.pull_together(
            self.state, 0, chip, base, self.closing, self.normal, self.slot, self.cohesion, 1.0, self.tip, FRAME
        )

    def open(self, direction, distance, steps=2000):
        """Move the upper copy by a distance along a direction; sum the work done on the tractions."""
        velocity = np.array(direction) * distance / steps / FRAME.time_step
        for _ in range(steps):
            chip, base = self.bodies(velocity)
            self.pull(chip, base)
            self.work += pairs.move_pairs(self.state, 0, chip, base, FRAME)

    @property
    def alive(self):
        return bool(self.state[pairs.ALIVE, 0])


def needed_by_dissipation(zone, direction):
    """Work of a straight opening until the energies dissipated in both modes are the toughness [J/m^2]."""
    law = cohesion_of(zone).law

    def total(energy, opening):
        return sum(energy(law, component * opening) for component in direction)

    opening = brentq(lambda d: total(cohesive.energy_dissipated, d) - zone.toughness, 0.0, 1.1 * zone.opening_critical)
    return total(cohesive.energy_released, opening)


@pytest.mark.parametrize("zone", ZONES, ids=lambda zone: f"{zone.law}-{zone.failure_criterion}")
@pytest.mark.parametrize("angle", [0.0, 30.0, 60.0, 90.0])
def test_work_of_a_straight_opening(angle, zone):
    """Both modes have the same toughness, and a straight opening takes it in full, in each mode and in mixed mode.

    By dissipated energies a pair takes more in mixed mode: what it could give back is lost too when it fails.
    """
    interface = Interface(zone)
    direction = (np.sin(np.radians(angle)), np.cos(np.radians(angle)))
    interface.open(direction, 1.5 * zone.opening_critical)
    assert not interface.alive
    needed = needed_by_dissipation(zone, direction) if zone.failure_criterion == "dissipated" else zone.toughness
    assert interface.work / AREA == pytest.approx(needed, rel=3e-3)
    one = interface.state[pairs.MODE_ONE, 0]
    assert one == pytest.approx({0.0: 1.0, 90.0: 0.0}.get(angle, one), abs=1e-3)
    assert (0.5 < one < 1.0) if angle == 30.0 else True
    assert (0.0 < one < 0.5) if angle == 60.0 else True
    if zone.failure_criterion == "coupled":
        assert one == pytest.approx(np.cos(np.radians(angle)) ** 2)


@pytest.mark.parametrize("criterion", RULES)
def test_tractions_at_the_failure_of_a_mixed_opening(criterion):
    """Coupled modes leave nothing; the others drop what is left of the tractions."""
    zone = CohesiveZone(failure_criterion=criterion)
    interface = Interface(zone)
    last = 0.0
    while interface.alive:
        last = np.hypot(interface.state[pairs.TRACTION_X, 0], interface.state[pairs.TRACTION_Y, 0])
        interface.open((1.0, 1.0), 1e-3 * zone.opening_critical, steps=1)
        interface.pull(*interface.bodies())
    if criterion == "coupled":
        assert last < 1e-3 * zone.strength
    else:
        assert last > 0.1 * zone.strength


@pytest.mark.parametrize(
    ("criterion", "energy"), [("area", cohesive.energy_released), ("dissipated", cohesive.energy_dissipated)]
)
def test_failure_on_the_mixed_line(criterion, energy):
    """Openings in one mode, then in the other, until the energies of both add up to the toughness."""
    zone = CohesiveZone(failure_criterion=criterion)
    law = cohesion_of(zone).law
    interface = Interface(zone)
    interface.open((0, 1), 0.5 * zone.opening_critical)
    one, two, step = energy(law, 0.5 * zone.opening_critical), 0.0, 1e-3 * zone.opening_critical
    while one + two < 0.998 * zone.toughness:
        assert interface.alive
        interface.open((1, 0), step, steps=1)
        two = energy(law, interface.state[pairs.UPPER_X, 0] - interface.state[pairs.LOWER_X, 0])
        interface.pull(*interface.bodies())
    interface.open((1, 0), 5 * step, steps=5)
    assert not interface.alive
    assert interface.state[pairs.MODE_ONE, 0] == pytest.approx(one / zone.toughness, abs=5e-3)


def test_damage_of_one_mode_weakens_the_other_where_they_are_coupled():
    secants = {}
    for criterion in ("area", "coupled"):
        interface = Interface(CohesiveZone(failure_criterion=criterion))
        interface.open((0, 1), 0.6 * ZONE.opening_critical)
        interface.open((0, -1), 0.6 * ZONE.opening_critical)
        interface.open((1, 0), 0.1 * ZONE.opening_critical)
        interface.pull(*interface.bodies())
        secants[criterion] = interface.state[pairs.TRACTION_X, 0] / (0.1 * ZONE.opening_critical)
    law = cohesion_of(ZONE).law
    for criterion, peak in (("area", 0.1), ("coupled", 0.6)):
        expected = cohesive.traction_over_opening(law, peak * ZONE.opening_critical)
        assert secants[criterion] == pytest.approx(expected, rel=1e-6)


def test_unloading_returns_to_the_origin_along_a_line():
    interface = Interface()
    interface.open((0, 1), 0.6 * ZONE.opening_critical)
    chip, base = interface.bodies()
    interface.pull(chip, base)
    top = interface.state[pairs.TRACTION_Y, 0]
    interface.open((0, -1), 0.3 * ZONE.opening_critical)
    interface.pull(*interface.bodies())
    assert interface.state[pairs.TRACTION_Y, 0] == pytest.approx(top / 2, rel=1e-6)
    assert interface.alive


def test_tractions_balance_and_pull_the_bodies_together():
    interface = Interface()
    interface.open((0.5, 1), 0.3 * ZONE.opening_critical, steps=10)
    chip, base = interface.bodies()
    interface.pull(chip, base)
    chip, base = chip.reshape(NODES, -1), base.reshape(NODES, -1)
    for quantity in (layout.NFX, layout.NFY):
        assert chip[:, quantity].sum() == pytest.approx(-base[:, quantity].sum(), rel=1e-12)
    assert chip[:, layout.NFY].sum() < 0.0
    assert chip[:, layout.NFX].sum() < 0.0


def test_closed_interface_stops_approach_and_lets_separate():
    for speed, stopped in ((-1.0, True), (1.0, False)):
        interface = Interface()
        interface.state[pairs.UPPER_Y] = -1e-3 * CELL
        chip, base = interface.bodies((0.5, speed))
        count = interface.pull(chip, base)
        assert count == 6
        assert (interface.slot == -1).all()
        momentum = (chip + base).reshape(NODES, -1)[:, layout.NVY].sum()
        impulses = np.ones((NODES, 2))
        pairs.push_apart(chip, base, interface.closing, interface.normal, impulses, count, FRAME)
        lost = pairs.lost_in_closing(chip, base, interface.closing, impulses, count)
        at = interface.closing[0]
        assert (chip + base).reshape(NODES, -1)[:, layout.NVY].sum() == pytest.approx(momentum, rel=1e-12)
        assert chip[at + layout.NVX] == 0.5
        if stopped:
            assert chip[at + layout.NVY] == pytest.approx(base[at + layout.NVY])
            assert lost == pytest.approx(6 * 0.5 * 0.5e-5)
        else:
            assert chip[at + layout.NVY] == speed
            assert lost == 0.0


def test_failed_pair_keeps_the_bodies_apart_until_the_tool_has_passed_or_it_is_wide_open():
    interface = Interface()
    interface.state[pairs.ALIVE] = 0.0
    interface.state[pairs.UPPER_Y] = -1e-3 * CELL
    assert interface.pull(*interface.bodies()) == 6
    assert interface.state[pairs.TRACTION_Y, 0] == 0.0
    interface.tip = 0.0
    assert interface.pull(*interface.bodies()) == 0
    interface = Interface()
    interface.state[pairs.ALIVE] = 0.0
    interface.open((0, 1), 1.1 * CELL, steps=10)
    interface.pull(*interface.bodies())
    assert interface.state[pairs.PRESENT, 0] == 0.0


def test_open_interface_lists_no_node():
    interface = Interface()
    interface.open((0, 1), 0.1 * ZONE.opening_critical, steps=10)
    assert interface.pull(*interface.bodies()) == 0


@pytest.mark.parametrize(("mass", "alive"), [(2.0, True), (0.5, False), (0.0, False)])
def test_pair_without_material_to_pull_on_fails(mass, alive):
    """Nodes of less than the least mass do not move: a traction on them would act on the other body alone."""
    interface = Interface()
    interface.open((0, 1), 0.1 * ZONE.opening_critical, steps=10)
    chip, base = (nodes.reshape(-1, layout.NODE) for nodes in interface.bodies())
    chip[:, layout.NM] = mass * FRAME.mass_small
    interface.pull(chip.ravel(), base.ravel())
    assert interface.alive == alive
    assert (base[:, layout.NFY].sum() > 0.0) == alive
    assert base[:, layout.NFY].sum() == pytest.approx(-chip[:, layout.NFY].sum(), rel=1e-12)
