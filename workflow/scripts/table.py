"""Write the table that goes with a figure."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.figures.registry import tabulate
    from orthocut.figures.tables import write
    from orthocut.io.netcdf import read

    dataset = read(snakemake.input.dataset[0])
    write(tabulate(snakemake.wildcards.figure, dataset), snakemake.output.csv.removesuffix(".csv"))
