"""Draw a figure from its dataset."""

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.figures.registry import draw
    from orthocut.figures.save import save
    from orthocut.io.netcdf import read

    dataset = read(snakemake.input.dataset[0]) if snakemake.input else None
    save(draw(snakemake.wildcards.figure, dataset), snakemake.output.png.removesuffix(".png"))
