"""Rules of the CF conventions that files broke once."""

import netCDF4
from synthetic import dem_cut_run, mpm_run

from orthocut.io.collect import collect
from orthocut.io.netcdf import write


def test_flag_values_have_the_type_of_their_variable(tmp_path):
    write(collect([mpm_run(), dem_cut_run()], "A sweep"), tmp_path / "sweep.nc")
    with netCDF4.Dataset(tmp_path / "sweep.nc") as file:
        flagged = {name: variable for name, variable in file.variables.items() if "flag_values" in variable.ncattrs()}
        assert {"status", "touching", "grooved"} <= set(flagged)
        for name, variable in flagged.items():
            assert variable.flag_values.dtype == variable.dtype, name


def test_aggregates_say_what_they_are_made_of():
    attributes = collect([mpm_run()], "A sweep").attrs
    assert attributes["Conventions"] == "CF-1.11"
    assert attributes["title"] == "A sweep"
    assert attributes["history"].startswith("collected from 1 results by orthocut ")
