"""The names of the nodes that a launch has started."""

from __future__ import annotations

from collections import Counter

from tfloom.launch.launch_context import LaunchContext

__all__ = ["add_node_name", "get_node_name_count"]

_KEY = "unique_ros_node_names"


def add_node_name(context: LaunchContext, node_name: str) -> None:
    """Count a node of a full name."""
    _names(context)[node_name] += 1


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return the number of nodes that a launch has started with a full name."""
    return _names(context)[node_name]


def _names(context: LaunchContext) -> Counter[str]:
    if _KEY not in context.get_locals_as_dict():
        context.extend_globals({_KEY: Counter[str]()})
    names: Counter[str] = context.get_locals_as_dict()[_KEY]
    return names
