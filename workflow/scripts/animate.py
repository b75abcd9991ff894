"""Animate a cut."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.figures.registry import module
    from orthocut.io.netcdf import read

    module(snakemake.wildcards.figure).animate(read(snakemake.input.dataset), snakemake.output.gif)
