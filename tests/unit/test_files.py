"""Locks of folders of results."""

import subprocess
import sys

import pytest

from orthocut.io.files import hold

TRY = "import sys; from orthocut.io.files import hold; hold(sys.argv[1])"


def test_lock_holds_for_as_long_as_the_process_lives(tmp_path):
    """Also where nobody keeps what `hold` returns, as in `onstart` of a Snakefile."""
    path = tmp_path / ".lock"
    hold(path)
    other = subprocess.run([sys.executable, "-c", TRY, str(path)], capture_output=True, text=True, check=False)
    assert other.returncode != 0
    assert "in use by process" in other.stderr


def test_lock_ends_with_the_process(tmp_path):
    path = tmp_path / ".lock"
    subprocess.run([sys.executable, "-c", TRY, str(path)], check=True)
    hold(path)
    with pytest.raises(BlockingIOError, match="in use by"):
        hold(path)
