"""Expansion of studies."""

import pytest

from orthocut.params.accuracy import evidence
from orthocut.params.block import ConfigError
from orthocut.params.case import load
from orthocut.params.identity import case_id
from orthocut.params.replicates import packings
from orthocut.params.study import Study, load_study


def study(**sweeps):
    return Study.model_validate({"title": "test", "sweeps": sweeps, "figures": {}})


def members(**sweep):
    return list(study(a=sweep).cases()["a"].values())


def test_product_runs_over_every_combination_last_axis_fastest():
    cases = members(
        base={"kind": "mpm"}, axes={"product": {"cut_depth": ["1 mm", "2 mm"], "rake_angle": ["15 deg", "30 deg"]}}
    )
    assert [(c.cut_depth, round(c.tool.rake_angle, 3)) for c in cases] == [
        (0.001, 0.262),
        (0.001, 0.524),
        (0.002, 0.262),
        (0.002, 0.524),
    ]


def test_zip_and_list_multiply():
    axes = {
        "zip": {"cut_depth": ["1 mm", "2 mm"], "cut_speed": ["5 m/s", "2 m/s"]},
        "list": [{"friction": 0.0}, {"friction": 0.3, "modulus_tangent": "0 MPa"}],
    }
    cases = members(base={"kind": "mpm"}, axes=axes)
    assert [(c.cut_depth, c.cut_speed, c.tool.friction, c.material.modulus_tangent) for c in cases] == [
        (0.001, 5.0, 0.0, 100e6),
        (0.001, 5.0, 0.3, 0.0),
        (0.002, 2.0, 0.0, 100e6),
        (0.002, 2.0, 0.3, 0.0),
    ]


def test_replicates_by_what_the_mean_is_known_to():
    base = {"kind": "dem", "cut_speed": "1 m/s"}
    counts = [len(members(base=base, replicates=share)) for share in ("50 %", "20 %", "10%")]
    assert counts == [packings(0.5, 1.0), packings(0.2, 1.0), packings(0.1, 1.0)]
    assert counts == sorted(counts)
    assert packings(0.1, 1.0) == pytest.approx((1.96 * 0.33 / 0.1) ** 2, rel=0.1)
    most = max(row["scatter"] for row in evidence()["glass"]["speed"])
    assert packings(0.1, 0.1) == packings(0.1) == pytest.approx((1.96 * most / 0.1) ** 2, rel=0.1)
    assert len(members(base={"kind": "dem"}, replicates="50 %")) == packings(0.5)


def test_replicates_change_the_seed_alone():
    cases = members(base={"kind": "dem", "packing": {"seed": 7}}, replicates=3)
    assert [c.packing.seed for c in cases] == [7, 8, 9]
    assert len({c.model_copy(update={"packing": cases[0].packing}) for c in cases}) == 1


def test_same_case_in_two_sweeps_is_one_run():
    two = study(
        a={"base": {"kind": "mpm"}, "axes": {"product": {"cut_depth": ["0.9 mm", "1 mm"]}}},
        b={"base": {"kind": "mpm", "cut_depth": "900 um"}},
    )
    cases = two.cases()
    assert set(cases["b"]) < set(cases["a"])
    assert set(cases["b"]) == {case_id(load("mpm"))}
    assert two.expand()[1][case_id(load("mpm"))] == "a: cut_depth 0.9 mm"


@pytest.mark.parametrize(
    ("sweep", "words"),
    [
        ({"base": {"kind": "mpm"}, "replicates": 2}, "replicates = 2: mpm_cutting has nothing random"),
        ({"base": {"cut_depth": "1 mm"}}, "sweeps.a: kind = None: must be one of"),
        (
            {"base": {"kind": "mpm"}, "axes": {"product": {"depth": ["1 mm"]}}},
            r"axes.product: depth: .* did you mean cut_d",
        ),
        (
            {"base": {"kind": "mpm"}, "axes": {"product": {"cut_depth": ["1"]}}},
            "sweeps.a: cut_depth = '1': has no unit",
        ),
        (
            {
                "base": {"kind": "mpm"},
                "axes": {"product": {"rake_angle": ["1 deg"]}, "zip": {"tool.rake_angle": ["2 deg"]}},
            },
            r"axes.zip: tool.rake_angle is already varied by product",
        ),
        (
            {
                "base": {"kind": "mpm"},
                "axes": {"product": {"tool": [{"rake_angle": "30 deg"}], "rake_angle": ["1 deg", "2 deg"]}},
            },
            r"axes.product: rake_angle is already varied by product \(as tool\)",
        ),
        (
            {
                "base": {"kind": "mpm"},
                "axes": {"zip": {"tool.rake_angle": ["1 deg"]}, "list": [{"tool": {"friction": 0.1}}]},
            },
            r"axes.list: tool is already varied by zip \(as tool.rake_angle\)",
        ),
        (
            {"base": {"kind": "mpm"}, "axes": {"list": [{"kind": "dem"}]}},
            r"sweeps.a.axes.list: kind cannot vary \(allowed: one kind a sweep",
        ),
    ],
)
def test_faults_when_expanded(sweep, words):
    with pytest.raises(ConfigError, match=words):
        members(**sweep)


def test_sets_of_a_list_may_vary_a_block_or_a_part_of_it():
    cases = members(base={"kind": "dem"}, axes={"list": [{"grooves": {"width": "40 um"}}, {"grooves.width": "50 um"}]})
    assert [round(c.grooves.width, 9) for c in cases] == [40e-6, 50e-6]


def test_cases_are_counted_without_making_them():
    axes = {
        "product": {"cut_depth": ["1 mm", "2 mm"], "rake_angle": ["15 deg", "30 deg", "45 deg"]},
        "zip": {"cut_speed": ["5 m/s", "2 m/s"], "points_per_depth": [5, 8]},
        "list": [{"friction": 0.0}, {"friction": 0.1}, {"friction": 0.2}],
    }
    two = study(a={"base": {"kind": "mpm"}, "axes": axes}, b={"base": {"kind": "mpm"}})
    assert [sweep.axes.count() for sweep in two.sweeps.values()] == [36, 1]
    assert [len(cases) for cases in two.cases().values()] == [36, 1]


def test_a_study_is_bounded_before_it_is_expanded(tmp_path, monkeypatch):
    monkeypatch.setattr("orthocut.params.study.Axes.points", None)
    hundred = [f"{k} um" for k in range(100, 200)]
    path = tmp_path / "study.yaml"

    def write(axes, replicates):
        sweep = f"{{base: {{kind: dem}}, axes: {{product: {axes}}}, replicates: {replicates}}}"
        path.write_text(f"title: t\nsweeps:\n  small: {{base: {{kind: mpm}}}}\n  huge: {sweep}\nfigures: {{}}\n")

    write({"cut_depth": hundred}, 999)
    assert load_study(path).sweeps["huge"].axes.count() == 100
    write({"cut_depth": hundred}, 1000)
    with pytest.raises(ConfigError, match=r"sweeps.huge: has 100000 cases, 100001 with .*allowed: up to 100000"):
        load_study(path)
    write({f"axis_{k}": hundred for k in range(12)}, 1)
    with pytest.raises(ConfigError, match=r"sweeps.huge: has 1000000000000000000000000 cases"):
        load_study(path)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("title: t\nsweeps: {}\nfigures: {f: [a]}\n", "figures.f = 'a': no such sweep"),
        ("title: t\nsweeps: {}\n", "figures: is missing"),
        ("titel: t\nsweeps: {}\nfigures: {}\n", "titel = 't': no such field; did you mean title"),
        (
            "title: t\nsweeps: {a: {base: {}, axes: {zip: {cut_depth: [1 mm], cut_speed: []}}}}\nfigures: {}\n",
            "differ in",
        ),
        (
            "title: t\nsweeps: {a: {base: {kind: mpm}, axes: {product: {cut_depth: []}}}}\nfigures: {}\n",
            "has no values",
        ),
        (
            "title: t\nsweeps: {a: {base: {kind: mpm}, replicates: 9 %}}\nfigures: {}\n",
            "sweeps.a: replicates = '9 %': the scatter of 'mpm' is not known (allowed: a number)",
        ),
        (
            "title: t\nsweeps: {a: {base: {kind: dem}, replicates: 1 %}}\nfigures: {}\n",
            "sweeps.a: replicates = 1 %: takes more than 1000 packings (allowed: 3 % or more)",
        ),
        (
            "title: t\nsweeps: {a: {base: {kind: dem}, replicates: many}}\nfigures: {}\n",
            "sweeps.a.replicates = 'many': must be a whole number",
        ),
        (
            "title: t\nsweeps: {a: {base: {kind: mpm}, replicates: 0}}\nfigures: {}\n",
            "sweeps.a.replicates = 0: is out of range",
        ),
        ("3\n", "must hold title, sweeps and figures"),
        ("title: t\nsweeps: {}\nfigures: {}\n", "sweeps and figures are both empty"),
        ("title: t\nsweeps: 3\nfigures: {}\n", "sweeps = 3: must map names to values"),
        (
            "title: t\nsweeps: {a: 3}\nfigures: {}\n",
            "sweeps.a = 3: must hold the fields of Sweep (allowed: base, axes, replicates, snapshots)",
        ),
        ("title: t\nsweeps: {a: {base: {kind: mpm}}}\nfigures: {f: a}\n", "f = 'a': must be a list of values"),
    ],
)
def test_faults_when_read(tmp_path, content, words):
    path = tmp_path / "study.yaml"
    path.write_text(content)
    with pytest.raises(ConfigError) as caught:
        load_study(path)
    assert words in str(caught.value)
    assert str(path) in str(caught.value)
