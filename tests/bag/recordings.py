"""Recordings that tests make, with the writers of mcap and rosbags and with sqlite3."""

from __future__ import annotations

import math
import re
import sqlite3
import tracemalloc
import warnings
from collections.abc import Iterable
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from mcap.writer import CompressionType, Writer

from tfloom.bag import BagError, BagWarning, open_bag
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl.cdr import encode

SECOND = 1_000_000_000
START = 1_700_000_000 * SECOND
COMPRESSIONS = {"": CompressionType.NONE, "lz4": CompressionType.LZ4, "zstd": CompressionType.ZSTD}

Recorded = tuple[str, int, bytes]
"""Topic, log time, bytes."""


def transform(frame_id: str, child_frame_id: str, stamp_ns: int, x: float, yaw_rad: float = 0.0) -> Any:
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id = frame_id, child_frame_id
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(stamp_ns, SECOND)
    message.transform.translation.x = x
    message.transform.rotation.z, message.transform.rotation.w = math.sin(yaw_rad / 2), math.cos(yaw_rad / 2)
    return message


def drive(count: int = 50, namespace: str = "") -> list[Recorded]:
    """Return a robot's drive: map -> odom -> base_link at 100 Hz, a static lidar, and texts beside them."""
    static = TFMessage(transforms=[transform("base_link", "lidar", 0, 0.5)])
    found: list[Recorded] = [(f"{namespace}/tf_static", START, encode(static))]
    for i in range(count):
        stamp = START + i * SECOND // 100
        moving = [
            transform("map", "odom", stamp, 0.1 * i),
            transform("odom", "base_link", stamp, 1.0, 0.02 * i),
        ]
        found.append((f"{namespace}/tf", stamp, encode(TFMessage(transforms=moving))))
        found.append(("/chatter", stamp + 1, encode(String(data=f"text {i}"))))
    return found


def type_of(topic: str) -> str:
    return "tf2_msgs/msg/TFMessage" if topic.endswith(("tf", "tf_static")) else "std_msgs/msg/String"


def write_mcap(path: Path, messages: Iterable[Recorded], compression: str = "", **options: Any) -> Path:
    """Write a file with mcap's own writer."""
    with path.open("wb") as file:
        writer = Writer(file, **{"chunk_size": 2000, "compression": COMPRESSIONS[compression], **options})
        writer.start("ros2", "a test")
        channels: dict[str, int] = {}
        for topic, stamp, data in messages:
            if topic not in channels:
                text = b"string data" if type_of(topic).endswith("String") else TF_DEFINITION
                schema = writer.register_schema(type_of(topic), "ros2msg", text)
                channels[topic] = writer.register_channel(topic, "cdr", schema)
            writer.add_message(channels[topic], stamp, data, stamp)
        writer.finish()
    return path


TF_DEFINITION = b"""geometry_msgs/TransformStamped[] transforms
================================================================================
MSG: geometry_msgs/TransformStamped
std_msgs/Header header
string child_frame_id
geometry_msgs/Transform transform
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
================================================================================
MSG: geometry_msgs/Transform
geometry_msgs/Vector3 translation
geometry_msgs/Quaternion rotation
================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x 0
float64 y 0
float64 z 0
float64 w 1
"""

TOPIC_COLUMNS = {
    1: "",
    2: ", offered_qos_profiles TEXT NOT NULL",
    4: ", offered_qos_profiles TEXT NOT NULL, type_description_hash TEXT NOT NULL",
}
"""What the table of topics has beside id, name, type and serialization_format, by the schema's version."""


def write_sqlite(path: Path, messages: Iterable[Recorded], version: int = 4) -> Path:
    """Write a file with the tables of a schema version of rosbag2."""
    with sqlite3.connect(path) as database:
        database.execute(
            "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
            f"serialization_format TEXT NOT NULL{TOPIC_COLUMNS[version]})"
        )
        database.execute(
            "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, "
            "data BLOB NOT NULL)"
        )
        ids: dict[str, int] = {}
        for topic, stamp, data in messages:
            if topic not in ids:
                ids[topic] = len(ids) + 1
                more = TOPIC_COLUMNS[version].count(",")
                values = [ids[topic], topic, type_of(topic), "cdr", *[""] * more]
                database.execute(f"INSERT INTO topics VALUES ({','.join('?' * len(values))})", values)
            database.execute(
                "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", (ids[topic], stamp, data)
            )
    database.close()
    return path


def change_database(path: Path, statements: str) -> None:
    """Execute statements on a database."""
    with closing(sqlite3.connect(path)) as database, database:
        database.executescript(statements)


def found_in(bag: Any) -> list[Recorded]:
    """Return the messages of a recording."""
    return [(message.topic, message.log_time_ns, message.data) for message in bag.messages()]


def rows_of(path: Path) -> list[Recorded]:
    """Return the messages of a recording by its path."""
    with open_bag(path) as bag:
        return found_in(bag)


def watched(
    path: Path, start_ns: int | None = None, end_ns: int | None = None
) -> tuple[list[bytes], list[str], int]:
    """Return the messages' bytes, the warnings, and the memory that was used at most."""
    tracemalloc.start()
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            found = [message.data for message in open_bag(path).messages(None, start_ns, end_ns)]
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert all(issubclass(warning.category, BagWarning) for warning in caught)
    assert all(str(warning.message).startswith(f"{path}: ") for warning in caught)
    return found, [str(warning.message) for warning in caught], most


def error_of(path: Path, text: str) -> Any:
    """Expect a BagError that begins with the path and has the text."""
    return pytest.raises(BagError, match=f"(?s)^{re.escape(str(path))}.*{re.escape(text)}")
