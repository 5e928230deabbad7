"""The verbs of `ros2 bag` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["BurstVerb", "ConvertVerb", "InfoVerb", "ListVerb", "PlayVerb", "RecordVerb", "ReindexVerb"]


class BurstVerb(BuiltinVerb, module="tfloom.cli.bag.burst"):
    """Burst data from a bag."""


class ConvertVerb(BuiltinVerb, module="tfloom.cli.bag.convert"):
    """Given an input bag, write out a new bag with different settings."""


class InfoVerb(BuiltinVerb, module="tfloom.cli.bag.info"):
    """Print information about a bag to the screen."""


class ListVerb(BuiltinVerb, module="tfloom.cli.bag.list"):
    """Print information about available plugins to the screen."""


class PlayVerb(BuiltinVerb, module="tfloom.cli.bag.play"):
    """Play back ROS data from a bag."""


class RecordVerb(BuiltinVerb, module="tfloom.cli.bag.record"):
    """Record ROS data to a bag."""


class ReindexVerb(BuiltinVerb, module="tfloom.cli.bag.reindex"):
    """Reconstruct metadata file for a bag."""
