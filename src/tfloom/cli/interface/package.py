"""List the interfaces of one package."""

from __future__ import annotations

import argparse

from tfloom.cli.interface.kinds import add_kind_flags, requested_kinds
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_names
from tfloom.cli.shared.names import did_you_mean
from tfloom.rosidl.definition_files import interfaces_of
from tfloom.workspace.interfaces import interface_packages


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface package`."""
    parser.add_argument("package_name", help="name of the package")
    add_kind_flags(parser)


def main(args: argparse.Namespace) -> int:
    """Print the interfaces, kind by kind, each kind in order of the names."""
    packages = interface_packages()
    folder = packages.get(args.package_name)
    if folder is None:
        raise CommandError(
            f"Unknown package '{args.package_name}'{did_you_mean(args.package_name, packages)}"
        )
    names = [
        f"{args.package_name}/{kind}/{name}"
        for kind in requested_kinds(args)
        for name in interfaces_of(folder, kind)
    ]
    print_names(names, as_json=args.json)
    return 0
