"""Publish messages on a topic."""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Callable, Iterator
from itertools import repeat
from pathlib import Path

from tfloom.cli.shared import graph, qos
from tfloom.cli.shared.errors import CommandError, standard_input
from tfloom.cli.shared.interfaces import fill_message, message_class, parse_yaml, set_stamps, yaml_documents
from tfloom.cli.shared.listen import HINT_S, cli_node, mismatch_reason, shown_node, warn_of_mismatch
from tfloom.cli.shared.names import full_topic_name, named_node
from tfloom.cli.shared.numbers import count, rate, seconds
from tfloom.cli.shared.sim_time import NowNs, clock, wait_until_known
from tfloom.common.terminal import report
from tfloom.rmw.base import Writer
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic pub`."""
    parser.add_argument("topic_name", help="name of the topic")
    parser.add_argument("message_type", help="type of the messages, for example geometry_msgs/msg/Twist")
    parser.add_argument(
        "values", nargs="?", default="{}", help="the fields in YAML, for example '{linear: {x: 0.5}}'"
    )
    parser.add_argument(
        "--stdin", action="store_true", help="read the values, YAML documents, from standard input"
    )
    parser.add_argument(
        "--yaml-file",
        metavar="FILE",
        help="publish the values in a file, YAML documents as `topic echo` prints them",
    )
    parser.add_argument(
        "-r", "--rate", metavar="N", type=rate, default=1.0, help="rate of publishing in Hz (default: 1)"
    )
    parser.add_argument(
        "-p", "--print", metavar="N", type=count, default=1, help="print every Nth message only (default: 1)"
    )
    ends = parser.add_mutually_exclusive_group()
    ends.add_argument("-1", "--once", action="store_true", help="publish one message and end")
    ends.add_argument("-t", "--times", type=count, default=0, help="publish this number of messages and end")
    parser.add_argument(
        "-w",
        "--wait-matching-subscriptions",
        type=count,
        help="wait for this number of subscriptions first (default: 1 with --once and --times, else 0)",
    )
    parser.add_argument("--max-wait-time-secs", type=seconds, help="longest wait for them in seconds")
    parser.add_argument(
        "--keep-alive",
        metavar="N",
        type=seconds,
        default=0.1,
        help="wait in seconds after the last message (default: 0.1)",
    )
    parser.add_argument("-n", "--node-name", help="name of the node that publishes")
    qos.add_arguments(parser, default="default")
    parser.add_argument("--spin-time", type=seconds, default=graph.MAX_WAIT_S, help="accepted and not used")
    parser.add_argument(
        "-s", "--use-sim-time", action="store_true", help="use the time on /clock for `auto` and `now`"
    )


def main(args: argparse.Namespace) -> int:
    """Publish until Ctrl-C, or as often as --once and --times request."""
    name = full_topic_name(args.topic_name)
    if not args.rate > 0:
        raise CommandError("rate must be greater than zero")
    wanted = _wanted_subscriptions(args)
    cls = message_class(args.message_type, search_graph=True)
    quality = qos.requested_qos(args, QoS()) or QoS()
    # Errors in values are reported before anything is on the wire.
    drafts = _drafts(cls, args)
    node = cli_node() if args.node_name is None else named_node(args.node_name)
    with graph.joined_participant() as participant, shown_node(participant, node):
        topic = topic_of(cls, name)
        writer = participant.create_writer(node, topic, quality)

        def look_for_mismatch() -> None:
            warn_of_mismatch(writer, participant.graph, name, is_publisher=True)

        try:
            _wait_for_subscriptions(
                writer,
                wanted,
                args.max_wait_time_secs,
                look_for_mismatch,
                lambda: mismatch_reason(participant.graph, topic, is_publisher=True),
            )
            with clock(participant, node, simulated=args.use_sim_time) as now_ns:
                _publish(writer, drafts, args, look_for_mismatch, now_ns)
            time.sleep(args.keep_alive)
        finally:
            writer.close()
    return 0


def _drafts(cls: type[Message], args: argparse.Namespace) -> Iterator[_Draft]:
    """Return the messages to publish: those of standard input or of a file, each once, or one again and again.

    Raises:
        CommandError: values come from two places, or the file can't be read, or holds no values or wrong ones.
    """
    if args.yaml_file is None:
        if args.stdin:
            return (_Draft(cls, text) for text in yaml_documents(standard_input()))
        return repeat(_Draft(cls, args.values))
    if args.stdin or args.values != "{}":
        raise CommandError("--yaml-file gives the values: give none on the command line, and no --stdin")
    drafts = []
    try:
        with Path(args.yaml_file).open(encoding="utf-8") as file:
            for number, text in enumerate(yaml_documents(file), 1):
                try:
                    drafts.append(_Draft(cls, text))
                except CommandError as error:
                    raise CommandError(f"{args.yaml_file}, document {number}: {error}") from None
    except (OSError, UnicodeDecodeError) as error:
        raise CommandError(f"{args.yaml_file} can't be read: {error}") from None
    if not drafts:
        raise CommandError(f"{args.yaml_file} holds no values")
    return iter(drafts)


class _Draft:
    """A message to publish, and the times in it that are set anew for each publication."""

    def __init__(self, cls: type[Message], values: str) -> None:
        self.message = cls()
        self._stamp_setters = fill_message(self.message, parse_yaml(values))

    def stamp(self, now_ns: NowNs) -> None:
        """Set the times that were given as `now` and the headers given as `auto`."""
        if self._stamp_setters:
            wait_until_known(now_ns)
            set_stamps(self._stamp_setters, now_ns())


def _wanted_subscriptions(args: argparse.Namespace) -> int:
    """Return for how many subscriptions to wait.

    Raises:
        CommandError: a longest wait is given, but nothing to wait for.
    """
    wanted = args.wait_matching_subscriptions
    if wanted is None:
        wanted = int(bool(args.once or args.times))
    if not wanted and args.max_wait_time_secs is not None:
        needed = "--wait-matching-subscriptions, --once or --times"
        raise CommandError(f"--max-wait-time-secs option is only effective with {needed}")
    return int(wanted)


def _wait_for_subscriptions(
    writer: Writer,
    wanted: int,
    max_wait_s: float | None,
    look_for_mismatch: Callable[[], None],
    why_unmet: Callable[[], str],
) -> None:
    """Wait for the wanted number; after `HINT_S` without any, print a possible reason on stderr."""
    start = reported = time.monotonic()
    hint_s = start + HINT_S
    while (match_count := writer.matched_count()) < wanted:
        look_for_mismatch()
        now = time.monotonic()
        if max_wait_s is not None and now - start >= max_wait_s:
            raise CommandError(
                f"waited {max_wait_s:g} s for {wanted} matching subscription(s), there are {match_count}"
            )
        if now - reported >= 1.0:
            print(f"Waiting for at least {wanted} matching subscription(s)...")
            reported = now
        if now >= hint_s:
            hint_s = math.inf
            if not match_count and (reason := why_unmet()):
                report(reason)
        time.sleep(0.01)


def _publish(
    writer: Writer,
    drafts: Iterator[_Draft],
    args: argparse.Namespace,
    look_for_mismatch: Callable[[], None],
    now_ns: NowNs,
) -> None:
    print("publisher: beginning loop")
    last = 1 if args.once else args.times
    start = time.monotonic()
    for number, draft in enumerate(drafts, 1):
        draft.stamp(now_ns)
        if args.print > 0 and number % args.print == 0:
            print(f"publishing #{number}: {draft.message!r}\n")
        writer.write(cdr.encode(draft.message))
        look_for_mismatch()
        if number == last:
            return
        # Relative to the start, so that the time for a message does not lower the rate.
        time.sleep(max(0.0, start + number / args.rate - time.monotonic()))
