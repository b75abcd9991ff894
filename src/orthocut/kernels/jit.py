"""The one place that sets the flags of the just-in-time compiler and the folder of compiled code.

Allowed are contraction of a multiplication and an addition into one rounding, reassociation, reciprocals and unsigned
zeros, so that loops vectorise. Not allowed is to assume that no value is infinite or NaN: the solvers test for
diverging values.

numba's cache keeps a caller's old code after an edit to a law that it imports. The folder of compiled code therefore
carries a digest of all kernel sources.
"""

import hashlib
import os
from pathlib import Path

import numba


def _cache_folder() -> str:
    sha = hashlib.sha256()
    root = Path(__file__).resolve().parent
    for file in sorted(root.rglob("*.py")):
        sha.update(str(file.relative_to(root)).encode() + b"\0" + file.read_bytes() + b"\0")
    home = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return str(Path(home) / "orthocut" / "kernels" / sha.hexdigest()[:16])


numba.config.CACHE_DIR = _cache_folder()

FAST_MATH = {"reassoc", "nsz", "arcp", "contract"}

jit = numba.njit(cache=True, fastmath=FAST_MATH, error_model="numpy")
"""Decorator of loops over particles, bonds and nodes."""

part = numba.njit(cache=True, forceinline=True, fastmath=FAST_MATH, error_model="numpy")
"""Decorator of loops that other compiled functions call: they become part of their caller in machine code.

A call that is not inlined is bound to the callee's own code after a fresh compilation, but to the caller's copy of it
when the caller comes from the cache. Both were optimised apart and may round differently, so that a first and a second
run of the same case would differ in their bits.
"""

inline = numba.njit(inline="always", fastmath=FAST_MATH, error_model="numpy")
"""Decorator of small laws: they become part of the loop that calls them, so that it vectorises."""
