"""How many packings a sweep needs for the mean of their cutting forces to be known to a share of it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from orthocut.params.accuracy import evidence, percent
from orthocut.params.accuracy_glass import row_of
from orthocut.params.block import fault, show
from orthocut.params.quantity import convert

KIND = "dem_cutting"
"""The kind of cases whose scatter is known."""
LEVEL = 0.95
MOST = 1000


def packings(share: float, speed: float | None = None) -> int:
    """Fewest packings whose 95 % interval of the mean main force is expected to keep to a share of it, either way.

    Parameters
    ----------
    share : float
        Half-width over the mean [-].
    speed : float, optional
        Speed of the tool [m/s]: slow cuts scatter most. Without it, the number is enough for any speed.

    Raises
    ------
    PydanticCustomError
        If more than `MOST` are needed.
    """
    from scipy.special import stdtrit  # slow to import, and most studies do without

    known = None if speed is None else row_of(speed)
    scatter = known["scatter"] if known else max(row["scatter"] for row in evidence()["glass"]["speed"])
    for count in range(2, MOST + 1):
        if float(stdtrit(count - 1, 0.5 + 0.5 * LEVEL)) * scatter <= share * math.sqrt(count):
            return count
    least = 1.97 * scatter / math.sqrt(MOST)
    raise fault(
        f"replicates = {100 * share:g} %: takes more than {MOST} packings (allowed: {math.ceil(1e3 * least) / 10:g} % "
        "or more)"
    )


def counted(replicates: Any, base: Mapping[str, Any]) -> Any:
    """Replicates as a number, where a share is given; anything else as it is.

    Parameters
    ----------
    base : mapping
        Raw fields of the case that is replicated.

    Raises
    ------
    PydanticCustomError
        If nothing is known of the scatter of this kind of cases.
    """
    share, kind = percent(replicates), base.get("kind")
    if share is None:
        return replicates
    if kind not in (KIND, "dem"):
        raise fault(f"replicates = {show(replicates)}: the scatter of {show(kind)} is not known (allowed: a number)")
    try:
        speed = convert(base.get("cut_speed"), "m/s")
    except (ValueError, TypeError):  # none, or none that a case may have, which is told where cases are checked
        speed = None
    return packings(share, speed)
