"""Print an action's type."""

from __future__ import annotations

import argparse

from tfloom.cli.action.action_ends import ends_of_action
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action type`."""
    parser.add_argument("action_name", help="name of the action")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print each of its types on a line."""
    _, ends, unknown = ends_of_action(args.action_name)
    if unknown:
        raise CommandError(unknown)
    print_names(sorted({end.type_name for end in ends}), as_json=args.json)
    return 0
