"""The topics of a graph, and the messages of those that are shown."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.rmw.errors import WireError
from tfloom.rmw.qos import DurabilityPolicy, QoS, ReliabilityPolicy
from tfloom.rosidl import cdr
from tfloom.rosidl.class_search import UnknownTypeError, find_class_of_kind
from tfloom.rosidl.message import Message
from tfloom.viewer.displays.kinds import KEPT_TYPES
from tfloom.viewer.history import Entry, History, Messages, header_stamp_ns
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.type_searches import TypeSearches

if TYPE_CHECKING:
    from tfloom.rmw.base import EndpointInfo, NodeName, Participant, Reader

__all__ = ["Follower", "LiveTopics", "Topics", "TypeNotYetKnownError", "begins_with_header"]

DEPTH = 50
"""Number of messages of a topic that wait between two pictures; older ones are dropped."""
LATCHED_DEPTH = 100
"""… of a topic whose publishers keep messages for late subscriptions."""
KEPT_DEPTH = 2000
"""… of a topic of which all messages matter: one that is dropped doesn't come again."""
MAX_TAKEN = 200
"""Number of messages of a topic that are taken for one picture."""


class TypeNotYetKnownError(DisplayError):
    """The type of a topic has no definition here, and is searched for among the nodes that use it."""


class Follower(Protocol):
    """Reads all messages of one topic, one after the other."""

    def take(self) -> Iterable[Entry]:
        """Return the messages that have come since. Never waits."""

    def decode(self, data: bytes) -> Any:
        """Return the message of an entry's bytes.

        Raises:
            DecodeError: the bytes are none.
        """

    def close(self) -> None:
        """End reading."""


class Topics(Protocol):
    """Where messages come from: a graph, or a recording."""

    def types(self) -> Mapping[str, str]:
        """Return the type of each topic, by its name."""

    def open(self, topic: str) -> tuple[Messages, Callable[[bytes], Any]]:
        """Begin to read a topic; return its messages, and the function that decodes one.

        Raises:
            DisplayError: it can't be read.
        """

    def close(self, topic: str) -> None:
        """End reading a topic."""

    def message_class(self, topic: str) -> type[Message]:
        """Return the class of a topic's messages.

        Raises:
            DisplayError: there is no such topic, or its type is unknown here.
            TypeNotYetKnownError: its type is searched for, as `poll` is called.
        """

    def follow(self, topic: str) -> Follower:
        """Begin to read all messages of a topic, beside those of `open`.

        Raises:
            DisplayError: it can't be read.
        """

    def poll(self) -> None:
        """Take what has come. Never waits."""


class LiveTopics:
    """The topics of a graph. One thread may use it.

    Readers are best effort, so that no publisher waits for the viewer. Those of topics whose publishers keep messages
    for late subscriptions are not, because such a message is only sent to a reliable reader; nor are those of topics of
    which all messages matter.

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
        self._readers: dict[str, tuple[Reader, History, bool]] = {}
        self._types: dict[str, str] = {}
        self._changes = -1
        self._searches = TypeSearches(participant, node)

    def types(self) -> Mapping[str, str]:
        """Return the type of each topic that is published, by its name."""
        graph = self._participant.graph
        if (changes := graph.changes()) != self._changes:
            self._changes = changes
            self._types = {end.topic.name: end.topic.type_name for end in graph.endpoints() if end.is_writer}
        return self._types

    def open(self, topic: str) -> tuple[Messages, Callable[[bytes], Any]]:
        """Begin to read a topic; return its messages, and the function that decodes one.

        Raises:
            DisplayError: nobody publishes it, its type is unknown here, or the wire refuses a reader.
        """
        self.close(topic)
        message_class = self.message_class(topic)
        reader, is_latched = self._reader(topic)
        history = History(self._history_ns, is_latched=is_latched)
        self._readers[topic] = reader, history, begins_with_header(message_class)
        return history, lambda data: cdr.decode(message_class, data)

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
        ends = self._participant.graph.endpoints()
        writers = [end for end in ends if end.is_writer and end.topic.name == topic]
        if not writers:
            raise DisplayError(f"nobody publishes {topic}")
        return writers

    def follow(self, topic: str) -> Follower:
        """Begin to read all messages of a topic, beside those of `open`.

        Raises:
            DisplayError: nobody publishes it, its type is unknown here, or the wire refuses a reader.
        """
        message_class = self.message_class(topic)
        return _LiveFollower(self._reader(topic)[0], message_class, self._now_ns)

    def _reader(self, topic: str) -> tuple[Reader, bool]:
        """Return a new reader of a topic, and whether its publishers keep messages for late subscriptions.

        Raises:
            DisplayError: nobody publishes it, or the wire refuses a reader.
        """
        writers = self._writers(topic)
        is_latched = any(end.qos.resolved().durability is DurabilityPolicy.TRANSIENT_LOCAL for end in writers)
        do_all_matter = writers[0].topic.type_name in KEPT_TYPES
        is_reliable = is_latched or (
            do_all_matter
            and all(end.qos.resolved().reliability is ReliabilityPolicy.RELIABLE for end in writers)
        )
        qos = QoS(
            ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT,
            DurabilityPolicy.TRANSIENT_LOCAL if is_latched else DurabilityPolicy.VOLATILE,
            depth=KEPT_DEPTH if do_all_matter else LATCHED_DEPTH if is_latched else DEPTH,
        )
        try:
            return self._participant.create_reader(self._node, writers[0].topic, qos), is_latched
        except WireError as error:
            raise DisplayError(str(error)) from None

    def close(self, topic: str) -> None:
        """End reading a topic."""
        if (opened := self._readers.pop(topic, None)) is not None:
            opened[0].close()

    def close_all(self) -> None:
        """End reading all topics."""
        for topic in list(self._readers):
            self.close(topic)
        self._searches.close()

    def poll(self) -> None:
        """Take what has come. Never waits."""
        self._searches.poll()
        for reader, history, has_header in self._readers.values():
            for entry in _entries(reader, has_header, self._now_ns):
                history.add(entry)


def _entries(reader: Reader, has_header: bool, now_ns: Callable[[], int]) -> Iterable[Entry]:
    """Yield the messages that a reader has; those without a stamp get the time of now [ns since epoch]."""
    for _ in range(MAX_TAKEN):
        sample = reader.take()
        if sample is None:
            return
        stamp_ns = header_stamp_ns(sample.data) if has_header else 0
        yield Entry(stamp_ns or now_ns(), sample.data)


class _LiveFollower:
    """Reads all messages of a topic of a graph."""

    def __init__(self, reader: Reader, message_class: type[Message], now_ns: Callable[[], int]) -> None:
        self._reader = reader
        self._class = message_class
        self._now_ns = now_ns

    def take(self) -> Iterable[Entry]:
        return _entries(self._reader, begins_with_header(self._class), self._now_ns)

    def decode(self, data: bytes) -> Any:
        return cdr.decode(self._class, data)

    def close(self) -> None:
        self._reader.close()


def begins_with_header(message_class: Any) -> bool:
    """Return whether the messages of a class begin with a stamp."""
    return next(iter(message_class._FIELDS.values()), "") == "std_msgs/msg/Header"
