"""Explain that there is no daemon with a status."""

from __future__ import annotations

import argparse

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `daemon status` and `daemon stop`: none."""
    del parser  # They take nothing.


def main(_: argparse.Namespace) -> int:
    """Print that no daemon is needed, as all verbs about it do; return the exit code."""
    print(
        "There is no daemon, and none is needed: each command discovers the other programs in a quarter of a second."
    )
    return 0
