"""Readers that return one message after the other, and what is known of a bag, also written anew."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from tfloom.bag.bag import Bag
from tfloom.bag.errors import BagError
from tfloom.bag.info_text import info_text
from tfloom.bag.message_classes import other_form
from tfloom.bag.metadata_from_files import metadata_of, size_of
from tfloom.bag.opening import open_bag
from tfloom.bag.reindexing import reindex
from tfloom.bag.rosbag2_names.storage import (
    BagMetadata,
    ConverterOptions,
    MessageDefinition,
    ReadOrder,
    ReadOrderSortBy,
    StorageFilter,
    StorageOptions,
    TopicMetadata,
    options_error,
)
from tfloom.bag.topic_choice import action_of
from tfloom.bag.values import RawMessage, Topic
from tfloom.bag.writing.definition_text import find_definition, hash_of
from tfloom.bag.writing.storage import STORAGES
from tfloom.rosidl.message import DecodeError
from tfloom.rosidl.other_forms import Form, converted

__all__ = ["Info", "Reindexer", "SequentialCompressionReader", "SequentialReader", "get_registered_readers"]

_NOT_OPEN = "rosbag2_py", "no bag is open: call open() before"
_PARTS = 64
"""Into how many parts of equal time a bag is divided at least, to read it in reverse."""
_PART_SIZE = 1 << 25
"""How large a part is on average at most, because its messages are in memory [bytes]."""


class SequentialReader:
    """Reads the messages of a bag in the order of log times."""

    def __init__(self) -> None:
        self._bag: Bag | None = None
        self._bounds: tuple[int | None, int | None] = (None, None)
        self._start_ns: int | None = None
        self._filter = StorageFilter()
        self._is_reverse = False
        self._messages: Iterator[RawMessage] | None = None
        self._next: RawMessage | None = None
        self._last: RawMessage | None = None
        """The message that was read last, after which a new filter goes on."""
        self._twins = 0
        """How many messages equal to it were read before it, one after the other."""
        self._others: dict[str, Form] = {}
        """The topics whose recorded definition is another form of the class here, which programs decode with."""

    def open(self, arg0: StorageOptions, arg1: ConverterOptions) -> None:
        """Open a bag.

        Raises:
            BagError: there is no such bag, it can't be read, or a serialization format is not cdr.
        """
        if (error := options_error("open", arg0, arg1)) is not None:
            raise error
        for name in (arg1.input_serialization_format, arg1.output_serialization_format):
            if name not in {"", "cdr"}:
                raise BagError(arg0.uri, f"the format is cdr; it can't be converted from or to '{name}'")
        self.close()
        self._bag = open_bag(Path(arg0.uri))
        forms = {name: other_form(self._bag.path, topic) for name, topic in self._bag.topics.items()}
        self._others = {name: form for name, form in forms.items() if form is not None}
        limits = (arg0.start_time_ns, arg0.end_time_ns)
        self._bounds = (None if limits[0] < 0 else limits[0], None if limits[1] < 0 else limits[1])
        self._start_ns = None
        self._begin_anew()

    def open_uri(self, arg0: str) -> None:
        """Open a bag by its path.

        Raises:
            BagError: there is no such bag, or it can't be read.
        """
        self.open(StorageOptions(arg0), ConverterOptions())

    def close(self) -> None:
        """Close the bag. Closing again does nothing."""
        bag, self._bag = self._bag, None
        self._messages = self._next = None
        if bag is not None:
            bag.close()

    def has_next(self) -> bool:
        """Return whether there is another message.

        Raises:
            BagError: no bag is open, or it can't be read.
        """
        if self._bag is None:
            raise BagError(*_NOT_OPEN)
        if self._next is None:
            if self._messages is None:
                self._messages = self._begin()
            self._next = next(self._messages, None)
        return self._next is not None

    def read_next(self) -> tuple[str, bytes, int]:
        """Return the next message: topic, serialized bytes, log time [ns since epoch].

        Of a type that distributions define otherwise, the bytes are those of the class here.

        Raises:
            BagError: there is none, no bag is open, or it can't be read.
        """
        if not self.has_next() or self._next is None:
            raise BagError(self._opened().path, "there are no more messages")
        message, self._next = self._next, None
        self._twins = self._twins + 1 if message == self._last else 0
        self._last = message
        return message.topic, self._as_here(message), message.log_time_ns

    def _as_here(self, message: RawMessage) -> bytes:
        """Return the bytes of a message in the form that its class has here; damaged ones as they are."""
        form = self._others.get(message.topic)
        if form is not None:
            with suppress(DecodeError):
                return converted(self._opened().topics[message.topic].type, form, message.data)
        return message.data

    def read_next_ext(self) -> tuple[str, bytes, int, int]:
        """Return the next message: topic, serialized bytes, log time and time of publication [ns since epoch].

        Raises:
            BagError: there is none, no bag is open, or it can't be read.
        """
        topic, data, log_ns = self.read_next()
        return topic, data, log_ns, log_ns if self._last is None else self._last.publish_time_ns

    def seek(self, arg0: int) -> None:
        """Go on with the messages from a log time on [ns since epoch]; in reverse, up to it."""
        self._start_ns = arg0
        self._begin_anew()

    def set_filter(self, arg0: StorageFilter) -> None:
        """Return only messages of some topics from now on: those after the message that was read last."""
        self._filter = arg0
        self._messages = self._next = None

    def reset_filter(self) -> None:
        """Return messages of all topics from now on: those after the message that was read last."""
        self.set_filter(StorageFilter())

    def set_read_order(self, arg0: ReadOrder) -> bool:
        """Set the order, and begin again; return False, and change nothing, for an order that bags don't have here.

        That is any but the order of log times, forward or in reverse.
        """
        if arg0.sort_by != ReadOrderSortBy.ReceivedTimestamp:
            return False
        self._is_reverse = arg0.reverse
        self._begin_anew()
        return True

    def get_all_topics_and_types(self) -> list[TopicMetadata]:
        """Return the topics.

        Raises:
            BagError: no bag is open.
        """
        return [TopicMetadata.from_topic(topic, number) for number, topic in enumerate(self._topics(), 1)]

    def _topics(self) -> list[Topic]:
        """Return the topics, as `read_next` has their messages."""
        return [
            topic._replace(type_hash=hash_of(topic.type), definition=find_definition(topic.type))
            if topic.name in self._others
            else topic
            for topic in self._opened().topics.values()
        ]

    def get_all_message_definitions(self) -> list[MessageDefinition]:
        """Return the definitions of the topics' types that the bag has.

        Raises:
            BagError: no bag is open.
        """
        by_type = {topic.type: topic for topic in self._topics() if topic.definition}
        return [MessageDefinition.of_topic(topic) for topic in by_type.values()]

    def get_metadata(self) -> BagMetadata:
        """Return what is known of the bag.

        Raises:
            BagError: no bag is open.
        """
        bag = self._opened()
        return BagMetadata.from_metadata(metadata_of(bag), size_of(bag.path))

    def _opened(self) -> Bag:
        if self._bag is None:
            raise BagError(*_NOT_OPEN)
        return self._bag

    def _begin_anew(self) -> None:
        self._messages = self._next = self._last = None

    def _begin(self) -> Iterator[RawMessage]:
        """Return the messages from the start, or those after the one that was read last."""
        if self._last is None:
            yield from self._wanted_from(self._start_ns)
            return
        # Messages of one time are in the order of recording, whatever the filter was: those before the last one have
        # been passed over, and those after it are still to come.
        last, twins = self._last, self._twins
        bag = self._opened()
        of_its_time = list(bag.messages(None, last.log_time_ns, last.log_time_ns))
        if self._is_reverse:
            of_its_time.reverse()
        places = [place for place, message in enumerate(of_its_time) if message == last]
        after = of_its_time[places[min(twins, len(places) - 1)] + 1 :] if places else []
        yield from (message for message in after if self._is_wanted(message.topic))
        yield from self._wanted_from(last.log_time_ns + (-1 if self._is_reverse else 1))

    def _wanted_from(self, start_ns: int | None) -> Iterator[RawMessage]:
        """Return the messages of the wanted topics from a log time on; in reverse, up to it."""
        bag = self._opened()
        first, last = self._bounds
        if start_ns is not None:
            if self._is_reverse:
                last = start_ns if last is None else min(last, start_ns)
            else:
                first = start_ns if first is None else max(first, start_ns)
        topics = [name for name in bag.topics if self._is_wanted(name)]
        if self._is_reverse:
            return _in_reverse(bag, topics, first, last)
        return bag.messages(topics, first, last)

    def _is_wanted(self, topic: str) -> bool:
        asked = self._filter
        action = action_of(topic)
        if topic in asked.exclude_topics or topic in asked.exclude_service_events:
            return False
        if action and action in asked.exclude_actions:
            return False
        if asked.regex_to_exclude and re.search(asked.regex_to_exclude, topic):
            return False
        if not (asked.topics or asked.services_events or asked.actions or asked.regex):
            return True
        is_named = topic in asked.topics or topic in asked.services_events or action in asked.actions
        return is_named or bool(asked.regex and re.search(asked.regex, topic))


def _in_reverse(
    bag: Bag, topics: list[str], first_ns: int | None, last_ns: int | None
) -> Iterator[RawMessage]:
    first = bag.start_ns if first_ns is None else max(first_ns, bag.start_ns)
    last = bag.end_ns if last_ns is None else min(last_ns, bag.end_ns)
    step = max((last - first) // max(_PARTS, bag.size // _PART_SIZE), 1)
    while last >= first:
        start = max(last - step + 1, first)
        yield from reversed(list(bag.messages(topics, start, last)))
        last = start - 1


class SequentialCompressionReader(SequentialReader):
    """The same as `SequentialReader`, which reads compressed bags too."""


def get_registered_readers() -> set[str]:
    """Return the storages that are read."""
    return set(STORAGES)


class Info:
    """Reads and prints the metadata of bags, as `rosbag2_py.Info`."""

    def read_metadata(self, arg0: str, arg1: str) -> BagMetadata:  # the storage is found by itself
        """Return what is known of a bag; the second argument is its storage.

        Raises:
            BagError: it can't be read.
        """
        with open_bag(Path(arg0)) as bag:
            return BagMetadata.from_metadata(metadata_of(bag), size_of(bag.path))

    def read_metadata_and_output_service_verbose(self, arg0: str, arg1: str) -> None:  # as above
        """Print what is known of a bag, with the numbers of requests and responses.

        Raises:
            BagError: it can't be read.
        """
        with open_bag(Path(arg0)) as bag:
            print(info_text(bag, verbose=True))


class Reindexer:
    """Writes metadata.yaml from the files of a bag, as `rosbag2_py.Reindexer`."""

    def reindex(self, arg0: StorageOptions) -> None:
        """Write metadata.yaml from the files of a folder.

        Raises:
            BagError: there are none, or one of them can't be read.
        """
        reindex(Path(arg0.uri), arg0.storage_id)
