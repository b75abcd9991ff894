"""What running batches report: lines of JSON that their workers add to files, from this machine or another."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any


class Feed:
    """Reads what is new in the files of the batches that run.

    Parameters
    ----------
    folder : str or Path
        Folder of the files, one a batch.
    """

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder)
        self._offsets: dict[Path, int] = {}

    def follow(self, batch: str) -> None:
        """Read the file of a batch from its present end on: what stands there is of an earlier run."""
        path = self.folder / f"{batch}.jsonl"
        self._offsets[path] = path.stat().st_size if path.exists() else 0

    def news(self) -> list[dict[str, Any]]:
        """Events since the last call; lines that are not whole yet wait for the next one."""
        events = []
        for path, offset in self._offsets.items():
            try:
                with open(path, "rb") as file:
                    file.seek(offset)
                    text, newline, _ = file.read().rpartition(b"\n")
            except OSError:
                continue
            self._offsets[path] = offset + len(text) + len(newline)
            events += [event for event in map(_parsed, text.split(b"\n")) if event]
        return events


def _parsed(line: bytes) -> dict[str, Any]:
    """Event of a line; empty if the line is damaged."""
    try:
        event = json.loads(line)
    except ValueError:
        return {}
    return event if isinstance(event, dict) and "event" in event else {}
