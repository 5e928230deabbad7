"""Explain a lookup: the chain of transforms, who publishes each, what limits it, and why it fails.

Exit code 0: the lookup succeeds; 1: it fails; 2: the arguments are wrong.
"""

from __future__ import annotations

import argparse
import re
import time
from collections.abc import Callable
from decimal import Decimal
from typing import TYPE_CHECKING

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.numbers import seconds
from tfloom.cli.tf import source

if TYPE_CHECKING:
    from tfloom.tf2.buffer import Buffer
    from tfloom.tf2_tools.watch.model import Observation
    from tfloom.tf2_tools.watch.sources import Source

LISTEN_S = 1.0
"""How long to listen for rates and delays once the chain is known, without --listen [s]."""
NAMES_S = 1.0
"""How long to wait for the names of nodes, which come after their transforms [s]."""
BUFFER_S = 10.0
MARGIN_S = 0.2
"""How much longer than the requested time is ago to listen [s]."""
MAX_TIME_NS = 2**63
WRONG_TIME = 2
"""Exit code for a time that can't be represented."""
MIN_NS_DIGITS = 15
"""Whole numbers with as many digits or more are nanoseconds."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `tf explain`."""
    parser.add_argument("target_frame", metavar="TARGET", help="the frame into which data is transformed")
    parser.add_argument("source_frame", metavar="SOURCE", help="the frame in which data is given")
    parser.add_argument(
        "--at",
        metavar="TIME",
        type=_time,
        default="latest",
        help="latest (default), now, seconds before or after now with a sign (-0.5, +1), or a stamp: seconds, or whole "
        "nanoseconds",
    )
    parser.add_argument(
        "--listen",
        metavar="S",
        type=seconds,
        default=LISTEN_S,
        help=f"how long to measure rates once the chain is known, in seconds (default: {LISTEN_S:g})",
    )
    parser.add_argument(
        "--buffer",
        metavar="S",
        type=seconds,
        help=f"length of the buffer's history in seconds (default: {BUFFER_S:g}, of a bag: no limit)",
    )
    parser.add_argument("--json", action="store_true", help="print the explanation as JSON")
    source.add_arguments(parser)


def main(args: argparse.Namespace) -> int:
    """Print the explanation; return 1 if the lookup fails."""
    from tfloom.tf2.buffer import Buffer
    from tfloom.tf2_tools.lookups.lookup import Outcome, look_up
    from tfloom.tf2_tools.lookups.report import plain_values, report_text

    cache_time_ns = _cache_time_ns(args)
    buffer = Buffer(cache_time_ns)
    # The explanation has what the buffer rejects; its log would stand between the lines of it.
    buffer.set_log_callback(lambda _severity, _text: None)
    with source.open_source(args, buffer=buffer) as opened:
        if source.is_live(args.bag):
            _listen(args, opened, buffer)
        # Both at one time: ages and rates of the observation are told as of `now_ns`, and --at may count back from it.
        observation, now_ns = opened.observation(), opened.now_ns()
        asked_ns = args.at(now_ns)
        if abs(asked_ns) >= MAX_TIME_NS:
            raise CommandError("argument --at: is not a time, because it is beyond the year 2262", WRONG_TIME)
        lookup = look_up(
            observation,
            buffer,
            args.target_frame,
            args.source_frame,
            asked_ns=asked_ns,
            now_ns=now_ns,
            cache_time_ns=cache_time_ns,
        )
    if args.json:
        from tfloom.cli.shared.listing import print_json

        print_json(plain_values(lookup))
    else:
        print(report_text(lookup))
    return 0 if lookup.outcome == Outcome.SUCCEEDS else 1


def _time(text: str) -> Callable[[int], int]:
    """Return the function from now to the requested stamp, both [ns since epoch]; 0 is the latest."""
    if text in {"latest", "0"}:
        return lambda _: 0
    if text == "now":
        return lambda now_ns: now_ns
    if not re.fullmatch(r"[+-]?\d+(\.\d*)?", text, re.ASCII):
        raise argparse.ArgumentTypeError(
            f"must be latest, now, seconds with a sign, or a stamp in seconds or whole nanoseconds, not {text!r}"
        )
    is_ns = text.isdigit() and len(text) >= MIN_NS_DIGITS
    stamp_ns = int(text) if is_ns else int(Decimal(text) * 1_000_000_000)
    if abs(stamp_ns) >= MAX_TIME_NS:
        raise argparse.ArgumentTypeError(f"is not a time, because it is beyond the year 2262: {text}")
    if text[0] in "+-":
        return lambda now_ns: now_ns + stamp_ns
    return lambda _: stamp_ns


def _cache_time_ns(args: argparse.Namespace) -> int | None:
    if args.buffer is not None:
        return int(args.buffer * 1e9)
    return round(BUFFER_S * 1e9) if source.is_live(args.bag) else None


def _has_names(seen: Observation) -> bool:
    """Return whether the node is known of each publisher of which transforms have come."""
    return all(edge.publisher.node is not None or edge.publisher.has_left for edge in seen.edges)


def _listen(args: argparse.Namespace, opened: Source, buffer: Buffer) -> None:
    """Wait until the chain is known, and then for its rates, and for as much history as --at requests."""
    from tfloom.tf2_tools.lookups.chain import find_chain

    end_s = time.monotonic() + args.wait
    while not buffer.can(args.target_frame, args.source_frame):
        if time.monotonic() >= end_s:
            return
        opened.wait(end_s)
    seen = source.wait_for(opened, _has_names, min(args.wait, NAMES_S))
    chain = find_chain(buffer, seen, args.target_frame, args.source_frame)
    if chain is not None and chain.moving:
        now_ns = opened.now_ns()
        history_s = (now_ns - args.at(now_ns)) / 1e9 if args.at(now_ns) else 0.0
        time.sleep(max(args.listen, min(history_s + MARGIN_S, args.wait)))
