"""The verbs of `action` that print names and types."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.action_ends import ends_of_action, settled_ends
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.graph import names_of_type, types_by_name
from tfloom.cli.shared.listing import print_json, print_names, print_types
from tfloom.common.terminal import report


def add_find_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action find`."""
    parser.add_argument(
        "action_type", help="type of the actions, for example turtlesim/action/RotateAbsolute"
    )
    parser.add_argument("-c", "--count-actions", action="store_true", help="print only the number")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def find_main(args: argparse.Namespace) -> int:
    """Print the actions in order of their names."""
    types = types_by_name((end.name, end.type_name) for end in settled_ends())
    names = names_of_type(types, args.action_type, "action", hidden=True)
    print_names(names, as_json=args.json, only_count=args.count_actions)
    return 0


def add_info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action info`."""
    parser.add_argument("action_name", help="name of the action")
    parser.add_argument("-t", "--show-types", action="store_true", help="show the type that each node uses")
    parser.add_argument("-c", "--count", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def info_main(args: argparse.Namespace) -> int:
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


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action list`."""
    parser.add_argument("-t", "--show-types", action="store_true", help="show each action's types")
    parser.add_argument("-c", "--count-actions", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def list_main(args: argparse.Namespace) -> int:
    """Print the actions in order of their names."""
    types = types_by_name((end.name, end.type_name) for end in settled_ends())
    print_types(types, args, only_count=args.count_actions)
    return 0


def add_type_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action type`."""
    parser.add_argument("action_name", help="name of the action")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def type_main(args: argparse.Namespace) -> int:
    """Print each of its types on a line."""
    _, ends, unknown = ends_of_action(args.action_name)
    if unknown:
        raise CommandError(unknown)
    print_names(sorted({end.type_name for end in ends}), as_json=args.json)
    return 0
