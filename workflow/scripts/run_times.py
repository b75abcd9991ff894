"""Table of run times, per case and in total."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.figures.tables import run_times, write
    from orthocut.io.netcdf import read

    runs = [read(path) for path in snakemake.input.runs]
    write(run_times(runs, snakemake.params.labels), snakemake.output.csv.removesuffix(".csv"))
