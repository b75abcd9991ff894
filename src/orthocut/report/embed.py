"""Pictures that stand in a page."""

from __future__ import annotations

import base64
from pathlib import Path

import PIL.Image

_DENSITY = 1.9
"""Pixels of a picture for one on screen."""
_TYPES = {".png": "image/png", ".gif": "image/gif"}


def data_uri(path: Path) -> str:
    """Content of a picture."""
    return f"data:{_TYPES[path.suffix]};base64,{base64.b64encode(path.read_bytes()).decode()}"


def shown_width(path: Path) -> int:
    """Width of a picture on screen [px]."""
    with PIL.Image.open(path) as picture:
        return round(picture.width / _DENSITY)
