"""Explain that components need C++."""

from __future__ import annotations

import argparse

from tfloom.cli.errors import CommandError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Accept all arguments of ros2's verb."""
    parser.add_argument("argv", nargs=argparse.REMAINDER, help="accepted and not used")


def main(_: argparse.Namespace) -> int:
    """Print why there are no components."""
    raise CommandError(
        "Components are C++ libraries that a C++ container loads; tfloom runs Python nodes, each by `run`."
    )
