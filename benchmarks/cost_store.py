"""How well the cost model predicts the results of a store: quantiles of predicted over measured run time by kind.

Measured is wall time, whatever else the machine did. Predictions are scaled by the median of their kind, as the
workflow does once a store holds results of it.
"""

from __future__ import annotations

import argparse
import csv
import json
from collections import defaultdict
from pathlib import Path

import netCDF4
import numpy as np

from orthocut.cost import estimate_seconds, seconds_of
from orthocut.io.store import Store
from orthocut.params.case import Case, validate
from orthocut.params.identity import digest_numbers

HEADER = ["kind", "which", "cases", "median [-]", "5 % [-]", "95 % [-]", "within 25 % of the median [%]"]


def main() -> None:
    """Compare and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("store", type=Path, nargs="?", default=Path("results/store"), help="folder of results")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/cost_store.csv"))
    options = parser.parse_args()
    ratios: dict[tuple[str, str], list[float]] = defaultdict(list)
    for key in Store(options.store).names():
        if not key.endswith(digest_numbers("_".join(key.split("-")[:2]))[:8]):
            continue
        found = read(options.store / f"{key}.nc")
        if found is None:
            continue
        case, steps, seconds = found
        ratios[case.kind, "steps known"].append(seconds_of(case, steps) / seconds)
        early = "may end early" if getattr(case, "error_target", 0) else "before the run"
        ratios[case.kind, early].append(estimate_seconds(case) / seconds)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for (kind, which), values in sorted(ratios.items()):
            writer.writerow([kind, which, len(values), *summary(np.array(values))])
    print(options.output.read_text(encoding="utf-8"))


def read(file: Path) -> tuple[Case, int, float] | None:
    """Case, steps and run time [s] of a result; None if it failed."""
    with netCDF4.Dataset(file) as result:
        if result.status != "done":
            return None
        return validate(json.loads(result.case), file.name), int(result.steps), float(result.wall_time_s)


def summary(values: np.ndarray) -> list[str]:
    """Median, quantiles over it, and how many lie near it."""
    scaled = values / np.median(values)
    low, high = np.quantile(scaled, [0.05, 0.95])
    near = 100 * np.mean(np.abs(scaled - 1) < 0.25)
    return [f"{np.median(values):.2f}", f"{low:.2f}", f"{high:.2f}", f"{near:.0f}"]


if __name__ == "__main__":
    main()
