"""The verbs of `ros2 pkg` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["CreateVerb", "ExecutablesVerb", "ListVerb", "PrefixVerb", "XmlVerb"]


class CreateVerb(BuiltinVerb, module="tfloom.cli.pkg.create"):
    """Create a package in a workspace."""


class ExecutablesVerb(BuiltinVerb, module="tfloom.cli.pkg.executables"):
    """List the programs that `run` finds."""


class ListVerb(BuiltinVerb, module="tfloom.cli.pkg.list"):
    """List the packages."""


class PrefixVerb(BuiltinVerb, module="tfloom.cli.pkg.prefix"):
    """Print where a package is installed."""


class XmlVerb(BuiltinVerb, module="tfloom.cli.pkg.xml"):
    """Print a package's package.xml, or a tag of it."""
