"""What `ros2 bag info` prints of a bag."""

from __future__ import annotations

import datetime as dt
from collections import Counter
from collections.abc import Callable
from typing import NamedTuple

from tfloom.bag.bag import Bag
from tfloom.bag.metadata_from_files import metadata_of, size_of
from tfloom.bag.topic_choice import is_service_event, service_of_event
from tfloom.bag.values import Topic
from tfloom.bag.writing.metadata_text import NO_TIME_NS

__all__ = ["ORDERS", "info_text", "size_text"]

_WIDTH = 19
_UNITS = ("B", "KiB", "MiB", "GiB", "TiB")
_KIBI = 1024
_S_TO_NS = 1_000_000_000
_EVENT_TYPE_AT = 4
"""Where a service event's kind is: its first field, after the encapsulation header."""
_REQUEST_SENT, _REQUEST_RECEIVED, _RESPONSE_SENT, _RESPONSE_RECEIVED = range(4)
ORDERS: dict[str, Callable[[Topic], object]] = {
    "name": lambda topic: topic.name,
    "type": lambda topic: topic.type,
    "count": lambda topic: topic.message_count,
}
"""The orders of topics, by name."""


class _Contents(NamedTuple):
    """What is counted by reading messages, by topic."""

    sizes: Counter[str]
    """The bytes of the messages' data, without any compression."""
    kinds: dict[str, Counter[int]]
    """How many service events there are of each kind."""


def info_text(bag: Bag, *, verbose: bool = False, sort: str = "", size_contribution: bool = False) -> str:
    """Return the lines of a bag.

    Args:
        bag: The bag.
        verbose: Whether requests and responses of services are counted, for which their messages are read.
        sort: A key of `ORDERS`; empty: the order of the metadata.
        size_contribution: Whether the size of each topic's messages, and its share of all, are in its line; all
            messages are read for it.

    Raises:
        BagError: a file can't be read.
    """
    metadata = metadata_of(bag)
    all_topics: list[Topic] = list(metadata.topics)
    if sort:
        all_topics.sort(key=ORDERS[sort])  # type: ignore[arg-type]  # each key has one type
    topics = [topic for topic in all_topics if not is_service_event(topic.name, topic.type)]
    services = [topic for topic in all_topics if is_service_event(topic.name, topic.type)]
    contents = _contents(bag, all_topics if size_contribution else services if verbose else [])
    counts = _requests_and_responses(contents) if verbose else _event_count
    size = _size_contribution(contents) if size_contribution else _no_size
    has_messages = metadata.start_ns != NO_TIME_NS
    start_ns = metadata.start_ns if has_messages else 0
    lines = [
        "",
        _field("Files", *metadata.relative_file_paths),
        _field("Bag size", size_text(size_of(bag.path))),
        _field("Storage id", metadata.storage_identifier),
        _field("ROS Distro", metadata.ros_distro or "unknown"),
        _field("Duration", _seconds(metadata.duration_ns) + "s"),
        _field("Start", _stamp(start_ns)),
        _field("End", _stamp(start_ns + metadata.duration_ns)),
        _field("Messages", str(metadata.message_count)),
        _field("Topic information", *(_topic(topic, size(topic)) for topic in topics)),
        _field("Service", str(len(services))),
        "Service information: "
        + "\n                     ".join(_service(topic, counts(topic) + size(topic)) for topic in services),
    ]
    return "\n".join(lines)


def size_text(size: int) -> str:
    """Return a size [bytes] in a unit of 1024 or less."""
    value, unit = float(size), 0
    while value >= _KIBI and unit < len(_UNITS) - 1:
        value /= _KIBI
        unit += 1
    return f"{value:.{1 if unit else 0}f} {_UNITS[unit]}"


def _field(name: str, *values: str) -> str:
    return f"{name + ':':<{_WIDTH}}" + ("\n" + " " * _WIDTH).join(values)


def _seconds(duration_ns: int) -> str:
    return f"{duration_ns // _S_TO_NS}.{duration_ns % _S_TO_NS:09d}"


def _stamp(stamp_ns: int) -> str:
    """Return a stamp as a date of this machine's zone, and as a number."""
    seconds, rest = divmod(stamp_ns, _S_TO_NS)
    try:
        date = dt.datetime.fromtimestamp(seconds)  # noqa: DTZ006 - the user's own time
        text = f"{date:%b} {date.day:>2} {date:%Y %H:%M:%S}.{rest:09d}"
    except (OverflowError, ValueError, OSError):
        text = "no date"
    return f"{text} ({_seconds(stamp_ns)})"


def _topic(topic: Topic, size: str) -> str:
    return (
        f"Topic: {topic.name} | Type: {topic.type} | Count: {topic.message_count}{size} | "
        f"Serialization Format: {topic.serialization_format}"
    )


def _service(topic: Topic, counts: str) -> str:
    return (
        f"Service: {service_of_event(topic.name)} | Type: {topic.type.removesuffix('_Event')} | {counts} | "
        f"Serialization Format: {topic.serialization_format}"
    )


def _contents(bag: Bag, topics: list[Topic]) -> _Contents:
    """Return what the messages of some topics hold, in one pass over the bag; of none, nothing is read."""
    sizes = Counter({topic.name: 0 for topic in topics})
    kinds: dict[str, Counter[int]] = {
        topic.name: Counter() for topic in topics if is_service_event(topic.name, topic.type)
    }
    for message in bag.messages(list(sizes)) if topics else ():
        sizes[message.topic] += len(message.data)
        if message.topic in kinds and len(message.data) > _EVENT_TYPE_AT:
            kinds[message.topic][message.data[_EVENT_TYPE_AT]] += 1
    return _Contents(sizes, kinds)


def _event_count(topic: Topic) -> str:
    return f"Event Count: {topic.message_count}"


def _requests_and_responses(contents: _Contents) -> Callable[[Topic], str]:
    """Return what counts the requests and responses of a service."""

    def counts(topic: Topic) -> str:
        count = contents.kinds[topic.name]
        # A call is recorded at the server, at the client, or at both.
        requests = max(count[_REQUEST_RECEIVED], count[_REQUEST_SENT])
        responses = max(count[_RESPONSE_SENT], count[_RESPONSE_RECEIVED])
        return f"Request Count: {requests} | Response Count: {responses}"

    return counts


def _no_size(_: Topic) -> str:
    return ""


def _size_contribution(contents: _Contents) -> Callable[[Topic], str]:
    """Return what describes the size of a topic's messages, and its share of all messages."""
    whole = contents.sizes.total() or 1  # without a byte, each share is 0

    def size(topic: Topic) -> str:
        own = contents.sizes[topic.name]
        return f" | Size Contribution: {size_text(own)} ({100 * own / whole:.1f} %)"

    return size
