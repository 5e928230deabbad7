"""The verbs of `ros2 interface` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["ListVerb", "PackageVerb", "PackagesVerb", "ProtoVerb", "ShowVerb"]


class ListVerb(BuiltinVerb):
    """List the interfaces."""

    MODULE = "tfloom.cli.interface.list"


class PackageVerb(BuiltinVerb):
    """List the interfaces of one package."""

    MODULE = "tfloom.cli.interface.package"


class PackagesVerb(BuiltinVerb):
    """List the packages that define interfaces."""

    MODULE = "tfloom.cli.interface.packages"


class ProtoVerb(BuiltinVerb):
    """Print a YAML value with an interface's fields and defaults."""

    MODULE = "tfloom.cli.interface.proto"


class ShowVerb(BuiltinVerb):
    """Print an interface's definition."""

    MODULE = "tfloom.cli.interface.show"
