"""Print the messages of a topic as they come."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from typing import Any

from tfloom.cli import graph, message_text, qos
from tfloom.cli.errors import CommandError
from tfloom.cli.interfaces import message_class
from tfloom.cli.listen import find_type, samples, wait_for_publishers
from tfloom.cli.names import full_topic_name
from tfloom.cli.selection import field_picker, message_filter
from tfloom.rmw.base import Participant, Sample
from tfloom.rmw.qos import QoS, ReliabilityPolicy
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message

SENSOR_DATA = QoS(reliability=ReliabilityPolicy.BEST_EFFORT, depth=5)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `topic echo` takes."""
    graph.add_arguments(parser)
    qos.add_arguments(parser, default="what all of the topic's publishers offer")
    parser.add_argument("topic_name", help="topic to listen to")
    parser.add_argument("message_type", nargs="?", help="its type; found out where somebody has the topic")
    parser.add_argument("--csv", action="store_true", help="print the values alone, with commas between")
    parser.add_argument("--field", help="print this field alone, as in header.stamp or transforms[0].header")
    message_text.add_arguments(parser)
    parser.add_argument(
        "--no-lost-messages", action="store_true", help="accepted; lost messages aren't reported"
    )
    parser.add_argument("--raw", action="store_true", help="print the bytes as they came")
    parser.add_argument(
        "--filter", dest="filter_expr", help="print only if this Python expression over the message m is true"
    )
    parser.add_argument("--once", action="store_true", help="end after the first message")
    parser.add_argument("--timeout", metavar="N", type=float, help="end after so many seconds")
    parser.add_argument(
        "--include-message-info", action="store_true", help="print when it was sent and by whom"
    )
    parser.add_argument(
        "--json", action="store_true", help="print a line of JSON for each message, for programs"
    )


def main(args: argparse.Namespace) -> int:
    """Print messages until Ctrl-C, the first one with --once, or the end of --timeout."""
    name = full_topic_name(args.topic_name)
    end_s = float("inf") if args.timeout is None else time.monotonic() + args.timeout
    show = _printer(args)
    with graph.joined_participant() as participant:
        asked_class = message_class(args.message_type) if args.message_type else None
        graph.wait_until_quiet(participant.graph, args.spin_time)
        listen_to = asked_class or message_class(find_type(participant.graph, name))
        quality = qos.asked_qos(args, SENSOR_DATA) or _suiting_qos(participant, name, end_s)
        for sample in samples(participant, name, listen_to, quality, end_s):
            if show(sample, listen_to) and args.once:
                return 0
    if args.once:
        raise CommandError(f"no message on {name} within {args.timeout:g} s")
    return 0


def _suiting_qos(participant: Participant, name: str, end_s: float) -> QoS:
    return qos.suiting_qos(wait_for_publishers(participant.graph, name, end_s))


def _printer(args: argparse.Namespace) -> Callable[[Sample, type[Message]], bool]:
    """Return what prints a sample and tells whether the filter let it through."""
    wanted = message_filter(args.filter_expr)
    fields = field_picker(args.field)
    text = message_text.message_text(args)

    def show(sample: Sample, listen_to: type[Message]) -> bool:
        if args.raw:
            value: Any = sample.data
        else:
            try:
                value = cdr.decode(listen_to, sample.data)
            except cdr.DecodeError as error:
                print(f"a message that can't be decoded was left out: {error}", file=sys.stderr)
                return False
            if not wanted(value):
                return False
            value = fields(value)
        if args.include_message_info:
            print(_info(sample))
        print(text(value))
        return True

    return show


def _info(sample: Sample) -> dict[str, object]:
    return {
        "source_timestamp": sample.source_stamp_ns,
        "received_timestamp": sample.received_stamp_ns,
        "publisher_gid": ".".join(f"{octet:02x}" for octet in sample.publisher_gid),
    }
