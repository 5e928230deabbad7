"""List the transitions that are available on a lifecycle node."""

from __future__ import annotations

import argparse

from tfloom.cli.lifecycle.lifecycle_services import add_arguments as add_common_arguments
from tfloom.cli.lifecycle.lifecycle_services import lifecycles
from tfloom.cli.shared.listing import print_json


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `lifecycle list`."""
    add_common_arguments(parser)
    parser.add_argument(
        "-a",
        "--all",
        action="store_true",
        help="list the transitions of all states, not only of the present one",
    )
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print each transition with its start and goal states."""
    with lifecycles(args, args.node_name) as nodes:
        transitions = nodes[0].transitions(of_all_states=args.all)
    if args.json:
        print_json(transitions)
        return 0
    for description in transitions:
        print(f"- {description.transition.label} [{description.transition.id}]")
        print(f"\tStart: {description.start_state.label}")
        print(f"\tGoal: {description.goal_state.label}")
    return 0
