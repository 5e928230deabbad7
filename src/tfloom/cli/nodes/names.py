"""Prefixes of the names of the command's own nodes."""

from __future__ import annotations

__all__ = ["HIDDEN_NODE_PREFIX", "NODE_NAME_PREFIX"]

HIDDEN_NODE_PREFIX = "_"
"""Nodes whose names begin with it are hidden."""
NODE_NAME_PREFIX = "_ros2cli"
"""The names of nodes that a command creates begin with it."""
