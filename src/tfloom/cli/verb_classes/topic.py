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


class BwVerb(BuiltinVerb, module="tfloom.cli.topic.bw"):
    """Print the bandwidth of a topic."""


class DelayVerb(BuiltinVerb, module="tfloom.cli.topic.delay"):
    """Print the delay of a topic's messages."""


class EchoVerb(BuiltinVerb, module="tfloom.cli.topic.echo"):
    """Print the messages of a topic."""


class FindVerb(BuiltinVerb, module="tfloom.cli.topic.find"):
    """List the topics of a type."""


class HzVerb(BuiltinVerb, module="tfloom.cli.topic.hz"):
    """Print the rate of a topic's messages."""


class InfoVerb(BuiltinVerb, module="tfloom.cli.topic.info"):
    """Print a topic's type, publishers and subscriptions."""


class ListVerb(BuiltinVerb, module="tfloom.cli.topic.list"):
    """List the topics."""


class PubVerb(BuiltinVerb, module="tfloom.cli.topic.pub"):
    """Publish messages on a topic."""


class TypeVerb(BuiltinVerb, module="tfloom.cli.topic.type"):
    """Print a topic's type."""
