"""The verbs of `ros2 param` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["DeleteVerb", "DescribeVerb", "DumpVerb", "GetVerb", "ListVerb", "LoadVerb", "SetVerb"]


class DeleteVerb(BuiltinVerb, module="tfloom.cli.param.delete"):
    """Delete a parameter."""


class DescribeVerb(BuiltinVerb, module="tfloom.cli.param.describe"):
    """Print the descriptions and constraints of parameters."""


class DumpVerb(BuiltinVerb, module="tfloom.cli.param.dump"):
    """Print all parameters of a node as YAML."""


class GetVerb(BuiltinVerb, module="tfloom.cli.param.get"):
    """Print a parameter's value."""


class ListVerb(BuiltinVerb, module="tfloom.cli.param.list"):
    """List the parameters of a node, or of all nodes."""


class LoadVerb(BuiltinVerb, module="tfloom.cli.param.load"):
    """Set a node's parameters from a YAML file."""


class SetVerb(BuiltinVerb, module="tfloom.cli.param.set"):
    """Set a parameter."""
