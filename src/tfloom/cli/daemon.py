"""`daemon`: the verbs, which explain that there is none."""

from __future__ import annotations

import argparse


def add_start_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `daemon start`."""
    parser.add_argument("--debug", action="store_true", help="accepted and not used")


def add_status_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `daemon status` and `daemon stop`: none."""
    del parser  # They take nothing.


def status_main(_: argparse.Namespace) -> int:
    """Print that no daemon is needed, as all verbs about it do; return the exit code."""
    print(
        "There is no daemon, and none is needed: each command discovers the other programs in a quarter of a second."
    )
    return 0


start_main = status_main
add_stop_arguments, stop_main = add_status_arguments, status_main
