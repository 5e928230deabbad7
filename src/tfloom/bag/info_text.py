"""What `ros2 bag info` prints of a bag."""

from __future__ import annotations

import datetime as dt
from collections import Counter
from collections.abc import Callable

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


def info_text(bag: Bag, *, verbose: bool = False, sort: str = "") -> str:
    """Return the lines of a bag.

    Args:
        bag: The bag.
        verbose: Whether requests and responses of services are counted, for which their messages are read.
        sort: A key of `ORDERS`; empty: the order of the metadata.

    Raises:
        BagError: a file can't be read.
    """
    metadata = metadata_of(bag)
    all_topics: list[Topic] = list(metadata.topics)
    if sort:
        all_topics.sort(key=ORDERS[sort])  # type: ignore[arg-type]  # each key has one type
    topics = [topic for topic in all_topics if not is_service_event(topic.name, topic.type)]
    services = [topic for topic in all_topics if is_service_event(topic.name, topic.type)]
    describe = _service_describer(bag, services) if verbose else _service
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
        _field("Topic information", *map(_topic, topics)),
        _field("Service", str(len(services))),
        "Service information: " + "\n                     ".join(map(describe, services)),
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


def _topic(topic: Topic) -> str:
    return (
        f"Topic: {topic.name} | Type: {topic.type} | Count: {topic.message_count} | "
        f"Serialization Format: {topic.serialization_format}"
    )


def _service(topic: Topic) -> str:
    return _service_line(topic, f"Event Count: {topic.message_count}")


def _service_line(topic: Topic, counts: str) -> str:
    return (
        f"Service: {service_of_event(topic.name)} | Type: {topic.type.removesuffix('_Event')} | {counts} | "
        f"Serialization Format: {topic.serialization_format}"
    )


def _service_describer(bag: Bag, services: list[Topic]) -> Callable[[Topic], str]:
    """Return what describes a service with the numbers of its requests and responses."""
    kinds: dict[str, Counter[int]] = {service.name: Counter() for service in services}
    if services:
        for message in bag.messages(list(kinds)):
            if len(message.data) > _EVENT_TYPE_AT:
                kinds[message.topic][message.data[_EVENT_TYPE_AT]] += 1

    def describe(topic: Topic) -> str:
        count = kinds[topic.name]
        # A call is recorded at the server, at the client, or at both.
        requests = max(count[_REQUEST_RECEIVED], count[_REQUEST_SENT])
        responses = max(count[_RESPONSE_SENT], count[_RESPONSE_RECEIVED])
        return _service_line(topic, f"Request Count: {requests} | Response Count: {responses}")

    return describe
