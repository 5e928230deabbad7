"""Show the tree of transforms as it changes: rates, ages, delays and publishers."""

from __future__ import annotations

import argparse
import os
import sys
import time
from contextlib import closing
from typing import TYPE_CHECKING

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.numbers import rate
from tfloom.cli.tf import source
from tfloom.tf2_tools.top.rows import SORTS, Health

if TYPE_CHECKING:
    from tfloom.tf2_tools.top.program import Top
    from tfloom.tf2_tools.top.view import View
    from tfloom.tf2_tools.watch.sources import Source

REFRESH_HZ = 4.0
ONCE_S = 1.2
"""How long `--once` observes rates when all edges are known [s]."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `tf top`."""
    parser.add_argument(
        "--once", action="store_true", help="print the table once, as without a terminal or with --bag"
    )
    parser.add_argument("--json", action="store_true", help="print the rows once, as JSON")
    parser.add_argument(
        "--sort", choices=list(SORTS), default="tree", help="order of the rows (default: tree)"
    )
    parser.add_argument(
        "--filter", metavar="WORDS", default="", help="show only rows that contain these words"
    )
    parser.add_argument(
        "--follow", nargs=2, metavar=("TARGET", "SOURCE"), help="show the transform between two frames, too"
    )
    parser.add_argument(
        "--refresh",
        type=rate,
        default=REFRESH_HZ,
        metavar="HZ",
        help=f"how often the screen is drawn (default: {REFRESH_HZ:g})",
    )
    source.add_arguments(parser)


def main(args: argparse.Namespace) -> int:
    """Show the table until the user quits, or print it once."""
    from tfloom.tf2_tools.top.program import Top
    from tfloom.tf2_tools.top.view import View

    if not args.refresh > 0.0:
        raise CommandError(f"argument --refresh: must be above 0, not {args.refresh:g}")
    is_live = source.is_live(args.bag)
    view = View(args.sort, args.filter, tuple(args.follow) if args.follow else None)
    with (
        source.open_source(args) as opened,
        closing(
            Top(opened, source.place(args.bag), lambda buffer: source.opened(args.bag, args, buffer=buffer))
        ) as top,
    ):
        if args.json or args.once or not is_live or not _has_terminal():
            _observe(opened, top, args)
            _print_once(top, view, args)
            return 0
        _show(top, view, 1.0 / args.refresh)
    return 0


def _has_terminal() -> bool:
    """Return whether keys can be read and the screen can be drawn."""
    if os.environ.get("TERM") in {"dumb", "unknown"}:
        return False
    return sys.stdin is not None and sys.stdin.isatty() and sys.stdout is not None and sys.stdout.isatty()


def _observe(opened: Source, top: Top, args: argparse.Namespace) -> None:
    """Wait until all edges are known, and then so long that their rates are those of now."""
    if not source.settled(opened, args.wait).is_live:
        return
    top.look()
    end_s = time.monotonic() + ONCE_S
    while time.monotonic() < end_s:
        opened.wait(end_s)


def _print_once(top: Top, view: View, args: argparse.Namespace) -> None:
    from tfloom.cli.shared.listing import print_json
    from tfloom.tf2_tools.top.lines import table

    rows, summary = top.look()
    if args.json:
        print_json([row.values() for row in view.arrange(rows) if row.health is not Health.ROOT])
        return
    print("\n".join(table(rows, summary, view)))
    if view.pair is not None:
        print("\n".join(line for line in top.followed(view.pair) if line))


def _show(top: Top, view: View, period_s: float) -> None:
    from tfloom.tf2_tools.top.program import run
    from tfloom.tf2_tools.top.terminal import whole_screen

    with whole_screen(sys.stdout.fileno(), sys.stdin.fileno()) as (terminal, keyboard):
        run(top, view, terminal, keyboard, period_s)
