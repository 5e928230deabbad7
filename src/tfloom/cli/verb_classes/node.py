"""The verbs of `ros2 node` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["InfoVerb", "ListVerb"]


class InfoVerb(BuiltinVerb, module="tfloom.cli.node.info"):
    """Print what a node publishes, subscribes to, serves and calls."""


class ListVerb(BuiltinVerb, module="tfloom.cli.node.list"):
    """List the nodes that are running."""
