"""Print the rate of the messages of a topic, or of several."""

from __future__ import annotations

import argparse
from functools import partial
from itertools import pairwise

from tfloom.cli.shared.listen import decoded
from tfloom.cli.shared.selection import message_filter
from tfloom.cli.topic import rates
from tfloom.common.terminal import report
from tfloom.rmw.base import Sample
from tfloom.rosidl.message import Message


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic hz`."""
    rates.add_topics(parser, "topic_name")
    rates.add_arguments(parser, window=10_000)
    parser.add_argument(
        "--filter", metavar="EXPR", help="count messages only if this Python expression over m is true"
    )
    parser.add_argument(
        "--wall-time", action="store_true", help="measure arrival by this machine's time, regardless of -s"
    )


def main(args: argparse.Namespace) -> int:
    """Print the rate each second, until Ctrl-C; of several topics, a table."""
    wanted = message_filter(args.filter)
    names = rates.topics_of(args)
    windows: dict[str, rates.Window] = {}

    def on_sample(name: str, sample: Sample, cls: type[Message], came_s: float) -> None:
        arrivals = windows.setdefault(name, rates.Window(args.window + 1))
        if arrivals.is_beyond(came_s):
            arrivals.values.clear()
        if args.filter is None or ((message := decoded(cls, sample)) is not None and wanted(message)):
            arrivals.add(came_s)

    if len(names) == 1:
        (name,) = names
        rates.watch(
            args, name, partial(on_sample, name), lambda _: _print_rate(windows.get(name, rates.Window(1)))
        )
    else:
        rates.watch_several(args, names, on_sample, lambda _: _table(windows))
    return 0


def _print_rate(arrivals: rates.Window) -> None:
    if not (periods := _new_periods(arrivals)):
        report("no new messages")
        return
    print(f"average rate: {_rate(periods):.3f}")
    print(rates.spread_line(periods, len(arrivals.values)))


def _table(windows: dict[str, rates.Window]) -> list[str]:
    """Return a line for each topic that has had messages since the last table."""
    rows = []
    for name, arrivals in sorted(windows.items()):
        if periods := _new_periods(arrivals):
            _, least, greatest, deviation = rates.spread(periods)
            numbers = (_rate(periods), least, greatest, deviation)
            rows.append([name, *(f"{number:.4g}" for number in numbers), f"{len(arrivals.values)}"])
    if not rows:
        return ["no new messages"]
    return rates.table_lines(["topic", "rate", "min_delta", "max_delta", "std_dev", "window"], rows)


def _new_periods(arrivals: rates.Window) -> list[float]:
    """Return the times between messages [s]; none if there are fewer than two, or nothing new since the last call."""
    if not arrivals.is_new or len(arrivals.values) < 2:
        return []
    arrivals.is_new = False
    return [later - earlier for earlier, later in pairwise(arrivals.values)]


def _rate(periods: list[float]) -> float:
    """Return the rate of messages with these times between them [Hz]."""
    mean = rates.spread(periods)[0]
    return 1 / mean if mean > 0 else float("inf")
