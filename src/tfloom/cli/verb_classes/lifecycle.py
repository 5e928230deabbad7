"""The verbs of `ros2 lifecycle` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["GetVerb", "ListVerb", "NodesVerb", "SetVerb"]


class GetVerb(BuiltinVerb):
    """Print the state of a lifecycle node, or of all."""

    MODULE = "tfloom.cli.lifecycle.get"


class ListVerb(BuiltinVerb):
    """List the transitions that are available on a lifecycle node."""

    MODULE = "tfloom.cli.lifecycle.list"


class NodesVerb(BuiltinVerb):
    """List the nodes that have a lifecycle."""

    MODULE = "tfloom.cli.lifecycle.nodes"


class SetVerb(BuiltinVerb):
    """Request a transition of a lifecycle node."""

    MODULE = "tfloom.cli.lifecycle.set"
