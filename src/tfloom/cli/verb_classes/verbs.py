"""The verbs that public programs run or derive from as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = [
    "BwVerb",
    "ConvertVerb",
    "CreateVerb",
    "DelayVerb",
    "EchoVerb",
    "HzVerb",
    "InfoVerb",
    "ListVerb",
    "PlayVerb",
    "PubVerb",
    "RecordVerb",
]


class BwVerb(BuiltinVerb, module="tfloom.cli.topic.bw"):
    """Print the bandwidth of a topic, or of several."""


class DelayVerb(BuiltinVerb, module="tfloom.cli.topic.delay"):
    """Print the delay of a topic's messages."""


class EchoVerb(BuiltinVerb, module="tfloom.cli.topic.echo"):
    """Print the messages of a topic."""


class HzVerb(BuiltinVerb, module="tfloom.cli.topic.hz"):
    """Print the rate of a topic's messages."""


class InfoVerb(BuiltinVerb, module="tfloom.cli.topic.queries", verb="info"):
    """Print a topic's type, publishers and subscriptions."""


class ListVerb(BuiltinVerb, module="tfloom.cli.topic.queries", verb="list"):
    """List the topics."""


class PubVerb(BuiltinVerb, module="tfloom.cli.topic.pub"):
    """Publish messages on a topic."""


class ConvertVerb(BuiltinVerb, module="tfloom.cli.bag.convert"):
    """Given an input bag, write out a new bag with different settings."""


class PlayVerb(BuiltinVerb, module="tfloom.cli.bag.play"):
    """Play back ROS data from a bag."""


class RecordVerb(BuiltinVerb, module="tfloom.cli.bag.record"):
    """Record ROS data to a bag."""


class CreateVerb(BuiltinVerb, module="tfloom.cli.pkg.create"):
    """Create a package in a workspace."""
