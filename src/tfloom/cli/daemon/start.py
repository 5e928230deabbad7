"""Explain that there is no daemon to start."""

from __future__ import annotations

import argparse

from tfloom.cli.daemon.common import no_daemon


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `daemon start`."""
    parser.add_argument("--debug", action="store_true", help="accepted and not used")


def main(_: argparse.Namespace) -> int:
    """Print why this installation has no daemon; return the exit code."""
    return no_daemon()
