"""A copy of the project with the smoke study run once, for all tests of the workflow."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


class Project:
    """A copy of the project in which tests may edit files."""

    def __init__(self, root):
        self.root = root

    def snakemake(self, *arguments, study="smoke", copied=True):
        """Run snakemake; return the finished process, stdout and stderr joined.

        With `copied` it imports the copied sources, which tests may edit; without, the installed ones, whose compiled
        kernels are in the cache: numba keeps them by the path of the source. Both have the same digests until an edit.
        """
        environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
        if copied:
            environment["PYTHONPATH"] = str(self.root / "src")
        return subprocess.run(
            [sys.executable, "-m", "snakemake", "--cores", "2", *arguments, "--config", f"study={study}"],
            cwd=self.root,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=280,
            check=False,
        )

    def planned(self, study="smoke"):
        """Rules that a dry run would run, with how often."""
        text = self.snakemake("--dry-run", study=study).stdout
        table = text.split("Job stats:")[1].split("total")[0] if "Job stats:" in text else ""
        return {
            words[0]: int(words[1]) for words in map(str.split, table.splitlines()) if words[1:] and words[1].isdigit()
        }

    def missing(self, study="smoke"):
        """Count the cases that a dry run would simulate."""
        text = self.snakemake("--dry-run", study=study).stdout
        found = re.search(r"^(\d+) cases to simulate", text, re.MULTILINE)
        assert found, text
        return int(found.group(1))

    def orthocut(self, *arguments):
        """Run the command line on the copied sources."""
        return subprocess.run(
            [sys.executable, "-c", "from orthocut.cli import app; app()", *arguments],
            cwd=self.root,
            env={**os.environ, "PYTHONPATH": str(self.root / "src"), "PYTHONDONTWRITEBYTECODE": "1"},
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )


def copy_project(folder):
    """Copy what the workflow needs."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("src", "workflow", "profiles"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    for name in ("Snakefile", "pyproject.toml", "constraints.txt"):
        shutil.copy(ROOT / name, folder / name)
    return Project(folder)


@pytest.fixture(scope="session")
def fresh(tmp_path_factory):
    """Return a project in which nothing was run."""
    return copy_project(tmp_path_factory.mktemp("fresh"))


@pytest.fixture(scope="session")
def finished(tmp_path_factory):
    """Return a project in which the smoke study was run; tests restore what they edit."""
    project = copy_project(tmp_path_factory.mktemp("finished"))
    project.first = project.snakemake(copied=False)
    assert project.first.returncode == 0, project.first.stdout
    return project
