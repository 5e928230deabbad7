"""Matchers of actions of nodes."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Protocol

__all__ = ["NamedNode", "matches_lifecycle_node_name", "matches_node_name"]


class NamedNode(Protocol):
    """An action that starts a node, as events need it."""

    @property
    def node_name(self) -> str:
        """Full name of the node."""


def matches_node_name(node_name: str) -> Callable[[NamedNode], bool]:
    """Return a matcher of the action whose node has a name, which may lack the first slash."""
    full = node_name if node_name.startswith("/") else f"/{node_name}"
    return lambda action: action.node_name == full


def matches_lifecycle_node_name(node_name: str) -> Callable[[NamedNode], bool]:
    """Return `matches_node_name(node_name)`, with a warning that its place among lifecycle events is deprecated."""
    warnings.warn(
        "The 'launch_ros.events.lifecycle.matches_node_name' function is deprecated. Please use "
        "'launch_ros.events.matches_node_name' instead.",
        stacklevel=2,
    )
    return matches_node_name(node_name)
