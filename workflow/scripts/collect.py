"""Join runs into the dataset of a figure."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.io.collect import collect
    from orthocut.io.netcdf import read, write

    runs = map(read, snakemake.input.runs)
    write(collect(runs, snakemake.wildcards.figure, snakemake.params.dims), snakemake.output.dataset)
