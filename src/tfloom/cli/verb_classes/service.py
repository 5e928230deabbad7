"""The verbs of `ros2 service` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["CallVerb", "EchoVerb", "FindVerb", "InfoVerb", "ListVerb", "TypeVerb"]


class CallVerb(BuiltinVerb):
    """Call a service and print its response."""

    MODULE = "tfloom.cli.service.call"


class EchoVerb(BuiltinVerb):
    """Print the requests and responses of a service that publishes its events."""

    MODULE = "tfloom.cli.service.echo"


class FindVerb(BuiltinVerb):
    """List the services of a type."""

    MODULE = "tfloom.cli.service.find"


class InfoVerb(BuiltinVerb):
    """Print a service's type, and its numbers of servers and clients."""

    MODULE = "tfloom.cli.service.info"


class ListVerb(BuiltinVerb):
    """List the services."""

    MODULE = "tfloom.cli.service.list"


class TypeVerb(BuiltinVerb):
    """Print a service's type."""

    MODULE = "tfloom.cli.service.type"
