"""What happens in a sweep, as lines of JSON that several processes write and a display reads."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any


class Events:
    """Lines of JSON that tell what happens, for whoever shows progress.

    Parameters
    ----------
    path : Path
        File to add lines to; its folder is made.
    """

    def __init__(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self.path = path

    def tell(self, event: str, **facts: Any) -> None:
        """Add a line; it is written in one piece, also when several processes write."""
        line = json.dumps({"event": event, **facts}) + "\n"
        handle = os.open(self.path, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o644)
        try:
            os.write(handle, line.encode())
        finally:
            os.close(handle)
