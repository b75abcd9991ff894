"""Compile the kernels of a kind of case."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.run import warm

    print(f"{warm(snakemake.wildcards.kind):.1f} s")
