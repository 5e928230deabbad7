"""Print the servers and clients of an action."""

from __future__ import annotations

import argparse

from tfloom.cli.action.action_ends import ends_of_action
from tfloom.cli.shared.listing import print_json
from tfloom.common.terminal import report


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action info`."""
    parser.add_argument("action_name", help="name of the action")
    parser.add_argument("-t", "--show-types", action="store_true", help="show the type that each node uses")
    parser.add_argument("-c", "--count", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def main(args: argparse.Namespace) -> int:
    """Print the nodes of its clients and of its servers."""
    name, ends, unknown = ends_of_action(args.action_name)
    if unknown:
        report(unknown)
    servers = [end for end in ends if end.is_server]
    clients = [end for end in ends if not end.is_server]
    if args.json:
        nodes = {
            side: [{"node": end.node, "type": end.type_name} for end in these]
            for side, these in (("clients", clients), ("servers", servers))
        }
        print_json({"name": name, **nodes})
        return 0
    print(f"Action: {name}")
    for title, side in (("clients", clients), ("servers", servers)):
        print(f"Action {title}: {len(side)}")
        if not args.count:
            for end in side:
                print(f"    {end.node} [{end.type_name}]" if args.show_types else f"    {end.node}")
    return 0
