"""The verbs of `ros2 component` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["ListVerb", "LoadVerb", "StandaloneVerb", "TypesVerb", "UnloadVerb"]


class ListVerb(BuiltinVerb, module="tfloom.cli.component.list"):
    """List the containers and the components in them."""


class LoadVerb(BuiltinVerb, module="tfloom.cli.component.load"):
    """Load a component into a container."""


class StandaloneVerb(BuiltinVerb, module="tfloom.cli.component.standalone"):
    """Explain that a container needs C++."""


class TypesVerb(BuiltinVerb, module="tfloom.cli.component.types"):
    """Explain that components need C++."""


class UnloadVerb(BuiltinVerb, module="tfloom.cli.component.unload"):
    """Unload components from a container."""
