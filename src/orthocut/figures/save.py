"""Write figures: PNG and SVG, whole or not at all, the same bytes for the same figure."""

from __future__ import annotations

import os
from pathlib import Path

import matplotlib.style
from matplotlib.figure import Figure

from orthocut.figures.canvas import STYLE

_METADATA = {
    "png": {"Software": None},
    "svg": {"Date": None, "Creator": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}


def save(figure: Figure, target: str | Path) -> list[Path]:
    """Write a figure under temporary names, then rename them.

    Parameters
    ----------
    figure : Figure
        What to write.
    target : str or Path
        A file that ends in .png, .svg or .pdf, or a name without such an ending: then a PNG and an SVG. Folders are
        made.

    Returns
    -------
    list of Path
        The files.
    """
    target = Path(target)
    target.parent.mkdir(parents=True, exist_ok=True)
    form = target.suffix.lower().removeprefix(".")
    paths = [target] if form in _METADATA else [target.with_name(f"{target.name}.{form}") for form in ("png", "svg")]
    parts = [path.with_name(f".{path.name}.{os.getpid()}.part") for path in paths]
    try:
        with matplotlib.style.context(["default", STYLE]):
            for part, path in zip(parts, paths, strict=True):
                form = path.suffix.lower().removeprefix(".")
                figure.savefig(part, format=form, metadata=_METADATA[form])
        for part, path in zip(parts, paths, strict=True):
            os.replace(part, path)
    finally:
        for part in parts:
            part.unlink(missing_ok=True)
    return paths
