"""Extensions of `Node` by the entry points `launch_ros.node_action` of user packages, and the versions they are for."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.ros_imports.distributions import may_have_entry_points
from tfloom.ros_imports.guard import ros_home

if TYPE_CHECKING:
    from logging import Logger

__all__ = [
    "GROUP",
    "NodeActionExtension",
    "PluginException",
    "get_extensions",
    "get_upper_bound_caret_version",
    "instantiate_extension",
    "satisfies_version",
]


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


GROUP = "launch_ros.node_action"
"""The group of the entry points."""


class NodeActionExtension:
    """The base class of extensions, which change how nodes are started.

    Raises:
        PluginException: the class is written for another version of this interface.
    """

    NAME: str | None = None
    EXTENSION_POINT_VERSION = "0.1"

    def __init__(self) -> None:
        super().__init__()
        if not satisfies_version(self.EXTENSION_POINT_VERSION, "^0.1"):
            raise PluginException(
                f"{type(self).__name__} is written for version {self.EXTENSION_POINT_VERSION} of the extensions of "
                "Node, and this one is 0.1"
            )

    def prepare_for_execute(
        self, context: LaunchContext, ros_specific_arguments: dict[str, Any], node_action: Any
    ) -> tuple[list[Any], dict[str, Any]]:
        """Return more words of the command line, and the ROS arguments, before a node is started.

        Args:
            context: The launch.
            ros_specific_arguments: `name` and `ns`, as `__node:=…` and `__ns:=…`.
            node_action: The Node.
        """
        return [], ros_specific_arguments


def instantiate_extension(
    group_name: str,
    extension_name: str,
    extension_class: type[NodeActionExtension],
    extensions: dict[str, NodeActionExtension],
    logger: Logger,
    *,
    unique_instance: bool = False,
) -> NodeActionExtension | None:
    """Return an instance of an extension; None, with a log entry, if it can't be created.

    Args:
        group_name: Group of its entry point.
        extension_name: Name of its entry point.
        extension_class: Its class.
        extensions: The existing instances by name; the new one is added.
        logger: Logs the failure.
        unique_instance: Whether the existing instances are left alone.
    """
    if not unique_instance and extension_name in extensions:
        return extensions[extension_name]
    try:
        instance = extension_class()
    except PluginException as error:
        logger.warning("Failed to instantiate '%s' extension '%s': %s", group_name, extension_name, error)
        return None
    except Exception:  # a program's own code
        logger.exception("Exception instantiating '%s' extension '%s':", group_name, extension_name)
        return None
    if not unique_instance:
        extensions[extension_name] = instance
    return instance


def get_extensions(logger: Logger) -> dict[str, NodeActionExtension]:
    """Return the instances of all installed extensions, by name."""
    extensions: dict[str, NodeActionExtension] = {}
    for entry_point in _entry_points():
        try:
            extension_class = entry_point.load()
        except Exception as error:  # a program's own code
            logger.warning("Failed to load entry point '%s': %r", entry_point.name, error)
            continue
        extension_class.NAME = entry_point.name
        instantiate_extension(GROUP, entry_point.name, extension_class, extensions, logger)
    return extensions


@functools.cache
def _entry_points() -> tuple[Any, ...]:
    """Return the entry points; they are looked up once, because that reads a file of each installed package."""
    if not may_have_entry_points(GROUP):
        return ()
    from importlib.metadata import entry_points

    return tuple(entry_points(group=GROUP))
