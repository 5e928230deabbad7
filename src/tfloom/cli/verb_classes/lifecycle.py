"""The verbs of `ros2 lifecycle` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["GetVerb", "ListVerb", "NodesVerb", "SetVerb"]


class GetVerb(BuiltinVerb, module="tfloom.cli.lifecycle.get"):
    """Print the state of a lifecycle node, or of all."""


class ListVerb(BuiltinVerb, module="tfloom.cli.lifecycle.list"):
    """List the transitions that are available on a lifecycle node."""


class NodesVerb(BuiltinVerb, module="tfloom.cli.lifecycle.nodes"):
    """List the nodes that have a lifecycle."""


class SetVerb(BuiltinVerb, module="tfloom.cli.lifecycle.set"):
    """Request a transition of a lifecycle node."""
