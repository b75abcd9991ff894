"""Join results into the dataset of a figure."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.figures.registry import condense
    from orthocut.io.collect import collect
    from orthocut.io.netcdf import write
    from orthocut.io.store import Store

    store = Store(snakemake.params.store)
    keys = [member.partition("#")[0] for member in snakemake.params.members]
    runs = (store.read(key, snakemake.params.fields) for key in keys)
    shorten = condense(snakemake.wildcards.figure)
    runs = map(shorten, runs) if shorten else runs
    write(collect(runs, snakemake.wildcards.figure, snakemake.params.dims), snakemake.output.dataset)
