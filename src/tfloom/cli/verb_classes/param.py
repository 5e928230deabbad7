"""The verbs of `ros2 param` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["DeleteVerb", "DescribeVerb", "DumpVerb", "GetVerb", "ListVerb", "LoadVerb", "SetVerb"]


class DeleteVerb(BuiltinVerb):
    """Delete a parameter."""

    MODULE = "tfloom.cli.param.delete"


class DescribeVerb(BuiltinVerb):
    """Print the descriptions and constraints of parameters."""

    MODULE = "tfloom.cli.param.describe"


class DumpVerb(BuiltinVerb):
    """Print all parameters of a node as YAML."""

    MODULE = "tfloom.cli.param.dump"


class GetVerb(BuiltinVerb):
    """Print a parameter's value."""

    MODULE = "tfloom.cli.param.get"


class ListVerb(BuiltinVerb):
    """List the parameters of a node, or of all nodes."""

    MODULE = "tfloom.cli.param.list"


class LoadVerb(BuiltinVerb):
    """Set a node's parameters from a YAML file."""

    MODULE = "tfloom.cli.param.load"


class SetVerb(BuiltinVerb):
    """Set a parameter."""

    MODULE = "tfloom.cli.param.set"
