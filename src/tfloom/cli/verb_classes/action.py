"""The verbs of `ros2 action` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["InfoVerb", "ListVerb", "SendGoalVerb", "TypeVerb"]


class InfoVerb(BuiltinVerb):
    """Print the servers and clients of an action."""

    MODULE = "tfloom.cli.action.info"


class ListVerb(BuiltinVerb):
    """List the actions."""

    MODULE = "tfloom.cli.action.list"


class SendGoalVerb(BuiltinVerb):
    """Send a goal to an action server and print its result."""

    MODULE = "tfloom.cli.action.send_goal"


class TypeVerb(BuiltinVerb):
    """Print an action's type."""

    MODULE = "tfloom.cli.action.type"
