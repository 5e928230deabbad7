"""The entry points of installed packages, by which they extend the command.

Heavy modules are imported inside functions, because each help text looks for entry points, and most find none.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from importlib import metadata

__all__ = [
    "EXTENSION_POINT_GROUP_NAME",
    "get_all_entry_points",
    "get_entry_points",
    "get_first_line_doc",
    "load_entry_points",
]

EXTENSION_POINT_GROUP_NAME = "ros2cli.extension_point"
"""The group in which packages register the groups that others may extend."""


def get_all_entry_points() -> dict[str, dict[str, tuple[metadata.Distribution, metadata.EntryPoint]]]:
    """Return the entry points of the groups that packages have registered, by group and name."""
    from importlib import metadata

    groups = {EXTENSION_POINT_GROUP_NAME, *get_entry_points(EXTENSION_POINT_GROUP_NAME)}
    found: dict[str, dict[str, tuple[metadata.Distribution, metadata.EntryPoint]]] = {}
    for distribution in metadata.distributions():
        for entry_point in distribution.entry_points:
            if entry_point.group in groups:
                found.setdefault(entry_point.group, {})[entry_point.name] = (distribution, entry_point)
    return found


def get_entry_points(group_name: str) -> dict[str, metadata.EntryPoint]:
    """Return the entry points of a group by name; of several with one name, the first on the path."""
    from importlib import metadata

    found: dict[str, metadata.EntryPoint] = {}
    for entry_point in metadata.entry_points(group=group_name):
        found.setdefault(entry_point.name, entry_point)
    return found


def load_entry_points(group_name: str) -> dict[str, Any]:
    """Return what the entry points of a group stand for, by name; one that can't be loaded is a warning."""
    import logging

    loaded: dict[str, Any] = {}
    for name, entry_point in get_entry_points(group_name).items():
        try:
            loaded[name] = entry_point.load()
        except Exception as error:
            logging.getLogger("ros2cli.entry_points").warning(
                "Failed to load entry point '%s' of %s: %s: %s", name, group_name, type(error).__name__, error
            )
    return loaded


def get_first_line_doc(any_type: Any) -> str:
    """Return the first line of an object's docstring, without the full stop; empty if it has none."""
    import inspect

    lines = (inspect.getdoc(any_type) or "").strip().splitlines()
    return lines[0].rstrip(".") if lines else ""
