"""The verbs of `ros2 node` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["InfoVerb", "ListVerb"]


class InfoVerb(BuiltinVerb):
    """Print what a node publishes, subscribes to, serves and calls."""

    MODULE = "tfloom.cli.node.info"


class ListVerb(BuiltinVerb):
    """List the nodes that are running."""

    MODULE = "tfloom.cli.node.list"
