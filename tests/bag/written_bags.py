"""Bags that tests write, and what other readers find in them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from rosbags.highlevel import AnyReader

from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.bag.writing.definition_text import find_definition, hash_of
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr

START_NS = 1_700_000_000_000_000_000
STEP_NS = 1_000_000
QOS = """- history: keep_last
  depth: 7
  reliability: reliable
  durability: volatile
  deadline:
    sec: 9223372036
    nsec: 854775807
  lifespan:
    sec: 9223372036
    nsec: 854775807
  liveliness: automatic
  liveliness_lease_duration:
    sec: 9223372036
    nsec: 854775807
  avoid_ros_namespace_conventions: false"""

Row = tuple[str, int, bytes]
"""Topic, log time, bytes."""


def topic(name: str, type_name: str, qos: str = QOS) -> Topic:
    return Topic(name, type_name, "cdr", hash_of(type_name), qos, find_definition(type_name))


CHATTER = topic("/chatter", "std_msgs/msg/String")


def text(number: int) -> bytes:
    return cdr.encode(String(data=f"message {number}"))


def row(number: int) -> Row:
    """Return the message of a number on /chatter."""
    return ("/chatter", START_NS + number * STEP_NS, text(number))


def begin_bag(folder: Path, settings: WriterSettings | None = None) -> tuple[BagWriter, int]:
    """Return the writer of a new bag, and the channel of /chatter in it."""
    writer = BagWriter(folder, settings)
    return writer, writer.add_topic(CHATTER)


def push(writer: Any, channel: int, *numbers: int) -> None:
    """Push the messages of numbers into a writer, or into its queue."""
    for number in numbers:
        _, stamp_ns, data = row(number)
        writer.push(channel, data, stamp_ns, stamp_ns)


def raising(error: BaseException) -> Callable[..., Any]:
    """Return a function that raises an error."""

    def fail(*_: object, **__: object) -> Any:
        raise error

    return fail


def transforms(number: int) -> bytes:
    message = TransformStamped(child_frame_id="base")
    message.header.frame_id = "map"
    message.header.stamp.sec = number
    message.transform.rotation.w = 1.0
    return cdr.encode(TFMessage(transforms=[message]))


def write_bag(folder: Path, settings: WriterSettings | None = None, count: int = 100) -> list[Row]:
    """Write a bag of texts and transforms by turns; return its messages."""
    writer = BagWriter(folder, settings)
    channels = {
        "/chatter": writer.add_topic(CHATTER),
        "/tf": writer.add_topic(topic("/tf", "tf2_msgs/msg/TFMessage")),
        "/silent": writer.add_topic(topic("/silent", "std_msgs/msg/Empty")),
    }
    rows: list[Row] = []
    for number in range(count):
        name = "/tf" if number % 2 else "/chatter"
        data = transforms(number) if number % 2 else text(number)
        rows.append((name, START_NS + number * STEP_NS, data))
        writer.push(channels[name], data, rows[-1][1], rows[-1][1] - 1)
    writer.close()
    return rows


def read_by_rosbags(folder: Path) -> list[Row]:
    with AnyReader([folder]) as reader:
        for connection, _, data in reader.messages():
            reader.deserialize(data, connection.msgtype)
        return [(connection.topic, stamp, bytes(data)) for connection, stamp, data in reader.messages()]
