"""Request a transition of a lifecycle node."""

from __future__ import annotations

import argparse

from tfloom.cli.lifecycle.lifecycle_services import add_arguments as add_common_arguments
from tfloom.cli.lifecycle.lifecycle_services import lifecycles
from tfloom.cli.shared.errors import CommandError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `lifecycle set`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("transition", help="label or id of the transition, for example configure")


def main(args: argparse.Namespace) -> int:
    """Request the transition and print the outcome."""
    with lifecycles(args, args.node_name) as nodes:
        transitions = [description.transition for description in nodes[0].transitions()]
        wanted = [
            transition
            for transition in transitions
            if args.transition in {transition.label, str(transition.id)}
        ]
        if not wanted:
            listed = "".join(f"\n- {transition.label} [{transition.id}]" for transition in transitions)
            raise CommandError(f"Unknown transition requested, available ones are:{listed}")
        if not nodes[0].change(wanted[0]):
            raise CommandError("Transitioning failed")
    print("Transitioning successful")
    return 0
