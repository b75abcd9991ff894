"""Every figure from synthetic runs: labels with units, holes, whole files, the same bytes again."""

import itertools
import json
import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from matplotlib.text import Text
from synthetic import dem_cut_run, dem_test_run, mpm_run

from orthocut.figures import registry
from orthocut.figures.save import save
from orthocut.io.collect import collect
from orthocut.io.datasets import failed
from orthocut.params.case import validate

COARSE = {"numerics.points_per_depth": 3}
BIG = {"packing.radius_min": "40 um"}
SWEEPS = {f"nairn2015_fig{number}" for number in ("08", 10, 11, 12, 13, 14, 15, 16)} | {"nairn2015_claims"}
ALONE = {f"nairn2015_fig{number}" for number in ("02", "04", "05", 17)} | {"energy_balance", "show"}
DISTINCT = list({module: name for name, module in reversed(registry.FIGURES.items())}.values())
"""One figure of each module."""
UNITLESS = {
    "depth of cut, surface",
    "depth of cut, force",
    "depth of cut, surface, force",
    "claim of the paper",
    "cut",
    "parameter",
}


GROOVED = {"grooves": {}}
COMMON = {"error_target": 0.01}


def glass(depth, change, seed):
    return dem_cut_run(snapshots=2, cracks=8, **BIG, cut_depth=f"{depth} mm", **change, **{"packing.seed": seed})


def runs_for(name):
    if name in ALONE:
        return [mpm_run(snapshots=2, **COARSE)]
    if name == "nairn2015_fig03a":
        return [mpm_run(snapshots=0, base_ratio=depth) for depth in (1, 2, 3, 5)]
    if name == "nairn2015_fig09":
        return [
            mpm_run(snapshots=2, cut_depth=depth, touching=touching, **COARSE)
            for depth, touching in (("1 mm", 1), ("1.5 mm", 1), ("2 mm", 0), ("3 mm", 0))
        ]
    if name in ("nairn2015_regimes", "nairn2015_transition"):
        return [
            mpm_run(snapshots=0, cut_depth=depth, touching=touching, modulus_tangent="0 MPa", notch_ratio=notch, **size)
            for notch in (2, 8)
            for size in ({"points_per_depth": 4}, {"points_per_depth": 6})
            for depth, touching in (("1 mm", 1), ("2 mm", notch == 2), ("3 mm", 0))
        ]
    if name == "nairn2015_convergence":
        return [
            mpm_run(snapshots=0, force=5e3 + 9e3 / points, points_per_depth=points, **{field: value})
            for points in (4, 6, 9)
            for field, value in (("affine", 0), ("affine", 0.9), ("courant", 0.2), ("cut_speed", "2 m/s"))
        ]
    if name == "nairn2015_precision":
        changes = ({}, {"courant": 0.9}, {"cut_speed": "20 m/s"}, {"affine": 0})
        runs = [
            mpm_run(snapshots=0, force=5e3 + 9e3 / points, modulus_tangent=tangent, points_per_depth=points, **change)
            for tangent in ("0 MPa", "100 MPa")
            for points in (4, 6, 9)
            for change in changes
        ]
        return [registry.condense(name)(run.assign_attrs(steps=20_000)) for run in runs]
    if name == "nairn2015_accuracy":
        return [
            mpm_run(snapshots=0, force=5e3 + 9e3 / points, cut_depth=f"{depth} mm", points_per_depth=points, **COMMON)
            for depth in (0.5, 0.9, 2)
            for points in (5, 8, *((12, 16) if depth == 0.9 else ()))
        ]
    if name == "nairn2015_touching":
        return [
            mpm_run(snapshots=0, touching=1, rake_angle=rake, friction=friction, points_per_depth=n)
            for rake in ("15 deg", "30 deg", "45 deg")
            for friction in (0, 0.3)
            for n in (4, 6, 9)
        ]
    if name == "nairn2015_robustness":
        extremes = ({}, {"cut_depth": "10 mm"}, {"rake_angle": "-30 deg"}, {"friction": 1}, {"strength": "160 MPa"})
        return [registry.condense(name)(mpm_run(snapshots=0, **extreme)) for extreme in extremes]
    if name == "nairn2015_fig03b":
        return [mpm_run(snapshots=0, force=5e3 + 9e3 / n, **{"numerics.points_per_depth": n}) for n in (4, 6, 9)]
    if name in SWEEPS:
        return [
            mpm_run(snapshots=0, cut_depth=depth, rake_angle=rake, touching=touching, modulus_tangent=tangent)
            for tangent in ("0 MPa", "100 MPa")
            for rake in ("15 deg", "30 deg")
            for depth, touching in (("0.5 mm", 1), ("2.5 mm", 0))
        ]
    if name == "yang2018_fig08":
        return [dem_test_run("dem_compression", **BIG), dem_test_run("dem_compression", **BIG, **{"packing.seed": 2})]
    if name in ("yang2018_table1", "yang2018_table2"):
        joints = ({}, {"joint.modulus": "80 GPa"})
        return [
            dem_test_run(kind, cracks=3, **BIG, **joint, **{"packing.seed": seed})
            for kind in ("dem_tension", "dem_compression")
            for joint in joints
            for seed in (1, 2)
        ]
    if name == "yang2018_toughness":
        cracked = [
            dem_test_run("dem_toughness", crack_ratio=ratio, **{"packing.radius_min": size, "packing.seed": seed})
            for size in ("20 um", "10 um")
            for ratio in (0.3, 0.5)
            for seed in (1, 2)
        ]
        return [*cracked, dem_test_run("dem_tension")]
    if name in ("yang2018_convergence", "yang2018_causes", "yang2018_precision", "yang2018_claims", "yang2018_table4"):
        changes = ({}, {"cut_speed": "0.5 m/s"}, {"joint.damping": 0.3}, {"joint.time_step_factor": 0.25})
        cuts = [glass(depth, surface, seed) for depth in (0.1, 0.2) for surface in ({}, GROOVED) for seed in (1, 2, 3)]
        cuts += [glass(0.1, change, seed) for change in changes[1:] for seed in (1, 2)]
        cuts += [glass(0.2, {"grooves": {"bottom_ratio": 0.5}}, seed) for seed in (1, 2)]
        tests = [dem_test_run(kind, cracks=3, **BIG) for kind in ("dem_tension", "dem_compression")]
        condense = registry.condense(name)
        return [condense(cut) if condense else cut for cut in cuts] + tests
    if name in ("yang2018_fig05", "yang2018_fig06", "yang2018_fig07"):
        return [dem_test_run("dem_tension", **BIG), dem_test_run("dem_tension", cracks=9, **BIG, **{"packing.seed": 2})]
    if name == "nairn2015_fig07":
        return []
    return [dem_cut_run(**BIG), dem_cut_run(cracks=30, **BIG, **{"packing.seed": 2, "grooves.width": "0.06 mm"})]


def drawn_axes(figure):
    return [ax for ax in figure.axes if ax.get_visible() and ax.axison]


@pytest.mark.parametrize("name", DISTINCT)
def test_axes_are_named_with_units(name):
    figure = registry.draw(name, collect(runs_for(name)))
    labels = [text for ax in drawn_axes(figure) for text in (ax.get_xlabel(), ax.get_ylabel()) if text]
    assert len(labels) >= 2
    for text in labels:
        assert re.search(r"\[.+\]$", text) or text in UNITLESS, text
    assert len(registry.caption(name)) > 40


@pytest.mark.parametrize("name", sorted(set(DISTINCT) - registry.WITHOUT_RUNS))
def test_failed_and_missing_runs_are_holes(name):
    good = runs_for(name)
    other = mpm_run(snapshots=0, cut_depth="4 mm") if name in SWEEPS else good.pop()
    some = collect([broken(other), *good])
    none = collect([broken(run) for run in (other, *good)])
    for dataset in (some, none):
        texts = [text.get_text() for text in texts_of(registry.draw(name, dataset))]
        assert any("diverged at last" in text for text in texts)
    registry.draw(name, collect([])).draw_without_rendering()


def broken(run):
    return failed(validate(json.loads(run.attrs["case"])), "diverged at last", 1.0)


def texts_of(figure):
    figure.draw_without_rendering()
    texts = [text for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip()]
    ticks = {tick for ax in figure.axes for axis in (ax.xaxis, ax.yaxis) for tick in axis.get_ticklabels()}
    return [text for text in texts if text not in ticks]


@pytest.mark.parametrize("name", DISTINCT)
def test_no_text_is_cut_off_or_lies_on_another(name):
    figure = registry.draw(name, collect(runs_for(name)))
    boxes = [(text.get_text(), text.get_window_extent()) for text in texts_of(figure)]
    for text, box in boxes:
        assert box.x0 > -1, text
        assert box.y0 > -1, text
        assert box.x1 < figure.bbox.x1 + 1, text
        assert box.y1 < figure.bbox.y1 + 1, text
    for (one, first), (other, second) in itertools.combinations(boxes, 2):
        width = min(first.x1, second.x1) - max(first.x0, second.x0)
        height = min(first.y1, second.y1) - max(first.y0, second.y0)
        assert min(width, height) < 2, (one, other)


@pytest.fixture(scope="module")
def all_kinds():
    tests = [dem_test_run(kind, cracks=3, **BIG) for kind in ("dem_tension", "dem_compression")]
    return collect([*tests, dem_cut_run(cracks=3, **BIG), mpm_run(snapshots=1, **COARSE)])


@pytest.mark.parametrize("name", DISTINCT)
def test_runs_of_other_kinds_do_no_harm(name, all_kinds):
    registry.draw(name, all_kinds).draw_without_rendering()


def test_cuts_of_one_particle_size_have_no_line_to_none():
    cuts = [mpm_run(snapshots=0, rake_angle=f"{angle} deg") for angle in (15, 30, 40)]
    registry.draw("nairn2015_fig03b", collect(cuts)).draw_without_rendering()


def test_cuts_of_depths_that_the_paper_lacks_have_nothing_to_compare_with():
    condense = registry.condense("yang2018_fig17")
    cuts = [dem_cut_run(**BIG, **{"cut_depth": "0.15 mm", "packing.seed": seed}) for seed in (1, 2, 3)]
    dataset = collect([condense(cut) if condense else cut for cut in cuts])
    registry.draw("yang2018_fig17", dataset).draw_without_rendering()


def test_a_force_that_changes_its_sign_is_left_out():
    runs = runs_for("yang2018_causes")
    for run in runs:
        if "joint_damping" in run and float(run["joint_damping"]) == 0.3:
            run["force_thrust_mean"] = -run["force_thrust_mean"]
    registry.draw("yang2018_causes", collect(runs)).draw_without_rendering()


@pytest.mark.parametrize("name", ["nairn2015_fig05", "nairn2015_fig07", "nairn2015_fig08", "yang2018_fig11"])
def test_files_are_whole_and_the_same_again(name, tmp_path):
    dataset = collect(runs_for(name))
    first = save(registry.draw(name, dataset), tmp_path / "a" / name)
    again = save(registry.draw(name, dataset), tmp_path / "b" / name)
    assert [path.name for path in first] == [f"{name}.png", f"{name}.svg"]
    for one, two in zip(first, again, strict=True):
        assert one.read_bytes() == two.read_bytes()
    assert sorted(path.name for path in (tmp_path / "a").iterdir()) == [f"{name}.png", f"{name}.svg"]
    words = "".join(ElementTree.parse(first[1]).getroot().itertext())
    assert "[" in words


def test_a_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    figure = registry.draw("nairn2015_fig07")
    png, svg = save(figure, tmp_path / "figure")
    before = png.read_bytes(), svg.read_bytes()
    whole = type(figure).savefig

    def break_in_the_middle(self, path, **options):
        whole(self, path, **options)
        if options["format"] == "svg":
            raise OSError("disk full")

    monkeypatch.setattr(type(figure), "savefig", break_in_the_middle)
    with pytest.raises(OSError, match="disk full"):
        save(figure, tmp_path / "figure")
    assert (png.read_bytes(), svg.read_bytes()) == before
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize("ending", ["png", "svg", "pdf"])
def test_an_ending_picks_the_kind_of_picture(ending, tmp_path):
    target = tmp_path / f"figure.{ending}"
    assert save(registry.draw("nairn2015_fig07"), target) == [target]
    assert list(tmp_path.iterdir()) == [target]


@pytest.mark.parametrize(
    "run",
    [mpm_run(snapshots=1, **COARSE), dem_cut_run(**BIG), dem_test_run("dem_tension", **BIG), mpm_run(snapshots=0)],
    ids=["mpm", "cut", "tension", "no snapshots"],
)
def test_a_single_run_can_be_shown(run):
    registry.draw("show", run).draw_without_rendering()


def test_force_and_depth_are_dimensionless_in_fig_8():
    dataset = collect(runs_for("nairn2015_fig08"))
    ax = registry.draw("nairn2015_fig08", dataset).axes[0]
    marks = sorted((float(bar.lines[0].get_xdata()[0]), float(bar.lines[0].get_ydata()[0])) for bar in ax.containers)
    wanted = sorted(
        zip(139.23 * dataset["cut_depth"].values, dataset["force_cutting_mean"].values / 2000.0, strict=True)
    )
    np.testing.assert_allclose(marks, wanted, rtol=1e-4)


def test_unknown_figure_is_named_with_the_known_ones():
    with pytest.raises(KeyError, match="nairn2015_fig04"):
        registry.draw("figure_of_speech")
