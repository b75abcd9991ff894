"""Kinds of joints: fractions, draws that belong to contacts, clear refusals, counts in results."""

import numpy as np
import pytest

from orthocut.dem.joint_kinds import BONDED, GAPPED, SLIT, contact_draws, draw_kinds
from orthocut.dem.packing import pack
from orthocut.dem.pairs import close_pairs
from orthocut.dem.setup import build
from orthocut.experiments import dem_tension
from orthocut.kernels.dem import layout
from orthocut.params.block import ConfigError
from orthocut.params.case import load

SMALL = {"packing.width": "0.3 mm", "packing.height": "0.6 mm"}


@pytest.fixture(scope="module")
def packed():
    return pack(load("dem_tension", {"packing.width": "0.5 mm", "packing.height": "0.5 mm"}).packing)


@pytest.fixture(scope="module")
def contacts(packed):
    """Positions of the discs and the pairs that touch."""
    return np.column_stack([packed.x, packed.y]), close_pairs(packed.x, packed.y, packed.radius)


def joint(**values):
    return load("dem_tension", values).joint


def test_draws_are_uniform_and_independent_of_their_neighbours(contacts):
    draws = contact_draws(*contacts)
    count = len(draws)
    assert count > 1500
    assert np.bincount((10 * draws).astype(int), minlength=10) == pytest.approx(count / 10, abs=4 * (count / 10) ** 0.5)
    assert np.corrcoef(draws[1:], draws[:-1])[0, 1] == pytest.approx(0, abs=4 / count**0.5)


def test_a_contact_keeps_its_draw_when_discs_are_taken_away_and_pairs_added(packed, contacts):
    places, pairs = contacts
    known = dict(
        zip(map(tuple, places[pairs].reshape(len(pairs), 4).tolist()), contact_draws(places, pairs), strict=True)
    )
    keep = packed.y < 0.4e-3
    fewer = places[keep]
    more = close_pairs(*fewer.T, packed.radius[keep], gap_ratio=0.2)
    found = dict(zip(map(tuple, fewer[more].reshape(len(more), 4).tolist()), contact_draws(fewer, more), strict=True))
    assert len(known.keys() & found.keys()) > 1000
    assert all(known[contact] == found[contact] for contact in known.keys() & found.keys())


def test_fractions_are_met_and_a_change_moves_few_joints(contacts):
    before, after = (draw_kinds(*contacts, joint(fraction_slit=slit, fraction_gapped=0.3)) for slit in (0.1, 0.12))
    count = len(before)
    assert np.bincount(before) / count == pytest.approx([0.6, 0.3, 0.1], abs=4 * (0.25 / count) ** 0.5)
    changed = before != after
    assert 0 < changed.sum() / count < 0.04
    assert (before[changed] == BONDED).all()
    assert (after[changed] == SLIT).all()


def test_all_joints_are_bonded_by_default_and_none_where_the_fractions_add_to_one(contacts):
    assert (draw_kinds(*contacts, joint()) == BONDED).all()
    loose = draw_kinds(*contacts, joint(fraction_slit=0.4, fraction_gapped=0.6))
    assert set(loose.tolist()) == {SLIT, GAPPED}


def test_installed_joints_have_the_stated_faces_and_gaps(packed):
    case = joint(fraction_gapped=0.5, gapped_opening=0.02, radius_multiplier=0.8, gap_ratio=0.1)
    scene = build(packed.x, packed.y, packed.radius, case)
    first, second = (part // layout.ROW for part in (scene.joints.first, scene.joints.second))
    smaller = np.minimum(packed.radius[first], packed.radius[second])
    apart = np.hypot(*(scene.places[second] - scene.places[first]).T)
    gapped = scene.joints.kind == GAPPED
    assert apart - scene.joints.distance == pytest.approx(np.where(gapped, 0.02 * smaller, 0.0), abs=1e-18)
    surfaces = apart - packed.radius[first] - packed.radius[second]
    assert 0.09 < (surfaces / smaller).max() <= 0.1
    state = scene.joints.state.reshape(-1, layout.FIELDS // layout.LANES, layout.LANES)
    half = state[:, layout.HALF_LENGTH // layout.LANES].ravel()[scene.joints.place]
    assert half == pytest.approx(0.8 * smaller)
    assert (scene.joints.broken[scene.joints.place // layout.LANES] == gapped).all()


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"fraction_slit": 1.2}, r"joint\.fraction_slit = 1\.2: .*allowed: 0 to 1"),
        ({"fraction_slit": -0.1}, r"joint\.fraction_slit = -0\.1: .*allowed: 0 to 1"),
        ({"fraction_slit": 0.6, "fraction_gapped": 0.5}, r"fraction_slit = 0\.6 and .* are 1\.1 together .*up to 1"),
        ({"gapped_opening": 0.01}, r"gapped_opening = 0\.01 is of no use .*fraction_gapped above 0"),
        ({"gap_ratio": 0.5}, r"joint\.gap_ratio = 0\.5: .*allowed: 0 to 0\.3"),
        ({"radius_multiplier": 0.0}, r"joint\.radius_multiplier = 0\.0: .*allowed: 0\.1 to 1"),
    ],
)
def test_impossible_fractions_are_refused_with_what_is_allowed(values, message):
    with pytest.raises(ConfigError, match=message):
        joint(**values)


def test_result_counts_kinds_and_shows_joints_that_were_never_bonded():
    values = {**SMALL, "strain_max": 1e-5, "fraction_slit": 0.2, "fraction_gapped": 0.1}
    run = dem_tension.simulate(load("dem_tension", values), lambda fraction: None)
    kinds = run.bond_kind.values
    assert int(run.bonds_slit) == (kinds == SLIT).sum() > 0.15 * len(kinds)
    assert int(run.bonds_gapped) == (kinds == GAPPED).sum() > 0.05 * len(kinds)
    assert int(run.bond_count) == len(kinds)
    assert np.array_equal(run.bond_intact.values[0] == 1, kinds == BONDED)
    assert int(run.cracks_tension_total + run.cracks_shear_total) == 0
