"""Create a package in a workspace."""

from __future__ import annotations

import argparse
import os
from pathlib import Path

from tfloom.cli.errors import CommandError
from tfloom.workspace.create import Package, create_package


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg create`."""
    blank = Package("")
    parser.add_argument("package_name", help="name of the package")
    parser.add_argument(
        "--build-type", default="ament_python", help="ament_python (default); others need C++"
    )
    parser.add_argument("--package-format", choices=["3"], default="3", help="format of package.xml")
    parser.add_argument("--description", default=blank.description, help="one sentence about the package")
    parser.add_argument("--license", default=blank.license, help="the licence's name, as in SPDX")
    parser.add_argument(
        "--destination-directory", default=".", help="folder to create it in (default: the current one)"
    )
    parser.add_argument("--dependencies", nargs="+", default=[], help="packages that it uses")
    parser.add_argument("--maintainer-name", default=_user(), help="your name (default: the login's)")
    parser.add_argument("--maintainer-email", default=blank.email, help="your address")
    parser.add_argument("--node-name", help="add a node of this name, and a program that runs it")


def _user() -> str:
    return os.environ.get("USER") or os.environ.get("USERNAME") or Package("").maintainer


def main(args: argparse.Namespace) -> int:
    """Write the package, and print the next commands."""
    if args.build_type != "ament_python":
        raise CommandError(
            f"a package of build type {args.build_type} needs CMake and C++; ament_python doesn't"
        )
    package = Package(
        args.package_name,
        args.description,
        args.license,
        args.maintainer_name,
        args.maintainer_email,
        tuple(args.dependencies),
        args.node_name,
    )
    try:
        written = create_package(package, Path(args.destination_directory))
    except FileExistsError as error:
        raise CommandError(f"{error.filename} exists; nothing was written") from None
    except (OSError, ValueError) as error:
        raise CommandError(str(error)) from None
    for path in written:
        print(f"creating {path}")
    print(f"\nIn the workspace's top folder: colcon build --packages-select {args.package_name}")
    if args.node_name:
        print(f"then: source install/setup.bash && {args.prog} run {args.package_name} {args.node_name}")
    return 0
