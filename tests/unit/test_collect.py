import json

import numpy as np
import pytest
import xarray as xr
from synthetic import dem_cut_run, dem_test_run, make_case, mpm_run

from orthocut.io import netcdf
from orthocut.io.collect import case_of, collect, parameters
from orthocut.io.datasets import failed
from orthocut.params.case import KINDS, fields
from orthocut.variables import VARIABLES


@pytest.fixture(scope="module")
def ragged():
    return [
        mpm_run(snapshots=2, cut_depth="0.5 mm"),
        mpm_run(snapshots=3, cut_depth="0.9 mm", **{"numerics.points_per_depth": 3}),
        mpm_run(snapshots=0, cut_depth="0.5 mm", rake_angle="15 deg"),
    ]


def test_values_are_kept_and_the_rest_is_padded(ragged):
    joined = collect(ragged)
    assert dict(joined.sizes)["case"] == 3
    assert joined.sizes["snapshot"] == 3
    for index, run in enumerate(ragged):
        one = joined.isel(case=index)
        for name in run.data_vars:
            padded = one[name].values
            inner = padded[tuple(slice(length) for length in run[name].shape)]
            np.testing.assert_array_equal(inner, run[name].values)
            assert padded.size == inner.size or np.isnan(padded).sum() == padded.size - inner.size
    assert np.isnan(joined["point_x"].values[2]).all()


def test_types_survive(ragged):
    joined = collect([*ragged, dem_cut_run(cracks=5), dem_cut_run(cracks=9, seed=2)])
    assert joined["force_cutting"].dtype == np.float64
    assert joined["crack_mode"].dtype == np.int64
    assert (joined["crack_mode"].values[3, 5:] == -1).all()
    assert set(np.unique(joined["crack_mode"].values[3, :5])) <= {0, 1}
    assert (joined["bond_first"].values[0] == -1).all()


def test_coordinates_are_the_swept_parameters(ragged):
    joined = collect(ragged)
    np.testing.assert_allclose(joined["cut_depth"], [0.5e-3, 0.9e-3, 0.5e-3])
    np.testing.assert_allclose(np.rad2deg(joined["rake_angle"]), [30, 30, 15])
    np.testing.assert_array_equal(joined["points_per_depth"], [4, 3, 4])
    assert "courant" not in joined.coords
    assert joined["cut_depth"].attrs["units"] == "m"
    assert "modulus_tangent" in joined.coords


def test_names_that_two_blocks_share_are_told_apart():
    joined = collect([dem_cut_run(**{"joint.friction": 0.3}), dem_cut_run(**{"tool.friction": 0.1})])
    np.testing.assert_allclose(joined["friction"], [0.577, 0.1])
    np.testing.assert_allclose(joined["joint_friction"], [0.3, 0.577])


def test_grooves_become_a_flag():
    joined = collect([dem_cut_run(), dem_cut_run(**{"grooves.width": "0.05 mm"})])
    np.testing.assert_array_equal(joined["grooved"], [0, 1])


def test_runs_of_different_kinds_stand_side_by_side(tmp_path):
    runs = [dem_test_run("dem_tension"), dem_test_run("dem_compression"), mpm_run(snapshots=1)]
    joined = collect(runs, title="all kinds")
    assert list(joined["kind"].values) == ["dem_tension", "dem_compression", "mpm_cutting"]
    assert np.isnan(joined["cut_depth"].values[0])
    assert joined["cut_depth"].values[2] == 0.9e-3
    assert np.isnan(joined["stress_axial"].values[2]).all()

    netcdf.write(joined, tmp_path / "joined.nc")
    again = netcdf.read(tmp_path / "joined.nc")
    assert set(again.variables) == set(joined.variables)
    for name in joined.variables:
        expected = joined[name].values
        if "_FillValue" in joined[name].encoding:  # readers turn the padding of integers into NaN
            expected = np.where(expected == -1, np.nan, expected)
        np.testing.assert_array_equal(again[name].values, expected)
    assert np.isnan(again["bond_first"].values[2]).all()


def test_failed_cases_are_holes_with_a_reason(ragged, tmp_path):
    case = make_case("mpm_cutting", cut_depth="3 mm")
    joined = collect([ragged[0], failed(case, "it blew up", 1.0)], title="one failed")
    netcdf.write(joined, tmp_path / "joined.nc")
    again = xr.load_dataset(tmp_path / "joined.nc")
    assert list(again["status"].values) == [0, 1]
    assert again["status"].attrs["flag_meanings"] == "done failed"
    assert list(again["failure"].values) == ["", "it blew up"]
    assert again["cut_depth"].values[1] == pytest.approx(3e-3)
    for name, variable in again.data_vars.items():
        if variable.dtype.kind == "f" and name not in ("wall_time",):
            assert np.isnan(variable.values[1]).all(), name
    assert again["force_cutting_mean"].mean().item() == ragged[0]["force_cutting_mean"].item()


def test_only_failed_cases_make_a_dataset_without_values(tmp_path):
    joined = collect([failed(make_case(kind), "it blew up", 1.0) for kind in KINDS])
    netcdf.write(joined, tmp_path / "joined.nc")
    assert netcdf.read(tmp_path / "joined.nc").sizes["case"] == len(KINDS)


def test_components_are_labelled(ragged):
    assert list(collect(ragged)["component"].values) == ["xx", "xy", "yx", "yy"]


def test_snapshots_are_read_when_they_are_touched(ragged, tmp_path):
    netcdf.write(collect(ragged), tmp_path / "joined.nc")
    with xr.open_dataset(tmp_path / "joined.nc", chunks={}) as lazy:
        stress = lazy["point_stress"]
        assert stress.chunks[:2] == ((1, 1, 1), (1, 1, 1))
        np.testing.assert_array_equal(stress[1, 2].compute(), collect(ragged)["point_stress"].values[1, 2])


def test_whole_cases_and_provenance_come_along(ragged):
    joined = collect(ragged, title="a title")
    assert joined.attrs["title"] == "a title"
    assert joined.attrs["case_ids"] == ", ".join(run.attrs["case_id"] for run in ragged)
    assert joined.attrs["source_digest"] == ragged[0].attrs["source_digest"]
    np.testing.assert_array_equal(joined["wall_time"], [3.5, 3.5, 3.5])
    for index, run in enumerate(ragged):
        assert json.loads(joined["case_json"].values[index]) == json.loads(run.attrs["case"])
        assert case_of(joined.isel(case=index)) == case_of(run)


def test_different_sources_are_both_named(ragged):
    other = ragged[1].copy()
    other.attrs["source_digest"] = "another"
    assert collect([ragged[0], other]).attrs["source_digest"] == f"{ragged[0].attrs['source_digest']}; another"


def test_the_same_case_is_taken_once(ragged):
    assert collect([ragged[0], ragged[0]]).sizes["case"] == 1


def test_only_wanted_dimensions_are_kept(ragged):
    assert set(collect(ragged, dims=("sample",)).dims) == {"case", "sample"}
    scalars = collect(ragged, dims=())
    assert set(scalars.dims) == {"case"}
    assert "force_cutting_mean" in scalars


def test_no_runs_give_an_empty_dataset():
    assert collect([]).sizes["case"] == 0


def test_runs_that_disagree_on_dimensions_are_refused(ragged):
    other = ragged[1].drop_vars("time")
    other["time"] = ("snapshot", np.zeros(3))
    with pytest.raises(ValueError, match="time has dimensions"):
        collect([ragged[0], other])


@pytest.mark.parametrize("kind", KINDS)
def test_every_parameter_stands_in_the_table_of_variables(kind):
    case = make_case(kind, **({"grooves.width": "0.05 mm"} if kind == "dem_cutting" else {}))
    assert set(parameters(case)) <= set(VARIABLES)


@pytest.mark.parametrize("kind", KINDS)
def test_no_two_parameters_share_a_name(kind):
    case = make_case(kind, **({"grooves.width": "0.05 mm"} if kind == "dem_cutting" else {}))
    names = list(fields(KINDS[kind]))
    leaves = [name for name in names if not any(other.startswith(f"{name}.") for other in names)]
    assert len(set(parameters(case)) - {"grooved"}) == len(leaves)
