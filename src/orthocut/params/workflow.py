"""Options of the workflow, as people give them behind ``snakemake --config``."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, ValidationError, model_validator

from orthocut.params.block import Block, ConfigError, describe, fault
from orthocut.params.quantity import Number
from orthocut.params.text import Name

SOURCE = "--config"
STUDIES = Path("workflow/config")
"""Folder of the studies that have a name."""
RESULTS = "results"
PARTS = (
    "animations",
    "batches",
    "benchmarks",
    "calibration",
    "datasets",
    "figures",
    "kernels",
    "logs",
    "progress",
    "store",
    "tables",
)
"""Folders that the workflow makes among its results; a folder that holds none of them is somebody else's."""
_UNSAFE = frozenset("{}*?[]$`'\"\\<>|;&~#,")


def _path(text: str) -> str:
    if not 0 < len(text) <= 1000 or not text.isprintable() or text.startswith("-") or text != text.strip():
        raise fault("must be a path (allowed: 1 to 1000 characters that can be printed; no - and no spaces first)")
    found = "".join(sorted(_UNSAFE & set(text)))
    if found:
        raise fault(f"must be a path without any of {found} (allowed: letters, digits, / . _ - + = @ : and spaces)")
    return os.path.normpath(text)


Location = Annotated[str, AfterValidator(_path)]


class WorkflowOptions(Block):
    """What to run, where results go, and how the work is shared out."""

    study: Name = "quick"
    """Name of a study in the folder of studies."""
    study_file: Location | None = None
    """A study file anywhere, instead of a name."""
    results: Location = RESULTS
    """Folder of everything that is written: a new or empty one, or one that holds results."""
    store: Location | None = None
    """Folder of the results of cases, if they shall be elsewhere, such as shared by several studies."""
    cluster: Literal["local", "slurm"] = "local"
    """Where the workers of a batch run."""
    batch_cores: Annotated[int, Number(1, 4096, integer=True)] = int(
        os.environ.get("SLURM_CPUS_PER_TASK") or os.cpu_count() or 1
    )
    """Cores of one batch of short cases; in a Slurm job, by default those of the job."""
    batch_minutes: Annotated[float, Number(0, 10_000)] = 10.0
    """Predicted run time of one batch [min]; 0 makes a batch of every case."""

    @model_validator(mode="after")
    def _one_study(self) -> WorkflowOptions:
        if self.study_file is not None and "study" in self.model_fields_set:
            raise fault("study and study_file are both given (allowed: one of them)")
        return self

    @classmethod
    def read(cls, config: Mapping[str, Any]) -> WorkflowOptions:
        """Check what Snakemake made of its command line.

        Raises
        ------
        ConfigError
            One line a fault: option, value, what is allowed.
        """
        try:
            return cls.model_validate(dict(config))
        except ValidationError as error:
            raise describe(error, SOURCE, cls.model_fields) from None

    def study_path(self, root: Path) -> Path:
        """File of the study; `root` is the folder of the project."""
        return Path(self.study_file) if self.study_file else root / STUDIES / f"{self.study}.yaml"

    @property
    def store_path(self) -> str:
        """Folder of the results of cases."""
        return self.store or f"{self.results}/store"

    def check_folders(self, project: Path) -> None:
        """Refuse folders that hold other things, files in the place of folders, and ways out of the project.

        Parameters
        ----------
        project : Path
            Folder in which the workflow runs; a relative path stays inside.

        Raises
        ------
        ConfigError
            Names the option, the folder and what is allowed.
        """
        project = project.resolve()
        self._check(project, "results", self.results)
        if not os.access(_nearest(project / self.results), os.W_OK):
            raise ConfigError(f"{SOURCE}: results = {self.results}: cannot be written to")
        if self.store is not None:
            self._check(project, "store", self.store)

    def _check(self, project: Path, option: str, text: str) -> None:
        where = f"{SOURCE}: {option} = {text}"
        path = Path(os.path.normpath(project / text))
        if not Path(text).is_absolute() and not path.is_relative_to(os.path.normpath(project)):
            raise ConfigError(f"{where}: leads out of the folder of the project (allowed: an absolute path)")
        try:
            near = _nearest(path)
            if not near.is_dir():
                raise ConfigError(f"{where}: {near} is not a folder")
            names = (
                {entry.name for entry in path.iterdir() if not entry.name.startswith(".")} if path.exists() else set()
            )
        except OSError as error:
            raise ConfigError(f"{where}: {error.strerror}") from None
        known = names & set(PARTS) if option == "results" else {name for name in names if name.endswith(".nc")}
        if names and not known and path != project / RESULTS:
            raise ConfigError(
                f"{where}: holds other things (allowed: a new or an empty folder, or one that holds results)"
            )


def _nearest(path: Path) -> Path:
    """Path itself, or the nearest folder above it that is there."""
    return next(place for place in (path, *path.parents) if place.exists())
