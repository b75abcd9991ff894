"""Simulate the cases of a batch into the store."""

from pathlib import Path

from logged import logged


def main():
    """Run the batch; not at import: worker processes import this file when they start."""
    with logged(snakemake.log[0]):
        from orthocut.io.events import Events
        from orthocut.io.store import Store
        from orthocut.survey import read_batch
        from orthocut.sweep import run_batch

        run_batch(
            read_batch(Path(snakemake.params.batch)),
            Store(snakemake.params.store),
            Events(Path(snakemake.params.events)),
            workers=snakemake.threads,
            memory_mb=snakemake.resources.mem_mb,
            cluster=snakemake.params.cluster,
            minutes=snakemake.resources.runtime,
        )
        Path(snakemake.output[0]).touch()


if __name__ == "__main__":
    main()
