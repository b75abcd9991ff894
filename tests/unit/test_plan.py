"""Figures are drawn from sweeps of their own method."""

import pytest

from orthocut.params.block import ConfigError
from orthocut.plan import load_plan


def plan(tmp_path, figures):
    path = tmp_path / "s.yaml"
    sweeps = "{cut: {base: {kind: mpm}}, glass: {base: {kind: dem}}, pull: {base: {kind: dem_tension}}}"
    path.write_text(f"title: t\nsweeps: {sweeps}\nfigures: {figures}\n")
    return load_plan(path)


@pytest.mark.parametrize(
    ("figures", "words"),
    [
        (
            "{yang2018_table4: [glass, cut]}",
            r"yang2018_table4 = .*: cut is a sweep of mpm_cutting \(allowed: sweeps of dem_cutting, dem_tension, dem_c",
        ),
        ("{nairn2015_fig08: [pull]}", r"pull is a sweep of dem_tension \(allowed: sweeps of mpm_cutting\)"),
        ("{yang2018_fig99: [glass]}", r"figures.yang2018_fig99: no such figure; did you mean yang2018_"),
        ("{nairn2015_fig07: [cut]}", r"needs no sweeps"),
        ("{nairn2015_fig08: []}", r"needs one sweep or more"),
    ],
)
def test_figures_refuse_what_they_cannot_draw(tmp_path, figures, words):
    with pytest.raises(ConfigError, match=words):
        plan(tmp_path, figures)


def test_figures_take_their_own_method_and_others_any(tmp_path):
    found = plan(tmp_path, "{nairn2015_fig08: [cut], yang2018_table4: [glass], energy_balance: [cut, glass]}")
    kinds = {figure: [found.cases[key].kind for key in keys] for figure, keys in found.figures.items()}
    assert kinds == {
        "nairn2015_fig08": ["mpm_cutting"],
        "yang2018_table4": ["dem_cutting"],
        "energy_balance": ["mpm_cutting", "dem_cutting"],
    }
