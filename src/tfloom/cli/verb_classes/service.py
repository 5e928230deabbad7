"""The verbs of `ros2 service` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["CallVerb", "EchoVerb", "FindVerb", "InfoVerb", "ListVerb", "TypeVerb"]


class CallVerb(BuiltinVerb, module="tfloom.cli.service.call"):
    """Call a service and print its response."""


class EchoVerb(BuiltinVerb, module="tfloom.cli.service.echo"):
    """Print the requests and responses of a service that publishes its events."""


class FindVerb(BuiltinVerb, module="tfloom.cli.service.find"):
    """List the services of a type."""


class InfoVerb(BuiltinVerb, module="tfloom.cli.service.info"):
    """Print a service's type, and its numbers of servers and clients."""


class ListVerb(BuiltinVerb, module="tfloom.cli.service.list"):
    """List the services."""


class TypeVerb(BuiltinVerb, module="tfloom.cli.service.type"):
    """Print a service's type."""
