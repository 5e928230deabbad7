"""Extensions: classes behind entry points, their versions, and the order in which they are listed."""

from __future__ import annotations

import logging
from collections import OrderedDict
from collections.abc import Callable, Iterable
from typing import Any

from tfloom.cli.plugins.entry_points import load_entry_points

__all__ = [
    "PLUGIN_SYSTEM_VERSION",
    "PluginException",
    "get_upper_bound_caret_version",
    "instantiate_extensions",
    "order_extensions",
    "order_extensions_by_name",
    "satisfies_version",
]

PLUGIN_SYSTEM_VERSION = "0.1"
"""The version of the interface between the command and its extensions."""

_logger = logging.getLogger("ros2cli.plugin_system")
_instances: dict[type[Any], Any] = {}


class PluginException(Exception):
    """An extension can't be used with this command."""


def instantiate_extensions(
    group_name: str, *, exclude_names: Iterable[str] | None = None, unique_instance: bool = False
) -> dict[str, Any]:
    """Return an object of each extension of a group, by name; one that can't be created is a warning.

    Args:
        group_name: Group of the entry points.
        exclude_names: Names of those that are left out.
        unique_instance: Whether each call creates new objects; otherwise later calls return those of the first.
    """
    excluded = set(exclude_names or ())
    extensions: dict[str, Any] = {}
    for name, extension_class in load_entry_points(group_name).items():
        if name in excluded:
            continue
        try:
            extensions[name] = _instance(extension_class, name, unique_instance)
        except Exception as error:
            _logger.warning(
                "Failed to instantiate extension '%s' of %s: %s: %s",
                name,
                group_name,
                type(error).__name__,
                error,
            )
    return extensions


def _instance(extension_class: type[Any], name: str, unique_instance: bool) -> Any:
    if not unique_instance and extension_class in _instances:
        return _instances[extension_class]
    extension = extension_class()
    extension.NAME = name
    if not unique_instance:
        _instances[extension_class] = extension
    return extension


def order_extensions(
    extensions: dict[str, Any], key_function: Callable[[tuple[str, Any]], Any], *, reverse: bool = False
) -> OrderedDict[str, Any]:
    """Return extensions in the order of a key of their names and objects."""
    return OrderedDict(sorted(extensions.items(), key=key_function, reverse=reverse))


def order_extensions_by_name(extensions: dict[str, Any]) -> OrderedDict[str, Any]:
    """Return extensions in the order of their names."""
    return order_extensions(extensions, lambda item: item[0])


def satisfies_version(version: str, caret_range: str) -> None:
    """Check a version against a range: `^0.1` is at least 0.1, and below 0.2.

    Raises:
        PluginException: the version is too small, or too large.
    """
    least = _numbers(caret_range.removeprefix("^"))
    end = get_upper_bound_caret_version(least)
    if _numbers(version) < least:
        raise PluginException(f"Extension point version '{version}' is too small for '{caret_range}'")
    if _numbers(version) >= end:
        raise PluginException(f"Extension point version '{version}' is too large for '{caret_range}'")


def get_upper_bound_caret_version(version: tuple[int, ...]) -> tuple[int, ...]:
    """Return the first version beyond a caret's range: the number before the first one above 0 is what stays."""
    for place, number in enumerate(version):
        if number:
            return (*version[:place], number + 1, *(0 for _ in version[place + 1 :]))
    return (*version[:-1], 1)


def _numbers(version: str) -> tuple[int, ...]:
    try:
        numbers = tuple(int(part) for part in version.split("."))
    except ValueError:
        raise PluginException(f"'{version}' is not a version such as {PLUGIN_SYSTEM_VERSION}") from None
    return (*numbers, 0, 0)[:3]
