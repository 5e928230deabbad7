"""The diagnosis of recordings and of files of static transforms."""

from __future__ import annotations

import math
import sqlite3
import struct
from collections.abc import Iterable
from pathlib import Path

from tests.tf2_tools.diagnosis.faulty_nodes import edge

from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message
from tfloom.tf2_tools.diagnosis.recorded import read, ros1_frame_id
from tfloom.tf2_tools.diagnosis.report import diagnose

S = 1_000_000_000
TABLES = """
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT NOT NULL,
  offered_qos_profiles TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB);
"""


def write_bag(path: Path, messages: Iterable[tuple[str, float, Message]]) -> Path:
    """Write a bag of sqlite3: topics, times of receipt [s], messages."""
    ids: dict[str, int] = {}
    with sqlite3.connect(path) as file:
        file.executescript(TABLES)
        for topic, at_s, message in messages:
            if topic not in ids:
                ids[topic] = len(ids) + 1
                row = (ids[topic], topic, message._TYPE_NAME, "cdr", "")
                file.execute("INSERT INTO topics VALUES(?, ?, ?, ?, ?)", row)
            row = (ids[topic], round(at_s * S), cdr.encode(message))
            file.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", row)
    file.close()
    return path


def moving(parent: str, child: str, at_s: float) -> TFMessage:
    return TFMessage(transforms=[edge(parent, child, stamp_ns=round(at_s * S), x=math.sin(at_s))])


def scan(frame: str) -> LaserScan:
    message = LaserScan()
    message.header.frame_id = frame
    return message


def test_a_sound_recording_has_no_findings(tmp_path: Path) -> None:
    times = [1000.0 + 0.05 * step for step in range(60)]
    bag = write_bag(
        tmp_path / "ä b.db3",
        [("/tf_static", 1000.0, TFMessage(transforms=[edge("base_link", "laser", x=0.1)]))]
        + [("/tf", at_s, moving("odom", "base_link", at_s)) for at_s in times]
        + [("/scan", at_s, scan("laser")) for at_s in times],
    )
    subject = read(bag, with_topics=True)
    assert diagnose(subject) == []
    assert [(use.frame, use.count) for use in subject.headers] == [("laser", 60)]
    assert subject.frames == {"odom", "base_link", "laser"}


def test_faults_of_a_recording_name_topics(tmp_path: Path) -> None:
    times = [1000.0 + 0.05 * step for step in range(60) if not 20 <= step < 40]
    bag = write_bag(
        tmp_path / "faulty.db3",
        [("/tf", at_s, moving("/odom", "base_link", at_s)) for at_s in times]
        + [("/tf_static", 1000.0, TFMessage(transforms=[edge("odom", "base_link", x=0.1)]))]
        + [("/scan", 1001.0, scan("lsaer")), ("/scan", 1002.0, scan("base_link"))],
    )
    findings = diagnose(read(bag, with_topics=True))
    assert [finding.code for finding in findings] == ["TF102", "TF601", "TF201", "TF406"]
    assert [finding.summary for finding in findings] == [
        "base_link is static and dynamic: /tf, /tf_static",
        "what /scan publishes is in the frame 'lsaer', which no transform holds",
        "/tf sends frame ids with a leading slash: /odom -> base_link",
        "/tf paused: /odom -> base_link",
    ]
    assert {source.node for finding in findings for source in finding.sources} == {""}
    assert [finding.code for finding in diagnose(read(bag))] == ["TF102", "TF201", "TF406"]


def test_a_file_of_static_transforms(tmp_path: Path) -> None:
    path = tmp_path / "statics.yaml"
    path.write_text(
        "static_transforms:\n"
        "- {frame_id: base_link, child_frame_id: laser, translation: {x: 0.1}}\n"
        "- {frame_id: mast, child_frame_id: camera, translation: {z: 1}}\n"
    )
    assert [finding.code for finding in diagnose(read(path))] == ["TF105"]


def test_headers_of_ros_1() -> None:
    header = struct.pack("<IIII", 1, 2, 3, 5)
    assert ros1_frame_id(header + b"laserrest") == "laser"
    for hostile in (b"", header[:15], header, header + b"lase", struct.pack("<IIII", 1, 2, 3, 2**32 - 1)):
        assert ros1_frame_id(hostile) == ""
