"""Print the rate of a topic's messages."""

from __future__ import annotations

import argparse
from itertools import pairwise

from tfloom.cli.shared.listen import decoded
from tfloom.cli.shared.selection import message_filter
from tfloom.cli.topic import rates
from tfloom.common.terminal import report
from tfloom.rmw.base import Sample
from tfloom.rosidl.message import Message


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic hz`."""
    parser.add_argument("topic_name", help="name of the topic")
    rates.add_arguments(parser, window=10_000)
    parser.add_argument(
        "--filter", metavar="EXPR", help="count messages only if this Python expression over m is true"
    )
    parser.add_argument(
        "--wall-time", action="store_true", help="measure arrival by this machine's time, regardless of -s"
    )


def main(args: argparse.Namespace) -> int:
    """Print the rate each second, until Ctrl-C."""
    wanted = message_filter(args.filter)
    arrivals = rates.Window(args.window + 1)

    def on_sample(sample: Sample, cls: type[Message], came_s: float) -> None:
        if arrivals.is_beyond(came_s):
            arrivals.values.clear()
        if args.filter is None or ((message := decoded(cls, sample)) is not None and wanted(message)):
            arrivals.add(came_s)

    def print_rate(_: float) -> None:
        times = list(arrivals.values)
        periods = [later - earlier for earlier, later in pairwise(times)]
        if not periods or not arrivals.is_new:
            report("no new messages")
            return
        arrivals.is_new = False
        mean = rates.spread(periods)[0]
        print(f"average rate: {1 / mean if mean > 0 else float('inf'):.3f}")
        print(rates.spread_line(periods, len(times)))

    rates.watch(args, args.topic_name, on_sample, print_rate)
    return 0
