"""Print an interface's definition, with the fields of nested types below each field."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from itertools import chain

from tfloom.cli.shared.errors import CommandError, standard_input
from tfloom.workspace.interfaces import expanded_definition


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface show`."""
    comments = parser.add_mutually_exclusive_group()
    comments.add_argument("--all-comments", action="store_true", help="show comments of nested types, too")
    comments.add_argument("--no-comments", action="store_true", help="show no comments and no empty lines")
    parser.add_argument(
        "type",
        help="name of the interface, for example std_msgs/msg/String; - reads names from standard input",
    )


def main(args: argparse.Namespace) -> int:
    """Print the definition of each name."""
    comments = "all" if args.all_comments else "none" if args.no_comments else "own"
    names: Iterable[str] = [args.type] if args.type != "-" else map(str.strip, standard_input())
    try:
        for line in chain.from_iterable(expanded_definition(name, comments) for name in names):
            print(line)
    except LookupError as error:
        raise CommandError(str(error.args[0])) from None
    return 0
