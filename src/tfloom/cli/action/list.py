"""List the actions that have a server or a client."""

from __future__ import annotations

import argparse

from tfloom.cli.action.common import settled_ends
from tfloom.cli.listing import print_json


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action list`."""
    parser.add_argument("-t", "--show-types", action="store_true", help="show each action's types")
    parser.add_argument("-c", "--count-actions", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the actions in order of their names."""
    types: dict[str, set[str]] = {}
    for end in settled_ends():
        types.setdefault(end.name, set()).add(end.type_name)
    if args.json:
        print_json([{"name": name, "types": sorted(type_names)} for name, type_names in types.items()])
    elif args.count_actions:
        print(len(types))
    else:
        for name, type_names in types.items():
            print(f"{name} [{', '.join(sorted(type_names))}]" if args.show_types else name)
    return 0
