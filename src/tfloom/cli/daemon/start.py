"""Explain that there is no daemon to start."""

from __future__ import annotations

import argparse

from tfloom.cli.daemon.status import main

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `daemon start`."""
    parser.add_argument("--debug", action="store_true", help="accepted and not used")
