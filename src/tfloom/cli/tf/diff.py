"""Compare the transforms of two bags, files or graphs.

A and B are each a bag, a .yaml file of static transforms, or `live`. Exit codes are those of diff: 0 without a
difference, 1 with one, 2 where one can't be read.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.numbers import tolerance
from tfloom.cli.tf import source

if TYPE_CHECKING:
    from tfloom.tf2_tools.watch.difference import Difference, Link

DIFFERENT = 1
TROUBLE = 2
TRANSLATION_M = 1e-6
ROTATION_DEG = 1e-4


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `tf diff`."""
    parser.add_argument("before", metavar="A", help="a bag, a .yaml file, or live")
    parser.add_argument("after", metavar="B", help="a bag, a .yaml file, or live")
    parser.add_argument(
        "--translation",
        metavar="M",
        type=tolerance,
        default=TRANSLATION_M,
        help=f"longest distance in metres that does not count as a difference (default: {TRANSLATION_M:g})",
    )
    parser.add_argument(
        "--rotation",
        metavar="DEG",
        type=tolerance,
        default=ROTATION_DEG,
        help=f"widest angle in degrees that does not count as a difference (default: {ROTATION_DEG:g})",
    )
    parser.add_argument(
        "--static",
        action="store_true",
        help="compare static transforms only, as is done if A or B is a file of them",
    )
    parser.add_argument("--json", action="store_true", help="print the differences as JSON")
    source.add_topics(parser)


def main(args: argparse.Namespace) -> int:
    """Print the differences; return 1 if there are any."""
    from tfloom.tf2_tools.watch.difference import differences
    from tfloom.tf2_tools.watch.sources import is_static_file

    names = (args.before, args.after)
    if all(source.is_live(name) for name in names):
        raise CommandError("A and B are both the live graph: give a bag or a file for one of them", TROUBLE)
    only_static = args.static or any(
        not source.is_live(name) and is_static_file(Path(name)) for name in names
    )
    before, after = (_links(name, args, only_static=only_static) for name in names)
    tree_differences = differences(
        before, after, translation=args.translation, rotation_rad=math.radians(args.rotation)
    )
    if args.json:
        from tfloom.cli.shared.listing import print_json

        print_json([_plain(difference) for difference in tree_differences])
    elif tree_differences:
        print(f"--- {args.before}\n+++ {args.after}")
        for difference in tree_differences:
            print(_line(difference))
    return DIFFERENT if tree_differences else 0


def _links(name: str, args: argparse.Namespace, *, only_static: bool) -> dict[str, Link]:
    from tfloom.tf2_tools.watch.difference import links_of

    try:
        with source.opened(name, args) as opened:
            return links_of(
                source.settled(opened, args.wait, only_static=only_static), only_static=only_static
            )
    except CommandError as error:
        raise CommandError(str(error), TROUBLE) from None
    except OSError as error:
        raise CommandError(f"{name}: {error.strerror}", TROUBLE) from None


def _line(difference: Difference) -> str:
    kind, child, before, after, *_ = difference
    if before is None or after is None:
        return f"+ {_text(after)}" if before is None else f"- {_text(before)}"
    if kind == "re-parented":
        return f"! {child}: its parent was {before.parent}, and is {after.parent}"
    if kind == "kind":
        return f"! {before.parent} -> {child}: it was {_kind(before)}, and is {_kind(after)}"
    moved = f"{difference.distance:.6g} m and {math.degrees(difference.angle_rad):.6g} deg"
    return f"! {before.parent} -> {child}: moved by {moved}"


def _text(link: Link | None) -> str:
    return "" if link is None else f"{link.parent} -> {link.child} ({_kind(link)})"


def _kind(link: Link) -> str:
    return "static" if link.is_static else "moving"


def _plain(difference: Difference) -> dict[str, object]:
    before, after = (link and link._asdict() for link in (difference.before, difference.after))
    return {**difference._asdict(), "before": before, "after": after}
