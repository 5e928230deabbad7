"""List the actions that have a server or a client."""

from __future__ import annotations

import argparse

from tfloom.cli.action.action_ends import settled_ends
from tfloom.cli.shared.graph import types_by_name
from tfloom.cli.shared.listing import print_types


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action list`."""
    parser.add_argument("-t", "--show-types", action="store_true", help="show each action's types")
    parser.add_argument("-c", "--count-actions", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the actions in order of their names."""
    types = types_by_name((end.name, end.type_name) for end in settled_ends())
    print_types(types, args, only_count=args.count_actions)
    return 0
