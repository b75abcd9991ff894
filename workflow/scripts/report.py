"""Write the report of the study."""

from pathlib import Path

from logged import logged

with logged(snakemake.log[0]):
    from orthocut.report.content import gather
    from orthocut.report.page import write

    content = gather(*(Path(snakemake.params[name]) for name in ("study", "results", "store")))
    write(content, Path(snakemake.output.page))
