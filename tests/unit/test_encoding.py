import warnings

import numpy as np
import pytest
import xarray as xr
from synthetic import dem_cut_run, dem_test_run, mpm_run

from orthocut.io import encoding, netcdf
from orthocut.io.collect import case_of
from orthocut.io.datasets import failed as failed_result
from orthocut.io.datasets import split
from orthocut.variables import VARIABLES, attributes

RUNS = {"mpm": mpm_run(snapshots=2), "cut": dem_cut_run(), "test": dem_test_run()}


def long_run(samples=500, histories=23):
    """A cut with as many histories and samples as the solver writes."""
    run, random = split(mpm_run(snapshots=0))[0], np.random.default_rng(1)
    single = {name: variable for name, variable in run.data_vars.items() if not variable.ndim}
    names = [name for name in VARIABLES if name.startswith(("force_", "reaction_", "energy_", "work_", "tool_t", "cr"))]
    names = [name for name in names if name not in single][: histories - 1]
    data = {name: ("sample", random.standard_normal(samples).cumsum(), attributes(name)) for name in names}
    data["time"] = ("sample", np.arange(1.0, samples + 1), attributes("time"))
    return xr.Dataset(single | data, attrs=run.attrs)


def stored(dataset, path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        netcdf.fill(dataset, path)
    return netcdf.read(path)


@pytest.mark.parametrize("samples", [200, 500])
def test_small_files_are_small_and_plain_readers_open_them(samples, tmp_path):
    run = long_run(samples)
    stored(run, tmp_path / "run.nc")
    assert (tmp_path / "run.nc").stat().st_size <= 20_000 - 350  # the seal
    with xr.open_dataset(tmp_path / "run.nc") as plain:
        assert set(plain.variables) == set(run.variables)
        for name, variable in plain.variables.items():
            assert variable.attrs["units"] == VARIABLES[name].unit
            assert variable.attrs["long_name"] == VARIABLES[name].long_name


@pytest.mark.parametrize("kind", RUNS)
def test_single_numbers_are_exact_and_histories_within_their_range(kind, tmp_path):
    small, _ = split(RUNS[kind])
    again = stored(small, tmp_path / "run.nc")
    assert again.attrs == small.attrs
    for name, variable in small.variables.items():
        if not variable.ndim:
            np.testing.assert_array_equal(again[name], variable)
        else:
            spread = np.nanmax(variable) - np.nanmin(variable)
            np.testing.assert_allclose(again[name], variable, rtol=1e-14, atol=spread / (1.999 * encoding.STEPS))
        assert xr.Variable((), 0, again[name].attrs).identical(xr.Variable((), 0, variable.attrs))


@pytest.mark.parametrize(
    "values",
    [[0.0, 3.0, 7000.0, 64999.0], [2.5, 2.5, 2.5], [np.nan, np.nan], [1.0, np.nan, 4.0], [0.0, np.inf], [-1e-30] * 2],
)
def test_counts_constants_and_what_is_no_number_are_exact(values, tmp_path):
    data = xr.Dataset({"crack_tip": ("sample", np.array(values), attributes("crack_tip"))})
    np.testing.assert_array_equal(stored(data, tmp_path / "run.nc")["crack_tip"], values)


def test_joined_samples_are_what_a_run_with_fewer_samples_gives():
    run = long_run(500)
    thinned = encoding.thin(run, encoding.ROOMS[0])
    assert thinned.sizes["sample"] == 250
    force, energy = run["force_cutting"].values, run["energy_elastic"].values
    np.testing.assert_allclose(thinned["force_cutting"], 0.5 * (force[::2] + force[1::2]))
    np.testing.assert_array_equal(thinned["energy_elastic"], energy[1::2])
    assert thinned["time"][-1] == run["time"][-1]
    assert encoding.thin(long_run(200), encoding.ROOMS[0]).sizes["sample"] == 200


@pytest.mark.parametrize("kind", RUNS)
def test_fields_keep_positions_to_a_thousandth_of_a_particle(kind, tmp_path):
    _, fields = split(RUNS[kind])
    again = stored(fields, tmp_path / "fields.nc")
    case = case_of(RUNS[kind])
    size = case.cut_depth / case.numerics.points_per_depth / 2 if kind == "mpm" else case.packing.radius_min
    for name, variable in fields.variables.items():
        if name.endswith(("_x", "_y")):
            np.testing.assert_allclose(again[name], variable, atol=1e-3 * size)
        elif variable.dtype.kind in "iub":
            np.testing.assert_array_equal(again[name], variable)
        else:
            np.testing.assert_allclose(again[name], variable, rtol=10.0**-3, atol=1e-30)


def test_a_failed_result_is_kept(tmp_path):
    failed = failed_result(case_of(RUNS["mpm"]), "diverged at 3 µs", 2.5)
    assert stored(failed, tmp_path / "run.nc").identical(failed)


def test_more_samples_are_joined_where_attributes_take_the_room(tmp_path):
    run = long_run()
    stored(run, tmp_path / "plain.nc")
    run.attrs["failure"] = "x" * 6000
    found = stored(run, tmp_path / "wordy.nc")
    assert (tmp_path / "wordy.nc").stat().st_size <= encoding.SMALL_BYTES
    assert found.sizes["sample"] < netcdf.read(tmp_path / "plain.nc").sizes["sample"]
    assert float(found["work_tool"][-1]) == pytest.approx(float(run["work_tool"][-1]), rel=1e-3, abs=1e-2)
