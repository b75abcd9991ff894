"""Simulation of orthogonal cutting with bonded discs (DEM) and material points (MPM)."""

from importlib.metadata import version

__version__ = version("orthocut")
