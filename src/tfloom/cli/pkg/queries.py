"""The verbs of `pkg` that print names and places."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_json, print_names
from tfloom.cli.shared.names import way_to_package
from tfloom.workspace import index


def add_prefix_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg prefix`."""
    parser.add_argument("package_name", help="name of the package")
    parser.add_argument("--share", action="store_true", help="print the folder of its files instead")


def prefix_main(args: argparse.Namespace) -> int:
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


def add_executables_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg executables`."""
    parser.add_argument("package_name", nargs="?", help="list the programs of this package only")
    parser.add_argument(
        "--full-path",
        action="store_true",
        help="print the programs' files; for tfloom's, module and function",
    )
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def executables_main(args: argparse.Namespace) -> int:
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


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg list`."""
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def list_main(args: argparse.Namespace) -> int:
    """Print the packages in order of their names."""
    names = sorted({*index.workspace_packages(), *index.own_packages()})
    print_names(names, as_json=args.json)
    return 0


def add_xml_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg xml`."""
    parser.add_argument("package_name", help="name of the package")
    parser.add_argument("-t", "--tag", help="print the text of this tag, for example -t version")


def xml_main(args: argparse.Namespace) -> int:
    """Print the file, or the text of each of its tags of that name."""
    path = index.share_folder(args.package_name, package_prefix(args.package_name)) / "package.xml"
    if not path.is_file():
        raise CommandError(f"{args.package_name} has no package.xml in {path.parent}")
    text = path.read_text("utf-8")
    if args.tag is None:
        print(text, end="")
        return 0
    from xml.etree import ElementTree as ET

    from tfloom.common.xml import read_tree

    try:
        tags = list(read_tree(text).iter(args.tag))
    except ET.ParseError as error:
        raise CommandError(f"{path} isn't XML: {error}") from None
    if not tags:
        raise CommandError(f"No element of the tag '{args.tag}' found in {path}")
    for tag in tags:
        print("".join(tag.itertext()))
    return 0
