"""List the packages that define interfaces."""

from __future__ import annotations

import argparse

from tfloom.cli.interface.kinds import add_kind_flags, requested_kinds
from tfloom.cli.shared.listing import print_names
from tfloom.rosidl.definition_files import interfaces_of
from tfloom.workspace.interfaces import interface_packages


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface packages`."""
    add_kind_flags(parser)


def main(args: argparse.Namespace) -> int:
    """Print the packages in order of their names."""
    kinds = requested_kinds(args)
    names = [
        package
        for package, folder in interface_packages().items()
        if any(interfaces_of(folder, kind) for kind in kinds)
    ]
    print_names(names, as_json=args.json)
    return 0
