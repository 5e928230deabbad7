"""The matcher of lifecycle nodes, by its former place."""

from __future__ import annotations

import warnings
from collections.abc import Callable

from tfloom.launch.ros.events.matchers import NamedNode
from tfloom.launch.ros.events.matchers import matches_node_name as matches_any_node_name

__all__ = ["matches_node_name"]


def matches_node_name(node_name: str) -> Callable[[NamedNode], bool]:
    """Return `launch_ros.events.matches_node_name(node_name)`, with a warning that this place is deprecated."""
    warnings.warn(
        "The 'launch_ros.events.lifecycle.matches_node_name' function is deprecated. Please use "
        "'launch_ros.events.matches_node_name' instead.",
        stacklevel=2,
    )
    return matches_any_node_name(node_name)
