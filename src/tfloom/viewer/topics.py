"""The topics of a graph, and the messages of those that are shown."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.rmw.errors import WireError
from tfloom.rosidl import cdr
from tfloom.rosidl.class_search import UnknownTypeError, find_class_of_kind
from tfloom.rosidl.message import Message
from tfloom.viewer.history import Entry, History, Messages, header_stamp_ns
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.topic_reader import TopicReader, is_latched
from tfloom.viewer.type_searches import TypeSearches

if TYPE_CHECKING:
    from tfloom.rmw.base import EndpointInfo, NodeName, Participant

__all__ = ["Follower", "LiveTopics", "Topics", "TypeNotYetKnownError", "begins_with_header"]


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
        self._readers: dict[str, tuple[TopicReader, History, bool]] = {}
        self._publishers: dict[str, list[EndpointInfo]] = {}
        """The publishers of each topic, as the graph was when it was read last."""
        self._changes = -1
        self._searches = TypeSearches(participant, node)

    def types(self) -> Mapping[str, str]:
        """Return the type of each topic that is published, by its name."""
        return {topic: writers[-1].topic.type_name for topic, writers in self._read_graph().items()}

    def _read_graph(self) -> Mapping[str, list[EndpointInfo]]:
        graph = self._participant.graph
        if (changes := graph.changes()) != self._changes:
            self._changes = changes
            self._publishers = {}
            for end in graph.endpoints():
                if end.is_writer:
                    self._publishers.setdefault(end.topic.name, []).append(end)
        return self._publishers

    def open(self, topic: str) -> tuple[Messages, Callable[[bytes], Any]]:
        """Begin to read a topic; return its messages, and the function that decodes one.

        Raises:
            DisplayError: nobody publishes it, its type is unknown here, or the wire refuses a reader.
        """
        self.close(topic)
        message_class = self.message_class(topic)
        reader = self._reader(topic)
        history = History(self._history_ns, is_latched=any(map(is_latched, self._writers(topic))))
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
        """Return the publishers of a topic.

        Raises:
            DisplayError: there are none.
        """
        if not (writers := self._read_graph().get(topic)):
            raise DisplayError(f"nobody publishes {topic}")
        return writers

    def follow(self, topic: str) -> Follower:
        """Begin to read all messages of a topic, beside those of `open`.

        Raises:
            DisplayError: nobody publishes it, its type is unknown here, or the wire refuses a reader.
        """
        message_class = self.message_class(topic)
        return _LiveFollower(self._reader(topic), message_class, self._now_ns)

    def _reader(self, topic: str) -> TopicReader:
        """Return a new reader of a topic.

        Raises:
            DisplayError: nobody publishes it, or the wire refuses a reader.
        """
        try:
            self._writers(topic)
            return TopicReader(self._participant, self._node, lambda: self._read_graph().get(topic, ()))
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
        """Take what has come. Never waits.

        Raises:
            DisplayError: the wire refuses a reader of publishers that have come; the other messages are taken.
        """
        self._searches.poll()
        refusal = ""
        for reader, history, has_header in self._readers.values():
            for entry in _entries(reader, has_header, self._now_ns):
                history.add(entry)
            refusal = refusal or reader.refusal
        if refusal:
            raise DisplayError(refusal)


def _entries(reader: TopicReader, has_header: bool, now_ns: Callable[[], int]) -> Iterable[Entry]:
    """Yield the messages that a reader has; those without a stamp get the time of now [ns since epoch]."""
    for sample in reader.take():
        stamp_ns = header_stamp_ns(sample.data) if has_header else 0
        yield Entry(stamp_ns or now_ns(), sample.data)


class _LiveFollower:
    """Reads all messages of a topic of a graph."""

    def __init__(self, reader: TopicReader, message_class: type[Message], now_ns: Callable[[], int]) -> None:
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
