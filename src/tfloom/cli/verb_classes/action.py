"""The verbs of `ros2 action` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["InfoVerb", "ListVerb", "SendGoalVerb", "TypeVerb"]


class InfoVerb(BuiltinVerb, module="tfloom.cli.action.info"):
    """Print the servers and clients of an action."""


class ListVerb(BuiltinVerb, module="tfloom.cli.action.list"):
    """List the actions."""


class SendGoalVerb(BuiltinVerb, module="tfloom.cli.action.send_goal"):
    """Send a goal to an action server and print its result."""


class TypeVerb(BuiltinVerb, module="tfloom.cli.action.type"):
    """Print an action's type."""
