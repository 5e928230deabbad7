"""The common part of hz, bw and delay: a report each second over a window of a topic's newest messages."""

from __future__ import annotations

import argparse
import math
from collections import deque
from collections.abc import Callable, Sequence

from tfloom.cli.shared import graph
from tfloom.cli.shared.interfaces import message_class
from tfloom.cli.shared.listen import cli_node, find_type, samples_and_ticks, wait_for_publishers
from tfloom.cli.shared.names import full_topic_name
from tfloom.cli.shared.numbers import positive_count, seconds
from tfloom.cli.shared.qos import suiting_qos
from tfloom.cli.shared.sim_time import clock, wait_until_known
from tfloom.rmw.base import Sample
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
    parser.add_argument(
        "--spin-time", type=seconds, default=graph.MAX_WAIT_S, help="longest time of discovery in seconds"
    )
    parser.add_argument(
        "-s", "--use-sim-time", action="store_true", help="measure arrival by the time on /clock"
    )


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
        # Receipts have this machine's time. Under a simulation, the time of /clock at the callback takes their place.
        simulated = args.use_sim_time and not getattr(args, "wall_time", False)
        with clock(participant, cli_node(), simulated=simulated) as now_ns:
            if simulated:
                wait_until_known(now_ns)
            for sample in samples_and_ticks(participant, name, cls, suiting_qos(publishers), tick_s=REPORT_S):
                if sample is None:
                    report(now_ns() * 1e-9)
                else:
                    on_sample(sample, cls, (now_ns() if simulated else sample.received_stamp_ns) * 1e-9)
