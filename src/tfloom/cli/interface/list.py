"""List the interfaces by kind."""

from __future__ import annotations

import argparse

from tfloom.cli.interface.kinds import TITLES, add_kind_flags, requested_kinds
from tfloom.cli.shared.listing import print_json
from tfloom.workspace.interfaces import known_interfaces


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface list`."""
    add_kind_flags(parser)


def main(args: argparse.Namespace) -> int:
    """Print the names of each kind under the kind's title."""
    names = {kind: known_interfaces(kind) for kind in requested_kinds(args)}
    if args.json:
        print_json(names)
        return 0
    for kind, of_kind in names.items():
        print(f"{TITLES[kind]}:")
        for name in of_kind:
            print(f"    {name}")
    return 0
