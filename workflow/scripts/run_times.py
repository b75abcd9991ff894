"""Table of run times, per case and in total."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.figures.tables import run_times, write
    from orthocut.io.store import Store

    store = Store(snakemake.params.store)
    runs = [store.read(member.partition("#")[0]) for member in snakemake.params.members]
    write(run_times(runs, snakemake.params.labels), snakemake.output.csv.removesuffix(".csv"))
