"""Print the messages of a topic as they arrive."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from typing import Any

from tfloom.cli.shared import graph, message_text, qos
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.interfaces import message_class
from tfloom.cli.shared.listen import (
    cli_node,
    decoded,
    find_type,
    mismatch_reason,
    publishers_of,
    samples,
    wait_for_publishers,
)
from tfloom.cli.shared.names import full_topic_name, named_node
from tfloom.cli.shared.numbers import seconds
from tfloom.cli.shared.selection import field_picker, message_filter
from tfloom.common.terminal import clear_terminal, report
from tfloom.rmw.base import Participant, Sample
from tfloom.rmw.events import Count
from tfloom.rmw.qos import QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl.message import Message

SENSOR_DATA = QoS(reliability=ReliabilityPolicy.BEST_EFFORT, depth=5)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic echo`."""
    graph.add_arguments(parser)
    qos.add_arguments(parser, default="compatible with all publishers of the topic")
    parser.add_argument("topic_name", help="name of the topic")
    parser.add_argument("message_type", nargs="?", help="its type; not needed for a topic on the graph")
    parser.add_argument("--csv", action="store_true", help="print the values alone, with commas between")
    parser.add_argument(
        "--field",
        action="append",
        default=[],
        help="print this field alone, as in header.stamp or transforms[0].header; may be given several times",
    )
    message_text.add_arguments(parser)
    parser.add_argument("-c", "--clear", action="store_true", help="clear the screen before each message")
    parser.add_argument("-n", "--node-name", help="name of the node that subscribes")
    parser.add_argument("--no-lost-messages", action="store_true", help="don't report lost messages")
    parser.add_argument("--raw", action="store_true", help="print the serialized bytes")
    parser.add_argument(
        "--filter",
        dest="filter_expr",
        help="print only if this Python expression is true; m is the message, or the field of --field",
    )
    parser.add_argument("--once", action="store_true", help="end after the first message")
    parser.add_argument("--timeout", metavar="N", type=seconds, help="end after this time in seconds")
    parser.add_argument(
        "--include-message-info",
        action="store_true",
        help="print the times of sending and receipt before each message",
    )
    parser.add_argument(
        "--json", action="store_true", help="print a line of JSON for each message, for programs"
    )


def main(args: argparse.Namespace) -> int:
    """Print messages until Ctrl-C, the first message with --once, or the end of --timeout."""
    name = full_topic_name(args.topic_name)
    end_s = float("inf") if args.timeout is None else time.monotonic() + args.timeout
    show = _printer(args)
    node = cli_node() if args.node_name is None else named_node(args.node_name)
    on_lost = None if args.no_lost_messages else _report_losses
    with graph.joined_participant() as participant:
        requested_class = message_class(args.message_type, participant) if args.message_type else None
        graph.wait_until_quiet(participant.graph, args.spin_time)
        listen_to = requested_class or message_class(find_type(participant.graph, name), participant)
        quality = qos.requested_qos(args, SENSOR_DATA) or _suiting_qos(participant, name, end_s)
        topic = topic_of(listen_to, name)
        if publishers_of(participant.graph, name) and (
            reason := mismatch_reason(participant.graph, topic, is_publisher=False)
        ):
            report(f"WARNING: {reason}")
        for sample in samples(participant, name, listen_to, quality, end_s, on_lost, node):
            if show(sample, listen_to) and args.once:
                return 0
    if args.once:
        raise CommandError(f"no message on {name} within {args.timeout:g} s")
    return 0


def _suiting_qos(participant: Participant, name: str, end_s: float) -> QoS:
    return qos.suiting_qos(wait_for_publishers(participant.graph, name, end_s))


def _report_losses(lost: Count) -> None:
    """Print the losses on stderr, because programs read the messages from stdout."""
    report(
        f"A message was lost!!!\n\ttotal count change:{lost.total_count_change}\n"
        f"\ttotal count: {lost.total_count}---"
    )


def _printer(args: argparse.Namespace) -> Callable[[Sample, type[Message]], bool]:
    """Return the function that prints a sample and returns whether it passed the filter."""
    if args.raw and args.field:
        raise CommandError("--raw prints the bytes of whole messages, and --field a part of them")
    wanted = message_filter(args.filter_expr)
    fields = field_picker(args.field)
    text = message_text.message_text(args)

    def show(sample: Sample, listen_to: type[Message]) -> bool:
        value: Any = None
        if args.filter_expr is not None or not args.raw:
            message = decoded(listen_to, sample)
            if message is None or not wanted(value := fields(message)):
                return False
        if args.raw:
            value = sample.data.hex() if args.json else sample.data
        info = _info(sample) if args.include_message_info else {}
        if args.clear:
            clear_terminal(sys.stdout)
        if not info:
            print(text(value))
        elif args.json:
            print(text({"message_info": info, "message": value}))
        elif args.csv:
            print(",".join([*map(str, info.values()), text(value)]))
        else:
            lines = [f"{name}: {'null' if info[name] is None else info[name]}" for name in sorted(info)]
            print("\n".join([*lines, "---", text(value)]))
        return True

    return show


def _info(sample: Sample) -> dict[str, int | None]:
    return {
        "source_timestamp": sample.source_stamp_ns,
        "received_timestamp": sample.received_stamp_ns,
        "publication_sequence_number": sample.publication_sequence_number,
        "reception_sequence_number": sample.reception_sequence_number,
    }
