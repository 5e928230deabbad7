"""The verbs of `ros2 topic` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = [
    "BwVerb",
    "DelayVerb",
    "EchoVerb",
    "FindVerb",
    "HzVerb",
    "InfoVerb",
    "ListVerb",
    "PubVerb",
    "TypeVerb",
]


class BwVerb(BuiltinVerb):
    """Print the bandwidth of a topic."""

    MODULE = "tfloom.cli.topic.bw"


class DelayVerb(BuiltinVerb):
    """Print the delay of a topic's messages."""

    MODULE = "tfloom.cli.topic.delay"


class EchoVerb(BuiltinVerb):
    """Print the messages of a topic."""

    MODULE = "tfloom.cli.topic.echo"


class FindVerb(BuiltinVerb):
    """List the topics of a type."""

    MODULE = "tfloom.cli.topic.find"


class HzVerb(BuiltinVerb):
    """Print the rate of a topic's messages."""

    MODULE = "tfloom.cli.topic.hz"


class InfoVerb(BuiltinVerb):
    """Print a topic's type, publishers and subscriptions."""

    MODULE = "tfloom.cli.topic.info"


class ListVerb(BuiltinVerb):
    """List the topics."""

    MODULE = "tfloom.cli.topic.list"


class PubVerb(BuiltinVerb):
    """Publish messages on a topic."""

    MODULE = "tfloom.cli.topic.pub"


class TypeVerb(BuiltinVerb):
    """Print a topic's type."""

    MODULE = "tfloom.cli.topic.type"
