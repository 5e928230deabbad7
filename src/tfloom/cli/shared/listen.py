"""Topics on `rmw`, without a node: type, publishers, and samples as they arrive."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from tfloom._native import ReadyQueue
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.graph import known_topics
from tfloom.cli.shared.names import did_you_mean
from tfloom.common.terminal import report
from tfloom.rmw.base import EndpointInfo, Graph, NodeName, Participant, Reader, Sample, Topic, Writer
from tfloom.rmw.errors import UnsupportedEventError
from tfloom.rmw.events import Count, Event, IncompatibleQoS
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared.form_reader import create_reader
from tfloom.rmw.shared.waiting import wait_for_token
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message

PATIENCE_S = 1.0
"""Wait before the user gets a message about it [s]."""

MAX_TAKEN = 1000
"""Samples of a topic that are taken before the next topic's turn."""

HINT_S = 2.0
"""Wait of a publisher for subscriptions before the user gets a possible reason [s]."""


def find_type(graph: Graph, name: str) -> str:
    """Return the type of a topic that is on the graph.

    Raises:
        CommandError: there is no such topic, or it has several types.
    """
    topics = known_topics(graph.endpoints())
    types = topics.get(name, [])
    if not types:
        print(f"WARNING: topic [{name}] does not appear to be published yet")
        raise CommandError(f"Could not determine the type for the passed topic{did_you_mean(name, topics)}")
    if len(types) > 1:
        raise CommandError(
            f"Cannot determine the type of '{name}', as it contains more than one: [{', '.join(types)}]"
        )
    return types[0]


def publishers_of(graph: Graph, name: str) -> list[EndpointInfo]:
    """Return the writers of a topic."""
    return [end for end in graph.endpoints() if end.is_writer and end.topic.name == name]


def wait_for_publishers(graph: Graph, name: str, end_s: float) -> list[EndpointInfo]:
    """Wait for writers of the topic and return them; return none at `end_s` on the monotonic clock."""
    queue = ReadyQueue()
    graph.notify(queue)
    try:
        report_s = time.monotonic() + PATIENCE_S
        while not (publishers := publishers_of(graph, name)):
            # The queue was registered before the graph is read, so a change in between has posted a token already.
            now_s = time.monotonic()
            if now_s >= end_s:
                return []
            if now_s >= report_s:
                near = did_you_mean(name, {end.topic.name for end in graph.endpoints() if end.is_writer})
                report(f"waiting for a publisher of {name}{near}")
                report_s = math.inf
            wait_for_token(queue, min(end_s, report_s))
        return publishers
    finally:
        graph.notify(None)


def mismatch_reason(graph: Graph, topic: Topic, *, is_publisher: bool) -> str:
    """Return why a topic's publisher or subscription matches no peer, by names and types; empty if it may match."""
    others = [end.topic for end in graph.endpoints() if end.is_writer is not is_publisher]
    types = sorted({other.type_name for other in others if other.name == topic.name})
    if not types:
        peer = "subscription" if is_publisher else "publisher"
        return f"no {peer} of {topic.name} yet{did_you_mean(topic.name, sorted({other.name for other in others}))}"
    if topic.type_name in types:
        return ""
    verb = "subscribed to" if is_publisher else "published"
    return f"{topic.name} is {verb} as {', '.join(types)}, not as {topic.type_name}"


def cli_node() -> NodeName:
    """Return the name of a command's node on the graph; the underscore hides it from `node list`."""
    return NodeName("/", f"_ros2cli_{os.getpid()}")


@contextmanager
def shown_node(participant: Participant, node: NodeName) -> Iterator[NodeName]:
    """Add a node to the graph for the block."""
    participant.add_node(node)
    try:
        yield node
    finally:
        participant.remove_node(node)


def decoded(cls: type[Message], sample: Sample) -> Any:
    """Return a sample's message; if the bytes are not of its type, print a line on stderr and return None."""
    try:
        return cdr.decode(cls, sample.data)
    except cdr.DecodeError as error:
        report(f"dropped a message that can't be decoded: {error}")
        return None


def samples(
    participant: Participant,
    name: str,
    message_class: type[Message],
    qos: QoS,
    end_s: float = math.inf,
    on_lost: Callable[[Count], None] | None = None,
    node: NodeName | None = None,
) -> Iterator[Sample]:
    """Yield the samples of a topic as they arrive, until `end_s` on the monotonic clock.

    `on_lost` is called with the count of lost samples, if the wire counts them. `node` is the node that subscribes;
    None: a hidden one.
    """
    for sample in samples_and_ticks(
        participant, name, message_class, qos, end_s=end_s, on_lost=on_lost, node=node
    ):
        if sample is not None:
            yield sample


def samples_and_ticks(
    participant: Participant,
    name: str,
    message_class: type[Message],
    qos: QoS,
    *,
    tick_s: float = math.inf,
    end_s: float = math.inf,
    on_lost: Callable[[Count], None] | None = None,
    node: NodeName | None = None,
) -> Iterator[Sample | None]:
    """Yield the samples of a topic as they arrive, and None every `tick_s`; the other arguments as for `samples`."""
    topic = topic_of(message_class, name)
    with shown_node(participant, node or cli_node()) as shown:
        reader = create_reader(participant, shown, topic, qos, report)
        try:
            queue = ReadyQueue()
            reader.notify(queue)
            reader.notify_event(Event.INCOMPATIBLE_QOS, queue)
            if on_lost is not None:
                on_lost = _if_counted(reader, queue, on_lost)
            next_tick_s = time.monotonic() + tick_s
            while time.monotonic() < end_s:
                # Take until the reader is empty, because a token says that there is something, not how much. Stop when
                # a tick or the end is due: a topic faster than its consumer would never leave this loop.
                while sample := reader.take():
                    if on_lost is not None:
                        _report_losses(reader, on_lost)
                    yield sample
                    if time.monotonic() >= min(next_tick_s, end_s):
                        break
                else:
                    # The reader is empty: sleep until data, an incompatible publisher, a loss, or the next tick.
                    wait_for_token(queue, min(end_s, next_tick_s))
                    if on_lost is not None:
                        _report_losses(reader, on_lost)
                    warn_of_mismatch(reader, participant.graph, name, is_publisher=False)
                if time.monotonic() >= next_tick_s:
                    # Count from the time when it was due, so that late ticks don't shift those that follow.
                    next_tick_s += tick_s
                    yield None
        finally:
            reader.close()


class TopicReaders:
    """The readers of several topics, for a node of a command.

    Args:
        participant: Where they are created.
        node: The node that they belong to.
    """

    def __init__(self, participant: Participant, node: NodeName) -> None:
        self.queue = ReadyQueue()
        """Gets a token when one has a sample, or an incompatible publisher."""
        self.participant = participant
        self._node = node
        self._open: dict[str, tuple[Reader, type[Message]]] = {}

    def __contains__(self, name: str) -> bool:
        return name in self._open

    def open(self, name: str, message_class: type[Message], qos: QoS) -> None:
        """Begin to read a topic."""
        topic = topic_of(message_class, name)
        reader = create_reader(self.participant, self._node, topic, qos, report)
        self._open[name] = reader, message_class
        reader.notify(self.queue)
        reader.notify_event(Event.INCOMPATIBLE_QOS, self.queue)

    def take(self) -> Iterator[tuple[str, type[Message], Sample]]:
        """Yield what each topic has, up to `MAX_TAKEN`: the topic, its type and a sample."""
        for name, (reader, message_class) in self._open.items():
            for _ in range(MAX_TAKEN):
                if (sample := reader.take()) is None:
                    break
                yield name, message_class, sample

    def warn_of_mismatches(self) -> None:
        """Print a warning on stderr for each new publisher that is incompatible."""
        for name, (reader, _) in self._open.items():
            warn_of_mismatch(reader, self.participant.graph, name, is_publisher=False)

    def close(self) -> None:
        """Close the readers."""
        for reader, _ in self._open.values():
            reader.close()
        self._open.clear()


def _if_counted(
    reader: Reader, queue: ReadyQueue, on_lost: Callable[[Count], None]
) -> Callable[[Count], None] | None:
    """Enable the event of lost samples and return `on_lost`; None if the wire doesn't count them."""
    try:
        reader.notify_event(Event.MESSAGE_LOST, queue)
    except UnsupportedEventError:
        return None
    return on_lost


def _report_losses(reader: Reader, on_lost: Callable[[Count], None]) -> None:
    status = reader.take_event(Event.MESSAGE_LOST)
    if isinstance(status, Count):
        on_lost(status)


def warn_of_mismatch(end: Reader | Writer, graph: Graph, name: str, *, is_publisher: bool) -> None:
    """Print a warning on stderr if a new peer is incompatible with `end`."""
    status = end.take_event(Event.INCOMPATIBLE_QOS)
    if isinstance(status, IncompatibleQoS):
        from tfloom.rmw.shared.qos_mismatch import mismatch_text

        report(f"WARNING: {mismatch_text(status, name, end.gid, graph, is_publisher=is_publisher)}")
