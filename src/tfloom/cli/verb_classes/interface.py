"""The verbs of `ros2 interface` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["ListVerb", "PackageVerb", "PackagesVerb", "ProtoVerb", "ShowVerb"]


class ListVerb(BuiltinVerb, module="tfloom.cli.interface.list"):
    """List the interfaces."""


class PackageVerb(BuiltinVerb, module="tfloom.cli.interface.package"):
    """List the interfaces of one package."""


class PackagesVerb(BuiltinVerb, module="tfloom.cli.interface.packages"):
    """List the packages that define interfaces."""


class ProtoVerb(BuiltinVerb, module="tfloom.cli.interface.proto"):
    """Print a YAML value with an interface's fields and defaults."""


class ShowVerb(BuiltinVerb, module="tfloom.cli.interface.show"):
    """Print an interface's definition."""
