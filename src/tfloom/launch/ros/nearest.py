"""The nearest names for a package or a program that isn't there."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.utilities.nearest import did_you_mean
from tfloom.workspace import index
from tfloom.workspace.unsourced import how_to_find

__all__ = ["nearest_packages", "nearest_programs"]


def nearest_packages(package: str) -> str:
    """Return the package of the nearest name as a text; empty if none is near, or a workspace here has the package."""
    if how_to_find(package):
        return ""  # the error says how already
    return did_you_mean(package, {*index.workspace_packages(), *index.own_packages()})


def nearest_programs(program: str, known: Iterable[str]) -> str:
    """Return the program of the nearest name as a text, else all of the package."""
    names = sorted(set(known))
    if near := did_you_mean(program, names):
        return near
    return f"; its programs are {', '.join(names)}" if names else "; it has no programs"
