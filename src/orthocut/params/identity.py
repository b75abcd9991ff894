"""Identity of cases and sources: what makes two results the same number."""

from __future__ import annotations

import ast
import hashlib
import io
import json
import tokenize
from collections.abc import Iterable, Iterator
from functools import cache
from importlib.metadata import version
from pathlib import Path

from orthocut.params.block import Block

_PACKAGE = Path(__file__).resolve().parent.parent
_NUMBERS = ("kernels", "mpm", "dem", "experiments", "measure", "params")
_PICTURES = ("figures", "theory", "params", "cost.py", "variables.py")
_PROMISES = ("accuracy.py", "accuracy.yaml", "accuracy_ductile.py", "size.py")  # of params: drawn, though input only
_DATASETS = ("io", "variables.py")
_INPUT_ONLY = (
    *(
        "__init__",
        "accuracy",
        "accuracy_ductile",
        "accuracy_glass",
        "block",
        "case",
        "identity",
        "limits",
        "quantity",
        "replicates",
        "schema",
        "size",
        "study",
        "text",
        "units",
        "wishes",
    ),
    "workflow",
)
_LIBRARIES = ("numpy", "numba", "llvmlite", "scipy")


def canonical(case: Block) -> str:
    """Canonical JSON of a case: every field, SI units, sorted keys."""
    return json.dumps(case.model_dump(mode="json"), sort_keys=True, separators=(",", ":"))


def case_id(case: Block) -> str:
    """Name of a case: kind and a hash of every value that can change its numbers."""
    digest = hashlib.sha256(canonical(case).encode()).hexdigest()[:12]
    return f"{case.kind.replace('_', '-')}-{digest}"


def result_key(case: Block) -> str:
    """Name of the result of a case: its id, and a hash of the sources and libraries that can change its numbers."""
    return f"{case_id(case)}-{digest_numbers(case.kind)[:8]}"


def sources(kind: str) -> list[Path]:
    """Files that can change the numbers of a kind of case, sorted: its experiment and what that imports.

    Left out are files of other parts of the package, such as readers and writers of results, and the files that only
    turn what a user writes into a case: a case in SI units is already part of a result's identity.

    Parameters
    ----------
    kind : str
        Such as ``mpm_cutting``, or a method, such as ``mpm``, for all of its kinds.
    """
    numbers = set(_files(_NUMBERS))
    found: set[Path] = set()
    waiting = sorted((_PACKAGE / "experiments").glob(f"{kind}*.py"))
    while waiting:
        file = waiting.pop()
        found.add(file)
        waiting += [other for other in _imports(file) if other in numbers and other not in found]
    return sorted(found)


def _imports(file: Path) -> Iterator[Path]:
    """Files of the package that a file imports."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("orthocut."):
            path = _PACKAGE.joinpath(*node.module.split(".")[1:])
            yield path.with_suffix(".py")
            yield from (path / f"{name.name}.py" for name in node.names)


@cache
def digest_numbers(kind: str) -> str:
    """Digest of the sources and the libraries that can change the numbers of a kind of case."""
    libraries = ", ".join(f"{name} {version(name)}" for name in _LIBRARIES)
    return _digest(sources(kind), libraries)


@cache
def digest_datasets() -> str:
    """Digest of the sources that join runs into the dataset of a figure."""
    return _digest(_files(_DATASETS), version("xarray"))


@cache
def digest_pictures() -> str:
    """Digest of the sources that only change figures and tables."""
    return _digest((*_files(_PICTURES), *(_PACKAGE / "params" / name for name in _PROMISES)), version("matplotlib"))


@cache
def digest_report() -> str:
    """Digest of the sources that only change the report."""
    return _digest(_files(("report",)), version("jinja2"))


def _files(parts: tuple[str, ...]) -> Iterator[Path]:
    """Files below some parts of the package, sorted, without those that only turn what a user writes into a case."""
    for part in parts:
        path = _PACKAGE / part
        found = sorted(file for file in path.rglob("*") if file.suffix in {".py", ".mplstyle", ".j2"}) or [path]
        yield from (file for file in found if part != "params" or file.stem not in _INPUT_ONLY)


def _digest(files: Iterable[Path], libraries: str) -> str:
    sha = hashlib.sha256(libraries.encode() + b"\0")
    for file in files:
        text = file.read_text(encoding="utf-8")
        code = bare(text) if file.suffix == ".py" else text
        sha.update(file.relative_to(_PACKAGE).as_posix().encode() + b"\0" + code.encode() + b"\0")
    return sha.hexdigest()[:16]


@cache
def bare(source: str) -> str:
    """Python source without comments, docstrings and empty lines: what is left can change numbers."""
    lines = source.splitlines()
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            row, column = token.start
            lines[row - 1] = lines[row - 1][:column]
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            for row in range(node.lineno - 1, node.end_lineno):
                lines[row] = ""
    return "\n".join(filter(None, (line.rstrip() for line in lines)))
