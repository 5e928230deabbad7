"""Recordings made under each distribution: read by rosbags, under the other distributions, and played there."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from rosbags.highlevel import AnyReader
from tests.conftest import Program, run_to_end

from tfloom.ros_imports.ros_distro import DISTRIBUTIONS

COUNT = 10
STORAGES = ("mcap", "sqlite3")
TOPICS = ("/events", "/pose", "/texts", "/tf")
PUBLISH = f"""
import time
import rclpy
from geometry_msgs.msg import TransformStamped
from lifecycle_msgs.msg import TransitionEvent
from rclpy.duration import Duration
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from turtlesim.msg import Pose

def event(number):
    event = TransitionEvent()
    event.transition.label = f"transition {{number}}"
    if hasattr(event, "stamp"):
        event.stamp.sec, event.stamp.nanosec = 7, number
    else:
        event.timestamp = 7_000_000_000 + number
    return event

def transforms(number):
    transform = TransformStamped(child_frame_id=f"frame {{number}}")
    transform.transform.translation.x = float(number)
    return TFMessage(transforms=[transform])

MAKERS = {{
    "/events": event,
    "/pose": lambda number: Pose(x=float(number)),
    "/texts": lambda number: String(data=f"text {{number}}"),
    "/tf": transforms,
}}
with rclpy.init():
    node = rclpy.create_node("publishes")
    publishers = [node.create_publisher(type(make(0)), topic, 50) for topic, make in MAKERS.items()]
    while any(publisher.get_subscription_count() < {len(STORAGES)} for publisher in publishers):
        time.sleep(0.01)
    for number in range({COUNT}):
        for publisher, make in zip(publishers, MAKERS.values()):
            publisher.publish(make(number))
    assert all(publisher.wait_for_all_acked(Duration(seconds=20)) for publisher in publishers)
"""
READ = """
import json, sys
import rosbag2_py
from rclpy.serialization import deserialize_message
from rosidl_runtime_py import message_to_ordereddict
from rosidl_runtime_py.utilities import get_message

def contents(folder):
    reader = rosbag2_py.SequentialReader()
    reader.open(rosbag2_py.StorageOptions(folder), rosbag2_py.ConverterOptions("", ""))
    topics = {topic.name: topic for topic in reader.get_all_topics_and_types()}
    rows = {name: [] for name in topics}
    while reader.has_next():
        name, data, _ = reader.read_next()
        kind = get_message(topics[name].type)
        assert topics[name].type_description_hash == kind._TYPE_HASH, name
        rows[name].append(message_to_ordereddict(deserialize_message(data, kind)))
    texts = {each.topic_type: each.encoded_message_definition for each in reader.get_all_message_definitions()}
    return {"types": {name: topic.type for name, topic in topics.items()}, "rows": rows,
            "event": texts["lifecycle_msgs/msg/TransitionEvent"].splitlines()}

print(json.dumps([contents(folder) for folder in sys.argv[1:]]))
"""
COPY = """
import sys
import rosbag2_py

reader, writer = rosbag2_py.SequentialReader(), rosbag2_py.SequentialWriter()
reader.open(rosbag2_py.StorageOptions(sys.argv[1]), rosbag2_py.ConverterOptions("", ""))
writer.open(rosbag2_py.StorageOptions(sys.argv[2], "mcap"), rosbag2_py.ConverterOptions("", ""))
for topic in reader.get_all_topics_and_types():
    writer.create_topic(topic)
while reader.has_next():
    writer.write(*reader.read_next())
writer.close()
"""
LISTEN = """
import json, rclpy
from lifecycle_msgs.msg import TransitionEvent
from rosidl_runtime_py import message_to_ordereddict
rows = {}

def hear(event):
    rows[event.transition.label] = message_to_ordereddict(event)
    if len(rows) == COUNT:
        print(json.dumps([rows[label] for label in sorted(rows)]), flush=True)

with rclpy.init():
    node = rclpy.create_node("listens")
    node.create_subscription(TransitionEvent, "/events", hear, 50)
    print("listening", flush=True)
    rclpy.spin(node)
"""


def time_of(event: dict[str, Any]) -> int:
    """Return the time of an event of either form [ns]."""
    stamp = event.get("stamp")
    return int(event["timestamp"]) if stamp is None else stamp["sec"] * 10**9 + stamp["nanosec"]


def plain(topic: str, row: dict[str, Any]) -> Any:
    """Return what a message says, whichever its form is."""
    return {
        "/events": lambda: [time_of(row), row["transition"]["label"]],
        "/pose": lambda: row["x"],
        "/texts": lambda: row["data"],
        "/tf": lambda: [
            row["transforms"][0]["child_frame_id"],
            row["transforms"][0]["transform"]["translation"]["x"],
        ],
    }[topic]()


EXPECTED = {
    "/events": [[7_000_000_000 + number, f"transition {number}"] for number in range(COUNT)],
    "/pose": [float(number) for number in range(COUNT)],
    "/texts": [f"text {number}" for number in range(COUNT)],
    "/tf": [[f"frame {number}", float(number)] for number in range(COUNT)],
}
"""What each recording says."""


def under(distribution: str) -> dict[str, str]:
    return os.environ | {"ROS_DISTRO": distribution}


def output(distribution: str, program: str, *arguments: Path) -> str:
    done = run_to_end([sys.executable, "-c", program, *arguments], env=under(distribution))
    assert done.returncode == 0, done.stderr
    return done.stdout


def record(distribution: str, folder: Path, start: Callable[..., Program]) -> list[Path]:
    """Record the same messages in each storage, by the command."""
    bags = [folder / f"{distribution}_{storage}" for storage in STORAGES]
    recorders = [
        start("ros2", "bag", "record", "-s", storage, "-o", bag, "--topics", *TOPICS, env=under(distribution))
        for storage, bag in zip(STORAGES, bags, strict=True)
    ]
    output(distribution, PUBLISH)
    for recorder in recorders:
        recorder.signal(signal.SIGINT)
        recorder.wait()
    return bags


def dictionary(message: Any) -> Any:
    """Return a message of rosbags as dictionaries and lists."""
    if isinstance(message, list):
        return [dictionary(item) for item in message]
    if not hasattr(message, "__msgtype__"):
        return message
    return {name: dictionary(value) for name, value in vars(message).items() if name != "__msgtype__"}


@pytest.mark.wire
@pytest.mark.parametrize("distribution", DISTRIBUTIONS)
def test_each_reader_finds_the_same_contents(
    distribution: str, domain_id: int, tmp_path: Path, start_program: Callable[..., Program]
) -> None:
    bags = record(distribution, tmp_path, start_program)
    turtlesim = "turtlesim" if distribution == "jazzy" else "turtlesim_msgs"
    for bag in bags:
        rows: dict[str, list[Any]] = {topic: [] for topic in TOPICS}
        with AnyReader([bag]) as reader:
            assert {connection.topic: connection.msgtype for connection in reader.connections}[
                "/pose"
            ] == f"{turtlesim}/msg/Pose"
            for connection, _, data in reader.messages():
                message = dictionary(reader.deserialize(data, connection.msgtype))
                rows[connection.topic].append(plain(connection.topic, message))
        assert rows == EXPECTED
    for other in DISTRIBUTIONS:
        for contents in json.loads(output(other, READ, *bags)):
            assert contents["types"]["/pose"] == f"{turtlesim}/msg/Pose"
            found = {topic: [plain(topic, row) for row in rows] for topic, rows in contents["rows"].items()}
            assert found == EXPECTED
            field = "stamp" if other == "lyrical" else "timestamp"
            assert all(field in row for row in contents["rows"]["/events"])
            assert any(line.endswith(f" {field}") for line in contents["event"])


@pytest.mark.wire
def test_a_recording_is_copied_and_played_under_another_distribution(
    domain_id: int, tmp_path: Path, start_program: Callable[..., Program], wait_until: Callable[..., None]
) -> None:
    """A copy has the form of where it was made; a player sends the recorded form, which each subscription reads."""
    [bag, _] = record("kilted", tmp_path, start_program)
    output("lyrical", COPY, bag, tmp_path / "copy")
    for copy_reader in ("jazzy", "lyrical"):
        [contents] = json.loads(output(copy_reader, READ, tmp_path / "copy"))
        found = {topic: [plain(topic, row) for row in rows] for topic, rows in contents["rows"].items()}
        assert found == EXPECTED
    program = LISTEN.replace("COUNT", str(COUNT))
    listeners = {
        distribution: start_program(sys.executable, "-c", program, env=under(distribution))
        for distribution in ("jazzy", "lyrical")
    }
    for listener in listeners.values():
        listener.wait_for("listening")
    player = start_program(
        *("ros2", "bag", "play", tmp_path / "copy", "--topics", "/events", "--loop"),
        stdin=subprocess.DEVNULL,
        env=under("jazzy"),
    )
    for distribution, listener in listeners.items():
        field = "stamp" if distribution == "lyrical" else "timestamp"
        wait_until(lambda listener=listener: any(line.startswith("[") for line in listener.lines))
        rows = json.loads(next(line for line in listener.lines if line.startswith("[")))
        assert all(field in row for row in rows)
        assert [plain("/events", row) for row in rows] == EXPECTED["/events"]
    player.signal(signal.SIGINT)
    player.wait()
