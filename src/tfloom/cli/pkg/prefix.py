"""Print where a package is installed."""

from __future__ import annotations

import argparse

from tfloom.cli.pkg.common import package_prefix
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
