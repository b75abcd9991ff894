"""Write figures: PNG and SVG, whole or not at all, the same bytes for the same figure."""

from __future__ import annotations

import os
from pathlib import Path

import matplotlib.style
from matplotlib.figure import Figure

from orthocut.figures.canvas import STYLE

_METADATA = {"png": {"Software": None}, "svg": {"Date": None, "Creator": None}}


def save(figure: Figure, stem: str | Path) -> list[Path]:
    """Write ``stem.png`` and ``stem.svg`` under temporary names, then rename them.

    Parameters
    ----------
    figure : Figure
        What to write.
    stem : str or Path
        File name without its ending; folders are made.

    Returns
    -------
    list of Path
        The files.
    """
    stem = Path(stem)
    stem.parent.mkdir(parents=True, exist_ok=True)
    paths = [stem.with_name(f"{stem.name}.{form}") for form in _METADATA]
    parts = [path.with_name(f".{path.name}.{os.getpid()}.part") for path in paths]
    try:
        with matplotlib.style.context(["default", STYLE]):
            for part, form in zip(parts, _METADATA, strict=True):
                figure.savefig(part, format=form, metadata=_METADATA[form])
        for part, path in zip(parts, paths, strict=True):
            os.replace(part, path)
    finally:
        for part in parts:
            part.unlink(missing_ok=True)
    return paths


def write_text(text: str, path: str | Path) -> Path:
    """Write a text file under a temporary name, then rename it."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        part.write_text(text, encoding="utf-8")
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)
    return path
