"""How many packings a sweep needs for the mean of their cutting forces to be known to a share of it."""

from __future__ import annotations

import math
from typing import Any

from orthocut.params.accuracy import evidence, percent
from orthocut.params.block import fault, show

KIND = "dem_cutting"
"""The kind of cases whose scatter is known."""
LEVEL = 0.95
MOST = 1000


def packings(share: float) -> int:
    """Fewest packings whose 95 % interval of the mean main force is expected to keep to a share of it, either way.

    Parameters
    ----------
    share : float
        Half-width over the mean [-].

    Raises
    ------
    PydanticCustomError
        If more than `MOST` are needed.
    """
    from scipy.special import stdtrit  # slow to import, and most studies do without

    scatter = evidence()["glass"]["scatter"]
    for count in range(2, MOST + 1):
        if float(stdtrit(count - 1, 0.5 + 0.5 * LEVEL)) * scatter <= share * math.sqrt(count):
            return count
    least = 1.97 * scatter / math.sqrt(MOST)
    raise fault(
        f"replicates = {100 * share:g} %: takes more than {MOST} packings (allowed: {math.ceil(1e3 * least) / 10:g} % "
        "or more)"
    )


def counted(replicates: Any, kind: Any) -> Any:
    """Replicates as a number, where a share is given; anything else as it is.

    Raises
    ------
    PydanticCustomError
        If nothing is known of the scatter of this kind of cases.
    """
    share = percent(replicates)
    if share is None:
        return replicates
    if kind not in (KIND, "dem"):
        raise fault(f"replicates = {show(replicates)}: the scatter of {show(kind)} is not known (allowed: a number)")
    return packings(share)
