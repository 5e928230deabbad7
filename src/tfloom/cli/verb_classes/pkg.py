"""The verbs of `ros2 pkg` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["CreateVerb", "ExecutablesVerb", "ListVerb", "PrefixVerb", "XmlVerb"]


class CreateVerb(BuiltinVerb):
    """Create a package in a workspace."""

    MODULE = "tfloom.cli.pkg.create"


class ExecutablesVerb(BuiltinVerb):
    """List the programs that `run` finds."""

    MODULE = "tfloom.cli.pkg.executables"


class ListVerb(BuiltinVerb):
    """List the packages."""

    MODULE = "tfloom.cli.pkg.list"


class PrefixVerb(BuiltinVerb):
    """Print where a package is installed."""

    MODULE = "tfloom.cli.pkg.prefix"


class XmlVerb(BuiltinVerb):
    """Print a package's package.xml, or a tag of it."""

    MODULE = "tfloom.cli.pkg.xml"
