"""Explain that components need C++."""

from __future__ import annotations

import argparse

from tfloom.cli.component.explained import needs_cpp


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Accept all arguments of ros2's verb."""
    parser.add_argument("argv", nargs=argparse.REMAINDER, help="accepted and not used")


def main(_: argparse.Namespace) -> int:
    """Raise the error that says why this verb needs C++."""
    raise needs_cpp()
