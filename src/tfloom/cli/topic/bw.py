"""Print the bandwidth of a topic."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.names import full_topic_name
from tfloom.cli.topic import rates
from tfloom.rmw.base import Sample
from tfloom.rosidl.message import Message

UNITS = {"MB": (1e6, 2), "KB": (1e3, 2), "B": (1.0, 0)}
"""Size [bytes] and decimals of each unit."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic bw`."""
    rates.add_arguments(parser, window=100)
    parser.add_argument("topic", help="name of the topic")


def main(args: argparse.Namespace) -> int:
    """Print the bandwidth each second, until Ctrl-C."""
    sizes, arrivals = rates.Window(args.window), rates.Window(args.window)

    def on_sample(sample: Sample, _: type[Message], came_s: float) -> None:
        if arrivals.is_beyond(came_s):
            arrivals.values.clear()
            sizes.values.clear()
        sizes.add(len(sample.data))
        arrivals.add(came_s)

    def report(now_s: float) -> None:
        if len(sizes.values) < 2 or not sizes.is_new:
            return
        sizes.is_new = False
        print(bandwidth_text(list(sizes.values), now_s - arrivals.values[0]))

    print(f"Subscribed to [{full_topic_name(args.topic)}]")
    rates.watch(args, args.topic, on_sample, report)
    return 0


def bandwidth_text(sizes: list[float], duration_s: float) -> str:
    """Return the two lines on messages of these sizes [bytes] in a time [s]; the rate determines the unit."""
    mean, least, greatest, _ = rates.spread(sizes)
    per_second = sum(sizes) / duration_s if duration_s > 0 else float("inf")
    unit = next(unit for unit, (size, _) in UNITS.items() if per_second >= size or unit == "B")
    size, digits = UNITS[unit]
    rate_text, mean_text, least_text, greatest_text = (
        f"{value / size:.{digits}f} {unit}" for value in (per_second, mean, least, greatest)
    )
    return (
        f"{rate_text}/s from {len(sizes)} messages\n"
        f"\tMessage size mean: {mean_text} min: {least_text} max: {greatest_text}"
    )
