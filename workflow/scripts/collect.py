"""Join runs into the dataset of a figure."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.io.collect import collect
    from orthocut.io.netcdf import read, write

    write(collect(map(read, snakemake.input.runs), snakemake.wildcards.figure), snakemake.output.dataset)
