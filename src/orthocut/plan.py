"""What a study asks of the workflow: each case once, and the cases of each figure."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from orthocut.figures.registry import FIGURES, WITHOUT_RUNS, module
from orthocut.params.block import ConfigError, hint
from orthocut.params.case import KINDS, Case
from orthocut.params.study import load_study
from orthocut.run import estimate_seconds

METHODS = {"nairn2015": "mpm_", "yang2018": "dem_"}
"""Paper of a figure to the start of the kinds of cases that it draws; any other figure draws all kinds."""


@dataclass(frozen=True)
class Plan:
    """A study, expanded."""

    title: str
    """One line for people."""
    cases: dict[str, Case]
    """Case id to case, each once."""
    labels: dict[str, str]
    """Case id to words for people."""
    figures: dict[str, list[str]]
    """Figure to the ids of its cases."""

    @property
    def tables(self) -> list[str]:
        """Figures that come with a table."""
        return [figure for figure in self.figures if hasattr(module(figure), "tabulate")]

    def seconds(self, case_id: str) -> float:
        """Rough run time of a case [s]."""
        return estimate_seconds(self.cases[case_id])

    def announcement(self) -> dict[str, tuple[str, float]]:
        """Case id to label and rough run time."""
        return {case_id: (self.labels[case_id], self.seconds(case_id)) for case_id in self.cases}


def load_plan(path: Path) -> Plan:
    """Read a study and expand it.

    Raises
    ------
    ConfigError
        Names file, field, value and what is allowed; also if a figure does not exist.
    """
    study = load_study(path)
    sweeps, labels = study.expand(str(path))
    for figure, names in study.figures.items():
        if figure not in FIGURES:
            raise ConfigError(f"{path}: figures.{figure}: no such figure; {hint(figure, FIGURES)}")
        if bool(names) == (figure in WITHOUT_RUNS):
            need = "no sweeps: it draws theory alone" if names else "one sweep or more"
            raise ConfigError(f"{path}: figures.{figure} = {names}: this figure needs {need}")
        method = METHODS.get(figure.split("_")[0], "")
        for name in names:
            kind = next(iter(sweeps[name].values())).kind
            if not kind.startswith(method):
                allowed = ", ".join(known for known in KINDS if known.startswith(method))
                raise ConfigError(
                    f"{path}: figures.{figure} = {names}: {name} is a sweep of {kind} (allowed: sweeps of {allowed})"
                )
    return Plan(
        title=study.title,
        cases={case_id: case for cases in sweeps.values() for case_id, case in cases.items()},
        labels=labels,
        figures={
            figure: list(dict.fromkeys(case_id for name in names for case_id in sweeps[name]))
            for figure, names in study.figures.items()
        },
    )
