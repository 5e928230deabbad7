"""List the packages."""

from __future__ import annotations

import argparse

from tfloom.workspace import index


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `pkg list` takes."""
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the packages in order of their names."""
    names = sorted({*index.workspace_packages(), *index.own_packages()})
    if args.json:
        import json

        print(json.dumps(names, indent=2))
    else:
        print("\n".join(names))
    return 0
