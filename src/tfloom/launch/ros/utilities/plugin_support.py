"""Versions of the interface that extensions of `Node` are written for."""

from __future__ import annotations

from tfloom.ros_imports.guard import ros_home

__all__ = ["PluginException", "get_upper_bound_caret_version", "satisfies_version"]


class PluginException(Exception):  # the name that extensions catch
    """An extension can't be used."""

    __module__ = ros_home("launch_ros.utilities.plugin_support", __name__)


def satisfies_version(version: str, caret_range: str) -> bool:
    """Return whether a version is one that `^MAJOR.MINOR` accepts: this one or a later one that is compatible.

    Raises:
        ValueError: the range does not begin with `^`.
    """
    if not caret_range.startswith("^"):
        raise ValueError(f"expected a version range like '^0.1', got '{caret_range}'")
    lowest = caret_range.removeprefix("^")
    return _numbers(lowest) <= _numbers(version) < _numbers(get_upper_bound_caret_version(lowest))


def get_upper_bound_caret_version(version: str) -> str:
    """Return the first later version that is not compatible: 2.0 for 1.3, 0.4 for 0.3."""
    numbers = _numbers(version)
    changed = next((place for place, number in enumerate(numbers) if number), len(numbers) - 1)
    upper = [*numbers[:changed], numbers[changed] + 1, *(0 for _ in numbers[changed + 1 :])]
    return ".".join(map(str, upper))


def _numbers(version: str) -> tuple[int, ...]:
    return tuple(int(number) for number in version.split("."))
