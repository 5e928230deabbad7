"""List the packages."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.listing import print_names
from tfloom.workspace import index


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg list`."""
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the packages in order of their names."""
    names = sorted({*index.workspace_packages(), *index.own_packages()})
    print_names(names, as_json=args.json)
    return 0
