"""What a study asks of the workflow: each case once, and the cases of each figure."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from orthocut.figures.registry import FIGURES, WITHOUT_RUNS, dims, module
from orthocut.params.block import ConfigError, hint, show
from orthocut.params.case import KINDS, Case
from orthocut.params.study import Study, load_study

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
    sweeps: dict[str, dict[str, list[str]]]
    """Figure to its sweeps, each with the ids of its cases."""
    snapshots: dict[str, int]
    """Case id to the number of snapshots that its figures want; 0 if none draws any."""

    @property
    def tables(self) -> list[str]:
        """Figures that come with a table."""
        return [figure for figure in self.figures if hasattr(module(figure), "tabulate")]

    @property
    def animations(self) -> list[str]:
        """Figures that come with an animation."""
        return [figure for figure in self.figures if hasattr(module(figure), "animate")]


def load_plan(path: Path) -> Plan:
    """Read a study and expand it.

    Raises
    ------
    ConfigError
        Names file, field, value and what is allowed; also if a figure does not exist.
    """
    study = load_study(path)
    sweeps, labels = study.expand(str(path))
    check_figures(study, sweeps, str(path))
    cases = {case_id: case for members in sweeps.values() for case_id, case in members.items()}
    return Plan(
        title=study.title,
        cases=cases,
        labels=labels,
        figures={
            figure: list(dict.fromkeys(case_id for name in names for case_id in sweeps[name]))
            for figure, names in study.figures.items()
        },
        sweeps={figure: {name: list(sweeps[name]) for name in names} for figure, names in study.figures.items()},
        snapshots=dict.fromkeys(cases, 0) | _snapshots(study, sweeps),
    )


def check_figures(study: Study, sweeps: dict[str, dict[str, Case]], source: str) -> None:
    """Raise `ConfigError` if a figure does not exist, or cannot draw the sweeps that the study gives it."""
    for figure, names in study.figures.items():
        if figure not in FIGURES:
            raise ConfigError(f"{source}: figures.{figure}: no such figure; {hint(figure, FIGURES)}")
        if bool(names) == (figure in WITHOUT_RUNS):
            need = "no sweeps: it draws theory alone" if names else "one sweep or more"
            raise ConfigError(f"{source}: figures.{figure} = {show(names)}: this figure needs {need}")
        method = METHODS.get(figure.split("_")[0], "")
        for name in names:
            kind = next(iter(sweeps[name].values())).kind
            if not kind.startswith(method):
                allowed = ", ".join(known for known in KINDS if known.startswith(method))
                raise ConfigError(
                    f"{source}: figures.{figure} = {show(names)}: {name} is a sweep of {kind} "
                    f"(allowed: sweeps of {allowed})"
                )


def draws_fields(figure: str) -> bool:
    """Whether a figure draws snapshots, beside single numbers and histories."""
    wanted = dims(figure)
    return wanted is None or bool(set(wanted) - {"sample"})


def _snapshots(study: Study, sweeps: dict[str, dict[str, Case]]) -> dict[str, int]:
    """Largest number of snapshots that a figure wants of each case; cases of which none does are left out."""
    counts: dict[str, int] = {}
    for figure, names in study.figures.items():
        if names and draws_fields(figure):
            for name in names:
                for case_id in sweeps[name]:
                    counts[case_id] = max(counts.get(case_id, 0), study.sweeps[name].snapshots)
    return counts
