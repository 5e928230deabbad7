"""The topics of a graph, and the messages of those that are shown."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from functools import partial
from itertools import count
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.rmw.errors import WireError
from tfloom.rmw.shared.peer_types import TypeSearches
from tfloom.rosidl import cdr
from tfloom.rosidl.class_search import UnknownTypeError, find_class_of_kind
from tfloom.rosidl.message import Message
from tfloom.viewer.obstacles import other_type_text
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.topic_log import TopicLog, header_stamp_ns
from tfloom.viewer.topic_reader import TopicReader, is_latched

if TYPE_CHECKING:
    from tfloom.rmw.base import EndpointInfo, NodeName, Participant
    from tfloom.viewer.topic_log import Cursor

__all__ = ["RESET_NS", "LiveTopics", "Topics", "TypeNotYetKnownError", "begins_with_header"]

RESET_NS = 100_000_000
"""How far the time of a graph goes back when a simulation begins anew, at least: messages of /clock may overtake each
other [ns]."""
OLD_RUN_S = 1.0
"""How long messages of the run before may come after that [s]."""


class TypeNotYetKnownError(DisplayError):
    """The type of a topic has no definition here, and is searched for among the nodes that use it."""


class Topics(Protocol):
    """Where messages come from: a graph, or a recording."""

    def types(self) -> Mapping[str, str]:
        """Return the type of each topic, by its name."""

    def open(self, topic: str, depth: int = 0) -> Cursor:
        """Return a reader of a topic, before the first of the messages that are kept.

        Args:
            topic: The topic.
            depth: Number of messages of a graph that may wait to be taken; 0: as is usual for it.

        Raises:
            DisplayError: it can't be read.
        """

    def message_class(self, topic: str) -> type[Message]:
        """Return the class of a topic's messages.

        Raises:
            DisplayError: there is no such topic, or its type is unknown here.
            TypeNotYetKnownError: its type is searched for, as `poll` is called.
        """

    def silence(self, topic: str, type_name: str) -> str:
        """Return why no messages of a topic come that is read, as a sentence; empty if nothing keeps them away.

        Args:
            topic: The topic.
            type_name: The type of the messages that are read.
        """

    def poll(self) -> None:
        """Take what has come. Never waits."""

    def begin_anew(self) -> None:
        """Leave out, from now on for a while, what a simulation has sent that was reset."""


class LiveTopics:
    """The topics of a graph, each with one log for all who read it. One thread may use it.

    Args:
        participant: The participant that reads.
        node: The node whose readers these are, which was added to the participant.
        history_ns: Age of the messages that are kept [ns].
        now_ns: Returns the time that messages without a stamp get [ns since epoch].
    """

    def __init__(
        self, participant: Participant, node: NodeName, history_ns: int, now_ns: Callable[[], int]
    ) -> None:
        self._participant = participant
        self._node = node
        self._history_ns = history_ns
        self._now_ns = now_ns
        self._logs: dict[tuple[str, type[Message]], tuple[TopicReader, TopicLog]] = {}
        self._numbers = count()
        """Of all messages, so that those of a topic's later log are greater."""
        self._publishers: dict[str, list[EndpointInfo]] = {}
        """The publishers of each topic, as the graph was when it was read last."""
        self._changes = -1
        self._searches = TypeSearches(participant, node)
        self._old_run_end_s = -math.inf
        """Until when messages of a simulation's run before may come, on the monotonic clock [s]."""

    def types(self) -> Mapping[str, str]:
        """Return the type of each topic that is published, by its name."""
        return {topic: writers[0].topic.type_name for topic, writers in self._read_graph().items()}

    def _read_graph(self) -> Mapping[str, list[EndpointInfo]]:
        graph = self._participant.graph
        if (changes := graph.changes()) != self._changes:
            self._changes = changes
            self._publishers = {}
            for end in graph.endpoints():
                if end.is_writer:
                    self._publishers.setdefault(end.topic.name, []).append(end)
        return self._publishers

    def open(self, topic: str, depth: int = 0) -> Cursor:
        """Return a reader of a topic, before the first of the messages that are kept.

        Args:
            topic: The topic.
            depth: Number of messages that may wait to be taken, of which the greatest of all who read the topic
                counts; 0: as is usual for it. It may change, as `Cursor.depth`.

        Raises:
            DisplayError: nobody publishes it, its type is unknown here, or the wire refuses a reader.
        """
        name = topic, self.message_class(topic)
        if name not in self._logs:
            self._logs[name] = self._opened(name, depth)
        return self._logs[name][1].open(depth)

    def _opened(self, name: tuple[str, type[Message]], depth: int) -> tuple[TopicReader, TopicLog]:
        topic, message_class = name
        log = TopicLog(
            self._history_ns,
            partial(cdr.decode, message_class),
            is_latched=any(map(is_latched, self._writers(topic))),
            numbers=self._numbers,
            on_left=lambda: self._close(name),
        )
        try:
            reader = TopicReader(
                self._participant, self._node, lambda: self._read_graph().get(topic, ()), [depth]
            )
        except WireError as error:
            raise DisplayError(str(error)) from None
        return reader, log

    def message_class(self, topic: str) -> type[Message]:
        """Return the class of a topic's messages.

        Raises:
            DisplayError: nobody publishes it, or its type is unknown here.
            TypeNotYetKnownError: its type is searched for, as `poll` is called.
        """
        type_name = self._writers(topic)[0].topic.type_name
        try:
            return find_class_of_kind(type_name, "msg", Message)
        except UnknownTypeError as error:
            reasons = self._searches.reasons(type_name, "msg")
            if reasons is None:
                raise TypeNotYetKnownError(f"{type_name} is searched for among its publishers") from None
            raise DisplayError("; ".join([str(error), *reasons])) from None
        except (LookupError, ValueError) as error:
            raise DisplayError(str(error)) from None

    def _writers(self, topic: str) -> list[EndpointInfo]:
        """Return the publishers of a topic.

        Raises:
            DisplayError: there are none.
        """
        if not (writers := self._read_graph().get(topic)):
            raise DisplayError(f"nobody publishes {topic}")
        return writers

    def silence(self, topic: str, type_name: str) -> str:
        """Return why no messages of a topic come that is read, as a sentence; empty if nothing keeps them away.

        Args:
            topic: The topic.
            type_name: The type of the messages that are read.
        """
        sent = {writer.topic.type_name for writer in self._read_graph().get(topic, ())}
        if sent and type_name not in sent:
            return other_type_text(type_name, sorted(sent))
        readers = (
            reader
            for (name, message_class), (reader, _) in self._logs.items()
            if name == topic and type_name == message_class._TYPE_NAME
        )
        return next((reader.silence() for reader in readers), "")

    def _close(self, name: tuple[str, type[Message]]) -> None:
        if (opened := self._logs.pop(name, None)) is not None:
            opened[0].close()

    def close_all(self) -> None:
        """End reading all topics."""
        for name in list(self._logs):
            self._close(name)
        self._searches.close()

    def poll(self) -> None:
        """Take what has come. Never waits.

        Raises:
            DisplayError: the wire refuses a reader of publishers that have come.
            Exception: a topic can't be read. In both cases the messages of the other topics are taken.
        """
        self._searches.poll()
        is_after_reset = time.monotonic() < self._old_run_end_s
        latest_ns = self._now_ns() + RESET_NS if is_after_reset else math.inf
        fault: Exception | None = None
        for (_, message_class), (reader, log) in self._logs.items():
            try:
                reader.set_depths(log.depths)
                self._take(reader, log, latest_ns, has_header=begins_with_header(message_class))
                if reader.refusal:
                    fault = DisplayError(reader.refusal)
            except Exception as error:  # of one topic: the others are read
                fault = error
        if fault is not None:
            raise fault

    def begin_anew(self) -> None:
        """Leave out, for `OLD_RUN_S`, what is stamped ahead of now: a simulation has sent it that was reset."""
        self._old_run_end_s = time.monotonic() + OLD_RUN_S

    def _take(self, reader: TopicReader, log: TopicLog, latest_ns: float, *, has_header: bool) -> None:
        # A message of the run before that was on its way would be the newest one until this run is as old. What is kept
        # for late subscriptions is sent again, whatever its stamp.
        for sample in reader.take():
            stamp_ns = header_stamp_ns(sample.data) if has_header else 0
            if stamp_ns <= latest_ns or log.is_latched:
                log.add(stamp_ns or self._now_ns(), sample.data)


def begins_with_header(message_class: Any) -> bool:
    """Return whether the messages of a class begin with a stamp."""
    return next(iter(message_class._FIELDS.values()), "") == "std_msgs/msg/Header"
