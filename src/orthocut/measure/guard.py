"""A run that leaves the range of its own assumptions stops, with a diagnosis."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orthocut.params.block import CaseFailed

if TYPE_CHECKING:
    import xarray


class Diverged(CaseFailed):
    """The numbers of a run can no longer be trusted; the message says what was seen, when and what to try."""


def check_finite(dataset: xarray.Dataset) -> None:
    """Look for values in histories that are no finite numbers; padding has no time either.

    Parameters
    ----------
    dataset : xarray.Dataset
        A run, with ``time`` along ``sample``.

    Raises
    ------
    Diverged
        Names the history, the sample and its time.
    """
    time = dataset["time"].values
    used = np.isfinite(time)
    if not used.any():
        raise Diverged("the run has no samples with a finite time")
    for name, history in dataset.data_vars.items():
        if history.dims == ("sample",):
            bad = np.flatnonzero(used & ~np.isfinite(history.values))
            if bad.size:
                value = history.values[bad[0]]
                raise Diverged(f"{name} is {value} at time {time[bad[0]]:.4g} s, sample {bad[0]} of {used.sum()}")
