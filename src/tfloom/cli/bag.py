"""Explain that recordings can't be made or played yet."""

from __future__ import annotations

import argparse

from tfloom.cli.errors import CommandError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Accept all arguments of ros2's verbs."""
    parser.add_argument("argv", nargs=argparse.REMAINDER, help="accepted and not used")


def main(_: argparse.Namespace) -> int:
    """Print what to use instead."""
    raise CommandError(
        "Recordings can't be made or played yet. `topic echo TOPIC > FILE` writes a topic's messages as YAML, which "
        "`topic pub --stdin TOPIC TYPE < FILE` publishes again, at a rate of its own."
    )
