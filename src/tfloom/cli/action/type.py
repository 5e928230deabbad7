"""Print an action's type."""

from __future__ import annotations

import argparse

from tfloom.cli.action.common import ends_of_action


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `action type` takes."""
    parser.add_argument("action_name", help="name of the action")


def main(args: argparse.Namespace) -> int:
    """Print each of its types on a line."""
    _, ends = ends_of_action(args.action_name)
    print("\n".join(sorted({end.type_name for end in ends})))
    return 0
