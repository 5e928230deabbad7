"""Print the delay of a topic's messages: the time of arrival minus the stamp in the header."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listen import decoded
from tfloom.cli.topic import rates
from tfloom.rmw.base import Sample
from tfloom.rosidl.message import Message


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic delay`."""
    rates.add_arguments(parser, window=10_000)
    parser.add_argument("topic", help="name of the topic")


def main(args: argparse.Namespace) -> int:
    """Print the delay each second, until Ctrl-C."""
    delays = rates.Window(args.window)

    def on_sample(sample: Sample, cls: type[Message], came_s: float) -> None:
        if (message := decoded(cls, sample)) is None:
            return
        stamp = message.header.stamp
        delays.add(came_s - stamp.sec - stamp.nanosec * 1e-9)

    def report(_: float) -> None:
        if not delays.is_new:
            return
        delays.is_new = False
        values = list(delays.values)
        print(f"average delay: {rates.spread(values)[0]:.3f}")
        print(rates.spread_line(values, len(values)))

    rates.watch(args, args.topic, on_sample, report, check=_has_header)
    return 0


def _has_header(cls: type[Message]) -> None:
    if cls.get_fields_and_field_types().get("header") != "std_msgs/Header":
        raise CommandError("msg does not have header")
