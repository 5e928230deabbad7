"""The verbs of `ros2 multicast` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["ReceiveVerb", "SendVerb"]


class ReceiveVerb(BuiltinVerb):
    """Wait for one UDP multicast datagram."""

    MODULE = "tfloom.cli.multicast.receive"


class SendVerb(BuiltinVerb):
    """Send one UDP multicast datagram."""

    MODULE = "tfloom.cli.multicast.send"
