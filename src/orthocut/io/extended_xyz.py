"""Write particles as extended XYZ, which OVITO opens: all snapshots in one text file."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orthocut.io.files import replacing
from orthocut.io.particles import Frame


def write_xyz(frames: list[Frame], path: str | Path) -> Path:
    """Write snapshots one after another; the file appears whole or not at all.

    Parameters
    ----------
    frames : list of Frame
    path : str or Path

    Returns
    -------
    Path
        The file. Its box, the same in all frames, holds every particle; numbers have all their digits.
    """
    radius = max(float(frame.fields["radius"].max()) for frame in frames)
    low = np.min([frame.position.min(axis=0) for frame in frames], axis=0) - radius
    size = np.max([frame.position.max(axis=0) for frame in frames], axis=0) + radius - low
    box = f'Lattice="{_row(np.diag(size).ravel())}" Origin="{_row(low)}" pbc="F F F"'
    path = Path(path)
    with replacing(path) as temporary, open(temporary, "w", encoding="ascii") as file:
        for frame in frames:
            _write(file, frame, box)
    return path


def _write(file, frame: Frame, box: str) -> None:
    names = ["species:S:1", "id:I:1", "pos:R:3"]
    columns = [frame.position]
    for name, values in frame.fields.items():
        columns.append(values.reshape(len(values), -1))
        names.append(f"{name}:R:{columns[-1].shape[1]}")
    table = np.hstack(columns)
    tip = f" tool_tip={frame.tool_tip!r}" if np.isfinite(frame.tool_tip) else ""
    file.write(f"{len(table)}\n{box} Properties={':'.join(names)} Time={frame.time!r}{tip}\n")
    for number, row in enumerate(table.tolist(), 1):
        file.write(f"X {number} {_row(row)}\n")


def _row(values) -> str:
    return " ".join(f"{value:.17g}" for value in values)
