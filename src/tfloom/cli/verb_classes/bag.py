"""The verbs of `ros2 bag` as classes."""

from __future__ import annotations

from tfloom.cli.verb_classes.builtin_verb import BuiltinVerb

__all__ = ["BurstVerb", "ConvertVerb", "InfoVerb", "ListVerb", "PlayVerb", "RecordVerb", "ReindexVerb"]


class BurstVerb(BuiltinVerb):
    """Burst data from a bag."""

    MODULE = "tfloom.cli.bag.burst"


class ConvertVerb(BuiltinVerb):
    """Given an input bag, write out a new bag with different settings."""

    MODULE = "tfloom.cli.bag.convert"


class InfoVerb(BuiltinVerb):
    """Print information about a bag to the screen."""

    MODULE = "tfloom.cli.bag.info"


class ListVerb(BuiltinVerb):
    """Print information about available plugins to the screen."""

    MODULE = "tfloom.cli.bag.list"


class PlayVerb(BuiltinVerb):
    """Play back ROS data from a bag."""

    MODULE = "tfloom.cli.bag.play"


class RecordVerb(BuiltinVerb):
    """Record ROS data to a bag."""

    MODULE = "tfloom.cli.bag.record"


class ReindexVerb(BuiltinVerb):
    """Reconstruct metadata file for a bag."""

    MODULE = "tfloom.cli.bag.reindex"
