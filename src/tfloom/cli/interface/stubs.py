"""Write typed modules for editors, of the workspace's packages that hold definitions."""

from __future__ import annotations

import argparse
from pathlib import Path

from tfloom.cli.shared.errors import CommandError
from tfloom.common.terminal import report
from tfloom.workspace.interface_stubs import write_stubs


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `interfaces stubs` takes."""
    parser.add_argument(
        "folder",
        metavar="DIR",
        help="where to write; VS Code and pyright look in `typings` of the project, mypy where MYPYPATH says",
    )


def main(args: argparse.Namespace) -> int:
    """Write the modules and print their paths; on stderr, print what is left out, and why."""
    stubs = write_stubs(Path(args.folder))
    if not stubs.written and not stubs.left_out:
        raise CommandError(
            "No package on AMENT_PREFIX_PATH holds definitions: source the setup file of a workspace that has some"
        )
    for path in stubs.written:
        print(f"creating {path}")
    for reason in stubs.left_out:
        report(reason)
    return 1 if stubs.left_out else 0
