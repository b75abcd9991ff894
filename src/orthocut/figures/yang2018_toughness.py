"""Toughness of the synthetic glass of Yang et al. (2018), which the paper neither states nor calibrates."""

from __future__ import annotations

import math

import xarray as xr
from matplotlib.figure import Figure

from orthocut.figures.canvas import PAGE, nothing, page, styled
from orthocut.figures.confidence import interval
from orthocut.figures.palette import BLACK, SERIES
from orthocut.figures.tables import Table
from orthocut.figures.yang2018_runs import GlassRun, material_words, runs_of
from orthocut.variables import VARIABLES

CAPTION = (
    "Fracture toughness of the synthetic glass from the largest stress of plates with a central crack, against the "
    "length of the crack (dots, one a packing; bars: mean and its 95 % confidence interval by Student's t), and of "
    "soda-lime glass. It rises with the root of the size of the discs, which the other properties do not depend on."
)
DIMS = ()
GLASS = 0.75
"""Fracture toughness of soda-lime glass in dry air [MPa m^0.5] (Wiederhorn 1969)."""
Series = dict[tuple[str, float], dict[float, list[GlassRun]]]


def measured(dataset: xr.Dataset) -> Series:
    """Tests by material and smallest radius [um], then by length of the crack over width."""
    found: Series = {}
    for run in runs_of(dataset, "dem_toughness", "toughness_fracture"):
        key = material_words(run), round(1e6 * run.case.packing.radius_min, 6)
        found.setdefault(key, {}).setdefault(run.case.crack_ratio, []).append(run)
    return {key: dict(sorted(found[key].items())) for key in sorted(found)}


def moduli(dataset: xr.Dataset) -> dict[tuple[str, float], float]:
    """Mean Young's modulus by material and smallest radius [GPa]."""
    found: dict[tuple[str, float], list[float]] = {}
    for run in runs_of(dataset, "dem_tension", "modulus_young"):
        key = material_words(run), round(1e6 * run.case.packing.radius_min, 6)
        found.setdefault(key, []).append(run["modulus_young"])
    return {key: interval(values).mean for key, values in found.items()}


@styled
def draw(dataset: xr.Dataset) -> Figure:
    """One series a material and size of discs."""
    figure = page(2.9, 0.7 * PAGE)
    ax = figure.subplots()
    found = measured(dataset)
    if not found:
        nothing(ax)
        return figure
    for number, (((material, radius), series), colour) in enumerate(zip(found.items(), SERIES, strict=False)):
        shift = 0.008 * (number - 0.5 * (len(found) - 1))
        for ratio, runs in series.items():
            values = [run["toughness_fracture"] for run in runs]
            known = interval(values)
            ax.plot([ratio + shift] * len(values), values, "o", color=colour, ms=3, alpha=0.5, mew=0)
            bar = known.half if math.isfinite(known.half) else None
            label = f"{material}, R from {radius:g} µm" if ratio == min(series) else None
            ax.errorbar(ratio + shift, known.mean, yerr=bar, fmt="_", color=colour, capsize=2, label=label)
    ax.axhline(GLASS, color=BLACK, lw=0.8, label="soda-lime glass")
    length, toughness = VARIABLES["crack_ratio"], VARIABLES["toughness_fracture"]
    ax.set_xlabel(f"{length.long_name} ${length.symbol}$ [-]")
    ax.set_ylabel(f"fracture toughness ${toughness.symbol}$ [MPa m$^{{1/2}}$]")
    ax.set_ylim(bottom=0)
    figure.legend(loc="outside upper center", ncols=2)
    return figure


def tabulate(dataset: xr.Dataset) -> Table:
    """One row a material, size of discs and length of the crack, and one for all lengths."""
    header = ["material", "smallest radius [um]", "length of the crack over width [-]", "tests"]
    header += ["toughness [MPa m^0.5]", "95 % half-width [MPa m^0.5]", "over that of glass [-]"]
    header += ["energy release K^2/E [J/m^2]"]
    known = moduli(dataset)
    rows = []
    for key, series in measured(dataset).items():
        modulus = known.get(key, math.nan)
        for ratio, runs in [*series.items(), ("all", [run for some in series.values() for run in some])]:
            mean = interval([run["toughness_fracture"] for run in runs])
            release = 1e3 * mean.mean**2 / modulus  # (MPa m^0.5)^2 / GPa = 1e3 J/m^2
            rows.append([*key, ratio, mean.count, mean.mean, mean.half, mean.mean / GLASS, release])
    return Table("Fracture toughness of the synthetic glass", header, rows)
