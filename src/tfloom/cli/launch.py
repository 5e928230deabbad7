"""Explain that launch files can't be run yet."""

from __future__ import annotations

import argparse

from tfloom.cli.errors import CommandError

_SWITCHES = (
    ("-n", "--noninteractive"),
    ("-d", "--debug"),
    ("-p", "--print", "--print-description"),
    ("-s", "--show-args", "--show-arguments"),
    ("-a", "--show-all-subprocesses-output"),
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Accept all arguments of ros2's verb."""
    for names in _SWITCHES:
        parser.add_argument(*names, action="store_true", help="accepted and not used")
    parser.add_argument("--launch-prefix", help="accepted and not used")
    parser.add_argument("--launch-prefix-filter", help="accepted and not used")
    parser.add_argument("package_name", help="accepted and not used")
    parser.add_argument("launch_file_name", nargs="?", help="accepted and not used")
    parser.add_argument("launch_arguments", nargs="*", help="accepted and not used")


def main(_: argparse.Namespace) -> int:
    """Print what to use instead."""
    raise CommandError(
        "Launch files can't be run yet. Start each program that the file names by `run`, in a terminal of its own; "
        "its parameters and remappings follow --ros-args, as -p name:=value and -r from:=to."
    )
