"""Run one case."""

import json

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.io.netcdf import write
    from orthocut.params.case import validate
    from orthocut.run import run_case

    case = validate(json.loads(snakemake.params.case), snakemake.wildcards.case_id)
    write(run_case(case), snakemake.output.run)
