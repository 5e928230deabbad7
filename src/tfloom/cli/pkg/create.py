"""Create a package in a workspace."""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path

from tfloom.cli.shared.errors import CommandError
from tfloom.common.terminal import report
from tfloom.workspace.create import BUILD_TYPES, Package, create_package
from tfloom.workspace.licenses import LICENSES


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg create`."""
    blank = Package("")
    parser.add_argument("package_name", help="name of the package")
    parser.add_argument(
        "--build-type",
        default="ament_python",
        help=f"{BUILD_TYPES[0]} (default), or {BUILD_TYPES[1]} for messages, services and actions",
    )
    parser.add_argument("--package-format", choices=["3"], default="3", help="format of package.xml")
    parser.add_argument("--description", default=blank.description, help="one sentence about the package")
    parser.add_argument(
        "--license",
        default=blank.license,
        help="the licence's name, as in SPDX; ? lists those whose text is written, too",
    )
    parser.add_argument(
        "--destination-directory", default=".", help="folder to create it in (default: the current one)"
    )
    parser.add_argument("--dependencies", nargs="+", default=[], help="packages that it uses")
    parser.add_argument("--maintainer-name", default=_user(), help="your name (default: the login's)")
    parser.add_argument("--maintainer-email", default=blank.email, help="your address")
    parser.add_argument("--node-name", help="add a node of this name, and a program that runs it")
    parser.add_argument("--library-name", help="add a Python package of this name")


def _user() -> str:
    return os.environ.get("USER") or os.environ.get("USERNAME") or Package("").maintainer


def main(args: argparse.Namespace) -> int:
    """Write the package, and print the next commands."""
    if args.license == "?":
        print("Supported licenses:")
        for known_license in LICENSES:
            print(known_license.spdx)
        return 0
    package = Package(
        args.package_name,
        args.description,
        args.license,
        args.maintainer_name,
        args.maintainer_email,
        tuple(args.dependencies),
        _node_name(args),
        args.library_name,
        args.build_type,
    )
    try:
        written = create_package(package, Path(args.destination_directory))
    except FileExistsError as error:
        raise CommandError(f"{error.filename} exists; nothing was written") from None
    except OSError as error:
        raise CommandError(f"can't write {error.filename}: {error.strerror}") from None
    except ValueError as error:
        raise CommandError(str(error)) from None
    _print_created(package, args, written)
    report(f"\nIn the workspace's top folder: colcon build --packages-select {args.package_name}")
    if package.node:
        report(f"then: source install/setup.bash && {args.prog} run {args.package_name} {package.node}")
    if package.license not in {Package("").license, *(known_license.spdx for known_license in LICENSES)}:
        report(
            f"{args.package_name} has no LICENSE file, because the text of '{package.license}' isn't known: "
            "--license ? lists those that are"
        )
    return 0


def _print_created(package: Package, args: argparse.Namespace, written: list[Path]) -> None:
    for line in _description_lines(package, args):
        print(line)
    for folder, paths in groupby(written, lambda path: path.parent):
        print(f"creating folder {_as_typed(folder)}")
        for path in paths:
            print(f"creating {_as_typed(path)}")


def _description_lines(package: Package, args: argparse.Namespace) -> Iterator[str]:
    """Yield what is going to be created, as the reference prints it."""
    yield "going to create a new package"
    yield f"package name: {package.name}"
    yield f"destination directory: {Path(args.destination_directory).resolve()}"
    yield f"package format: {args.package_format}"
    yield "version: 0.0.0"
    yield f"description: {package.description}"
    yield f"maintainer: ['{package.maintainer} <{package.email}>']"
    yield f"licenses: ['{package.license}']"
    yield f"build type: {package.build_type}"
    yield f"dependencies: {list(package.dependencies)}"
    if package.node:
        yield f"node_name: {package.node}"
    if package.library:
        yield f"library_name: {package.library}"


def _as_typed(path: Path) -> str:
    return str(path) if path.is_absolute() else f"./{path}"


def _node_name(args: argparse.Namespace) -> str | None:
    """Return the node's name; one that is the library's too gets another, because both are modules."""
    if args.node_name is None or args.node_name != args.library_name:
        return None if args.node_name is None else str(args.node_name)
    report(f"the node is named {args.node_name}_node, because the library is {args.library_name}")
    return f"{args.node_name}_node"
