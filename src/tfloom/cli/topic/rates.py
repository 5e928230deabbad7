"""The common part of hz, bw and delay: a report each second over a window of the newest messages."""

from __future__ import annotations

import argparse
import math
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.interfaces import message_class
from tfloom.cli.shared.listen import (
    TopicReaders,
    cli_node,
    find_type,
    publishers_of,
    samples_and_ticks,
    shown_node,
    wait_for_publishers,
)
from tfloom.cli.shared.names import full_topic_name
from tfloom.cli.shared.numbers import positive_count, seconds
from tfloom.cli.shared.qos import add_arguments as add_qos_arguments
from tfloom.cli.shared.qos import requested_qos, suiting_qos
from tfloom.cli.shared.sim_time import clock, wait_until_known
from tfloom.common.terminal import clear_terminal, report
from tfloom.rmw.base import Graph, Participant, Sample
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared.waiting import wait_for_token
from tfloom.ros_imports.ros_distro import NAMES_ARE_OPTIONAL
from tfloom.rosidl.message import Message

REPORT_S = 1.0


def add_arguments(parser: argparse.ArgumentParser, window: int) -> None:
    """Add the flags of all three."""
    parser.add_argument(
        "-w",
        "--window",
        type=positive_count,
        default=window,
        help=f"number of messages to average over (default: {window})",
    )
    add_qos_arguments(parser, default="compatible with all publishers of the topic")
    parser.add_argument(
        "--spin-time", type=seconds, default=graph.MAX_WAIT_S, help="longest time of discovery in seconds"
    )
    parser.add_argument(
        "-s", "--use-sim-time", action="store_true", help="measure arrival by the time on /clock"
    )


def add_topics(parser: argparse.ArgumentParser, metavar: str) -> None:
    """Add the topics of hz and bw."""
    parser.add_argument("topic_name", metavar=metavar, nargs="*", help="name of the topic, or of several")
    parser.add_argument(
        "-a", "--all", action="store_true", help="measure all topics, also those that appear later"
    )


def topics_of(args: argparse.Namespace) -> list[str]:
    """Return the full names of the topics in the arguments; none for all topics.

    Raises:
        CommandError: there are none and no --all, or both, or a name is not valid.
    """
    if not args.all and not args.topic_name:
        from tfloom.cli.shared import picking

        if picking.has_terminal() and "verb_parser" in args:  # which a program of an extension may lack
            args.topic_name = picking.picked(args.verb_parser, "topic_name", args, is_several=True)
        elif NAMES_ARE_OPTIONAL:
            raise CommandError(picking.NO_TERMINAL)
    if args.all == bool(args.topic_name):
        raise CommandError("name the topics, or give --all" + (" without names" if args.all else ""))
    return list(dict.fromkeys(map(full_topic_name, args.topic_name)))


class Window:
    """The newest values: their number, mean, extremes and spread."""

    def __init__(self, size: int) -> None:
        self.values: deque[float] = deque(maxlen=max(size, 1))
        self.is_new = False

    def add(self, value: float) -> None:
        """Add a value; the oldest is dropped when the window is full."""
        self.values.append(value)
        self.is_new = True

    def is_beyond(self, time_s: float) -> bool:
        """Return whether the newest value, a time [s], is later than another, because a simulation has restarted."""
        return bool(self.values) and self.values[-1] > time_s


def spread(values: Sequence[float]) -> tuple[float, float, float, float]:
    """Return mean, least, greatest and standard deviation."""
    mean = sum(values) / len(values)
    variance = sum((value - mean) ** 2 for value in values) / len(values)
    return mean, min(values), max(values), math.sqrt(variance)


def spread_line(values: Sequence[float], window: int) -> str:
    """Return the line on the least, the greatest and the deviation of times [s]."""
    _, least, greatest, deviation = spread(values)
    return f"\tmin: {least:.3f}s max: {greatest:.3f}s std dev: {deviation:.5f}s window: {window}"


def watch(
    args: argparse.Namespace,
    topic_name: str,
    on_sample: Callable[[Sample, type[Message], float], None],
    report: Callable[[float], None],
    check: Callable[[type[Message]], None] = lambda _: None,
) -> None:
    """Call `on_sample` with each sample of a topic and its time of arrival [s], and `report`, until Ctrl-C.

    Wait for a topic without publishers; `check` may reject its type. `report` is called each second, with the time
    [s]. With --use-sim-time, both times are those of /clock, and samples before the first one are not counted.
    """
    name = full_topic_name(topic_name)
    with graph.settled_participant(args.spin_time) as participant:
        if not any(end.topic.name == name for end in participant.graph.endpoints()):
            print(f"WARNING: topic [{name}] does not appear to be published yet")
        publishers = wait_for_publishers(participant.graph, name, math.inf)
        cls = message_class(find_type(participant.graph, name), participant)
        check(cls)
        quality = requested_qos(args, QoS()) or suiting_qos(publishers)
        with _clocks(args, participant) as (now_s, came_s):
            for sample in samples_and_ticks(participant, name, cls, quality, tick_s=REPORT_S):
                if sample is None:
                    report(now_s())
                else:
                    on_sample(sample, cls, came_s(sample))


@contextmanager
def _clocks(
    args: argparse.Namespace, participant: Participant
) -> Iterator[tuple[Callable[[], float], Callable[[Sample], float]]]:
    """Yield a function that returns the time [s], and one that returns a sample's time of arrival [s].

    Receipts have this machine's time. Under a simulation, the time of /clock when the function is called takes their
    place.
    """
    simulated = args.use_sim_time and not getattr(args, "wall_time", False)
    with clock(participant, cli_node(), simulated=simulated) as now_ns:
        if simulated:
            wait_until_known(now_ns)

        def now_s() -> float:
            return now_ns() * 1e-9

        yield now_s, (lambda _: now_s()) if simulated else (lambda sample: sample.received_stamp_ns * 1e-9)


def watch_several(
    args: argparse.Namespace,
    names: Sequence[str],
    on_sample: Callable[[str, Sample, type[Message], float], None],
    table: Callable[[float], list[str]],
) -> None:
    """Call `on_sample` with the name of a topic, its sample, its type and the time of arrival [s], until Ctrl-C.

    Each second the lines of `table`, which gets the time [s], are printed; on a terminal, in place of the last ones.

    Args:
        args: The arguments of the verb.
        names: The topics, which may have no publisher yet; none for all that are published, now or later.
        on_sample: See above.
        table: See above.
    """
    with (
        graph.settled_participant(args.spin_time) as participant,
        shown_node(participant, cli_node()) as node,
        closing(TopicReaders(participant, node)) as readers,
    ):
        for name in names:
            if not publishers_of(participant.graph, name):
                report(f"WARNING: topic [{name}] does not appear to be published yet")
        asked_qos = requested_qos(args, QoS())
        refused: set[str] = set()
        with _clocks(args, participant) as (now_s, came_s):
            next_report_s = time.monotonic() + REPORT_S
            while True:
                _open_published(participant.graph, names, readers, refused, asked_qos)
                while time.monotonic() < next_report_s:
                    is_idle = True
                    for name, cls, sample in readers.take():
                        is_idle = False
                        on_sample(name, sample, cls, came_s(sample))
                    if is_idle:
                        wait_for_token(readers.queue, next_report_s)
                next_report_s = max(next_report_s + REPORT_S, time.monotonic())
                readers.warn_of_mismatches()
                clear_terminal(sys.stdout)
                print("\n".join(table(now_s())), flush=True)


def _open_published(
    found: Graph, names: Sequence[str], readers: TopicReaders, refused: set[str], asked_qos: QoS | None
) -> None:
    """Begin to read those topics that have a publisher by now; without names, all but hidden ones.

    A topic that can't be read, for example because nobody has its type, is reported and added to `refused`.
    """
    published = {end.topic.name for end in found.endpoints() if end.is_writer}
    wanted = names or sorted(name for name in published if not graph.is_hidden(name))
    for name in wanted:
        if name in readers or name in refused or name not in published:
            continue
        try:
            cls = message_class(find_type(found, name), readers.participant)
        except CommandError as error:
            refused.add(name)
            report(f"{name}: {error}")
        else:
            readers.open(name, cls, asked_qos or suiting_qos(publishers_of(found, name)))


def table_lines(titles: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table, whose first column is names and whose others are numbers."""
    widths = [max(map(len, column)) for column in zip(titles, *rows, strict=True)]
    lines = [
        "   ".join(
            [
                row[0].ljust(widths[0]),
                *(cell.rjust(width) for cell, width in zip(row[1:], widths[1:], strict=True)),
            ]
        )
        for row in (titles, *rows)
    ]
    return [lines[0], "=" * len(lines[0]), *lines[1:], ""]
