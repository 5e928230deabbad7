"""Print the state of a lifecycle node, or of all."""

from __future__ import annotations

import argparse

from tfloom.cli.lifecycle.lifecycle_services import add_arguments as add_common_arguments
from tfloom.cli.lifecycle.lifecycle_services import lifecycles
from tfloom.cli.shared.calls import call_each
from tfloom.cli.shared.listing import print_json


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `lifecycle get`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", nargs="?", help="full name of the node")
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def main(args: argparse.Namespace) -> int:
    """Print label and id of the state, after the node's name if all nodes are listed."""
    with lifecycles(args, args.node_name) as nodes:
        states = call_each({node.node: node.state for node in nodes})
    if args.json:
        print_json(states)
        return 0
    for node_name, state in states.items():
        name = f"{node_name}: " if args.node_name is None else ""
        print(f"{name}{state.label} [{state.id}]")
    return 0
