"""Explain that a container needs C++."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.errors import CommandError

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Accept all arguments of ros2's verb."""
    parser.add_argument("argv", nargs=argparse.REMAINDER, help="accepted and not used")


def main(_: argparse.Namespace) -> int:
    """Raise the error that says why there are no components here; so does `component types`."""
    raise CommandError(
        "Components are C++ libraries that a C++ container loads; tfloom runs Python nodes, each by `run`. "
        "`component list`, `load` and `unload` work with the containers that others run on the domain"
    )
