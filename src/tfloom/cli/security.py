"""Explain that SROS 2 is not there, and what protects instead."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.errors import CommandError

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the words of `ros2 security`'s verbs, which are not looked at."""
    parser.add_argument("words", nargs=argparse.REMAINDER, metavar="...", help="of a verb of `ros2 security`")


def main(_: argparse.Namespace) -> int:
    """Print what protects instead.

    Raises:
        CommandError: always.
    """
    raise CommandError(
        "SROS 2 is not there: tfloom makes and reads no keystores. Its wires stay on this machine unless you open "
        "them; across networks, Zenoh has TLS and access rules: see docs/security.md and docs/zenoh.md"
    )
