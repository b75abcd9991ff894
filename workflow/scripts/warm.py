"""Compile the kernels of a method."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.run import warm

    print(f"{warm(snakemake.wildcards.method):.1f} s")
