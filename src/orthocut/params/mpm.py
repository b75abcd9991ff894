"""Case of a ductile cut with material points (Nairn 2015)."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field, model_validator

from orthocut.params.block import Block, fault
from orthocut.params.cohesive import CohesiveZone
from orthocut.params.material import ElasticPlastic
from orthocut.params.quantity import Number, Quantity
from orthocut.params.tool import Tool

LEAST_REACH = 4.0
"""Least distance ahead of the tool over depth of cut beyond which material may rest."""
LEAST_WINDOW = 3.0
"""Travel over depth of cut that averages take at least before a cut ends early."""


class Workpiece(Block):
    """Strip of material in multiples of the depth of cut; its bottom is clamped."""

    length_ratio: Annotated[float, Number(6.0, 200.0)] = 16.0
    """Length of the workpiece over depth of cut (w)."""
    base_ratio: Annotated[float, Number(0.5, 20.0)] = 3.0
    """Depth of material below the cut over depth of cut (d)."""
    notch_ratio: Annotated[float, Number(0.5, 20.0)] = 2.0
    """Length of the traction-free notch over depth of cut."""
    path_ratio: Annotated[float, Number(0.0, 200.0)] = 0.0
    """Length of notch and cohesive path over depth of cut, beyond which the workpiece is whole; 0 for all of it."""
    bottom: Literal["clamped", "silent"] = "clamped"
    """Bottom of the base: held, or on dashpots that absorb waves."""


class MpmNumerics(Block):
    """Discretisation in space and time."""

    points_per_depth: Annotated[int, Number(2, 60, integer=True)] = 10
    """Material points through the depth of cut."""
    points_per_cell: Annotated[int, Number(1, 4, integer=True)] = 2
    """Material points along each side of a cell."""
    grid_offset: Annotated[float, Number(0.0, 0.9)] = 0.25
    """Height of the row of nodes next above the cut over the cell size; 0 has a row on the cut, as in the paper."""
    courant: Annotated[float, Number(0.01, 1.0)] = 0.5
    """Time step over the time a pressure wave needs for a cell."""
    affine: Annotated[float, Number(0.0, 1.0)] = 1.0
    """Share of the velocity gradient that points hand on to the next grid; 0 is PIC, 1 keeps linear velocity fields."""
    support: Annotated[float, Number(0.0, 0.25)] = 0.05
    """Share of the mass of a full cell below which a node follows nodes that have more; 0 for none, as in the paper."""
    reach_ratio: Annotated[float, Number(0.0, 200.0)] = 8.0
    """Distance ahead of the tool over depth of cut beyond which material rests, behind it half; 0: all of it moves."""
    scheme: Literal["consistent", "usavg"] = "consistent"
    """Loop of a step: one velocity extrapolation (consistent), or that of the paper's program (usavg)."""
    flip: Annotated[float, Number(0.0, 1.0)] = 0.0
    """Share of a point's own velocity that usavg keeps beside that of the grid: 0 is PIC, 1 is FLIP."""
    position_order: Annotated[int, Number(0, 2, integer=True)] = 2
    """Order of the update of positions of usavg: 0 for Nairn (2015), eq (9), 1 or 2 for eq (10)."""
    contact: Literal["exact", "cells"] = "exact"
    """How contact with the tool is found: by exact geometry, or by the paper's rule of 0.8 cells (cells)."""
    ramp_fraction: Annotated[float, Number(0.01, 0.9)] = 0.3
    """Fraction of the duration in which the tool speeds up linearly, with feedback damping."""
    ramp_feedback: Annotated[float, Quantity("m^-2", "0 mm^-2", "1000 mm^-2", "mm^-2")] = 10e6
    """Gain of the feedback damping on the kinetic energy of the grid during the ramp."""

    @model_validator(mode="after")
    def _used(self) -> MpmNumerics:
        if 0.0 < self.reach_ratio < LEAST_REACH:
            raise fault(
                f"reach_ratio = {self.reach_ratio:g} holds material that the tool deforms "
                f"(allowed: 0, or at least {LEAST_REACH:g})"
            )
        if self.scheme == "usavg":
            allowed, otherwise = dict.fromkeys(("affine", "support", "reach_ratio"), 0.0), ""
        else:
            allowed = {name: type(self).model_fields[name].default for name in ("flip", "position_order")}
            otherwise = ", or scheme = usavg"
        faults = [
            f"{name} = {getattr(self, name):g} is of no use with scheme = {self.scheme} (allowed: {value:g}{otherwise})"
            for name, value in allowed.items()
            if getattr(self, name) != value
        ]
        if faults:
            raise fault("; ".join(faults))
        return self


class MpmCutting(Block):
    """Orthogonal cut of a ductile workpiece along a cohesive path."""

    kind: Literal["mpm_cutting"] = "mpm_cutting"
    cut_depth: Annotated[float, Quantity("m", "0.02 mm", "20 mm", "mm")] = 0.9e-3
    """Depth of cut h."""
    cut_speed: Annotated[float, Quantity("m/s", "0.05 m/s", "100 m/s")] = 5.0
    """Speed of the tool after the ramp."""
    travel_ratio: Annotated[float, Number(1.0, 180.0)] = 11.0
    """Travel of the tool over depth of cut, at most."""
    window_ratio: Annotated[float, Number(0.0, 180.0)] = 6.0
    """Travel over depth of cut from which steady-state averages are taken."""
    window: Literal["detected", "fixed"] = "detected"
    """Whether averages leave out a start of the window that differs from the rest."""
    error_target: Annotated[float, Number(0.0, 0.2)] = 0.0
    """Relative standard error of the cutting force at which a steady cut ends before its travel is over; 0: never."""
    tool: Tool = Field(default_factory=Tool)
    material: ElasticPlastic = Field(default_factory=ElasticPlastic)
    interface: CohesiveZone = Field(default_factory=CohesiveZone)
    workpiece: Workpiece = Field(default_factory=Workpiece)
    numerics: MpmNumerics = Field(default_factory=MpmNumerics)

    @model_validator(mode="after")
    def _consistent(self) -> MpmCutting:
        limit = self.workpiece.length_ratio - 3.0
        if self.travel_ratio > limit:
            raise fault(
                f"travel_ratio = {self.travel_ratio:g} ends less than 3 depths of cut before the far edge "
                f"(allowed: up to {limit:g})"
            )
        if self.workpiece.bottom == "silent":
            if self.numerics.scheme == "usavg":
                raise fault("workpiece.bottom = silent does not go with numerics.scheme = usavg (allowed: clamped)")
            if self.numerics.reach_ratio:
                raise fault(
                    f"numerics.reach_ratio = {self.numerics.reach_ratio:g} would hold a base on dashpots "
                    "(allowed: 0, or workpiece.bottom = clamped)"
                )
        path, notch = self.workpiece.path_ratio, self.workpiece.notch_ratio
        if 0.0 < path <= max(notch, self.travel_ratio):
            raise fault(
                f"workpiece.path_ratio = {path:g} ends before the tool does or leaves nothing to break "
                f"(allowed: 0, or more than travel_ratio = {self.travel_ratio:g} and notch_ratio = {notch:g})"
            )
        if self.window_ratio >= self.travel_ratio:
            raise fault(
                f"window_ratio = {self.window_ratio:g} leaves no travel for averages "
                f"(allowed: less than travel_ratio = {self.travel_ratio:g})"
            )
        return self

    @property
    def duration(self) -> float:
        """Time the tool needs for its travel, ramp included [s]."""
        return self.travel_ratio * self.cut_depth / (self.cut_speed * (1.0 - 0.5 * self.numerics.ramp_fraction))

    @property
    def cell(self) -> float:
        """Cell size [m]."""
        return self.numerics.points_per_cell * self.cut_depth / self.numerics.points_per_depth

    @property
    def steps(self) -> int:
        """Number of time steps: enough for a Courant number times the largest stable step, about, and at least 500.

        That step is the smaller one of pressure waves and of the interface, which couples two layers of nodes, each of
        half a cell's mass, by its initial stiffness, with the frequency 2 sqrt(stiffness/(density cell)).
        """
        wave = self.cell / self.material.speed_pressure_wave
        spring = math.sqrt(self.material.density * self.cell / self.interface.stiffness)
        return max(math.ceil(self.duration / (self.numerics.courant * min(wave, spring))), 500)

    @property
    def time_step(self) -> float:
        """Time step; all steps together are the duration [s]."""
        return self.duration / self.steps
