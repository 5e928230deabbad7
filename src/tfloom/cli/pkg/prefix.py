"""Print where a package is installed; find it for other verbs, too."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.names import way_to_package
from tfloom.workspace import index


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg prefix`."""
    parser.add_argument("package_name", help="name of the package")
    parser.add_argument("--share", action="store_true", help="print the folder of its files instead")


def main(args: argparse.Namespace) -> int:
    """Print the prefix, or the share folder."""
    prefix = package_prefix(args.package_name)
    if args.share:
        print(index.share_folder(args.package_name, prefix))
    else:
        print(prefix or index.own_packages()[args.package_name])
    return 0


def package_prefix(package: str) -> str | None:
    """Return the prefix of a workspace's package, or None for one of tfloom's own.

    Raises:
        CommandError: there is no such package; the text has the nearest names.
    """
    prefix = index.find_package(package)
    own = index.own_packages()
    if prefix is None and package not in own:
        names = {*own, *index.workspace_packages()}
        raise CommandError(f"Package not found{way_to_package(package, names)}")
    return prefix
