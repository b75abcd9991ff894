"""Where a result comes from: case, sources, versions."""

from __future__ import annotations

import subprocess
from functools import cache
from importlib.metadata import version
from pathlib import Path
from platform import python_version

from orthocut.params.block import Block
from orthocut.params.identity import canonical, case_id, digest_numbers

_REFERENCES = {
    "mpm": "Nairn, J. A. (2015), Numerical simulation of orthogonal cutting using the material point method",
    "dem": "Yang, G., et al. (2018), J. Manuf. Mater. Process. 2, 10, doi:10.3390/jmmp2010010",
}


@cache
def git_commit() -> str:
    """Commit of the sources, and whether they were edited; unknown outside of a repository."""
    try:
        done = subprocess.run(
            ["git", "describe", "--always", "--dirty", "--abbrev=12"],
            cwd=Path(__file__).parent,
            capture_output=True,
            text=True,
            timeout=10,
            check=True,
        )
    except (OSError, subprocess.SubprocessError):
        return "unknown"
    return done.stdout.strip()


@cache
def _versions() -> str:
    packages = ("orthocut", "numpy", "numba", "llvmlite", "scipy", "xarray")
    return ", ".join([f"python {python_version()}", *(f"{name} {version(name)}" for name in packages)])


def provenance(case: Block) -> dict[str, str]:
    """Global attributes that let a reader repeat the run."""
    return {
        "Conventions": "CF-1.11",
        "kind": case.kind,
        "case_id": case_id(case),
        "case": canonical(case),
        "source_digest": digest_numbers(case.kind),
        "git_commit": git_commit(),
        "versions": _versions(),
        "references": _REFERENCES[case.kind.split("_")[0]],
    }
