"""Print a package's package.xml, or a tag of it."""

from __future__ import annotations

import argparse

from tfloom.cli.pkg.prefix import package_prefix
from tfloom.cli.shared.errors import CommandError
from tfloom.workspace import index


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `pkg xml`."""
    parser.add_argument("package_name", help="name of the package")
    parser.add_argument("-t", "--tag", help="print the text of this tag, for example -t version")


def main(args: argparse.Namespace) -> int:
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
