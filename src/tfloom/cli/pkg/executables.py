"""List the programs that `run` finds."""

from __future__ import annotations

import argparse

from tfloom.cli.pkg.prefix import package_prefix
from tfloom.cli.shared.listing import print_json
from tfloom.workspace import index


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg executables`."""
    parser.add_argument("package_name", nargs="?", help="list the programs of this package only")
    parser.add_argument(
        "--full-path",
        action="store_true",
        help="print the programs' files; for tfloom's, module and function",
    )
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print package and name of each program, or its file."""
    if args.package_name is None:
        packages = sorted({*index.workspace_packages(), *index.own_packages()})
    else:
        package_prefix(args.package_name)
        packages = [args.package_name]
    programs = [(package, name, target) for package in packages for name, target in _programs(package)]
    if args.json:
        print_json([{"package": p, "executable": e, "target": t} for p, e, t in programs])
        return 0
    for package, name, target in programs:
        print(target if args.full_path else f"{package} {name}")
    return 0


def _programs(package: str) -> list[tuple[str, str]]:
    """Return name and target of each of a package's programs, in order of the names."""
    prefix = index.find_package(package)
    if prefix is None:
        return sorted(index.PROGRAMS.get(package, {}).items())
    return sorted((index.program_name(path), str(path)) for path in index.package_programs(package, prefix))
