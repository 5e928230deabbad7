"""The verbs of `ros2 component` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["ListVerb", "LoadVerb", "StandaloneVerb", "TypesVerb", "UnloadVerb"]


class ListVerb(BuiltinVerb):
    """List the containers and the components in them."""

    MODULE = "tfloom.cli.component.list"


class LoadVerb(BuiltinVerb):
    """Load a component into a container."""

    MODULE = "tfloom.cli.component.load"


class StandaloneVerb(BuiltinVerb):
    """Explain that a container needs C++."""

    MODULE = "tfloom.cli.component.standalone"


class TypesVerb(BuiltinVerb):
    """Explain that components need C++."""

    MODULE = "tfloom.cli.component.types"


class UnloadVerb(BuiltinVerb):
    """Unload components from a container."""

    MODULE = "tfloom.cli.component.unload"
