"""The verbs of `ros2 multicast` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["ReceiveVerb", "SendVerb"]


class ReceiveVerb(BuiltinVerb, module="tfloom.cli.multicast.receive"):
    """Wait for one UDP multicast datagram."""


class SendVerb(BuiltinVerb, module="tfloom.cli.multicast.send"):
    """Send one UDP multicast datagram."""
