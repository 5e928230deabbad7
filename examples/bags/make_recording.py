"""Make a recording: a robot drives round in a room of 20 m by 12 m, and its lidar measures the walls.

`python examples/bags/make_recording.py FOLDER` writes it: /tf, /tf_static and /points, 4 s, as rosbag2 would.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from geometry_msgs.msg import TransformStamped
from rclpy.serialization import serialize_message
from sensor_msgs.msg import PointCloud2, PointField
from sensor_msgs_py.point_cloud2 import create_cloud
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.bag.writing.definition_text import find_definition, hash_of

SECOND = 1_000_000_000
START_NS = 1_700_000_000 * SECOND
DURATION_S = 4.0
RADIUS_M = 4.0
TURN_RAD_PER_S = 1.5
SWEEP_S = 0.1
POINTS = 4_000
CORNER = np.array([10.0, 6.0])


def pose(seconds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return positions (N, 2) and headings (N,) of the robot in the room."""
    yaw = TURN_RAD_PER_S * seconds
    return np.stack((RADIUS_M * np.sin(yaw), -RADIUS_M * np.cos(yaw)), axis=1), yaw


def transform(
    frame_id: str, child: str, stamp_ns: int, at: tuple[float, float, float], yaw: float
) -> TransformStamped:
    message = TransformStamped()
    message.header = header(frame_id, stamp_ns)
    message.child_frame_id = child
    message.transform.translation.x, message.transform.translation.y, message.transform.translation.z = at
    message.transform.rotation.z, message.transform.rotation.w = (
        float(np.sin(yaw / 2)),
        float(np.cos(yaw / 2)),
    )
    return message


def header(frame_id: str, stamp_ns: int) -> Header:
    made = Header(frame_id=frame_id)
    made.stamp.sec, made.stamp.nanosec = divmod(stamp_ns, SECOND)
    return made


def sweep(stamp_ns: int) -> PointCloud2:
    """Return what the lidar measures in a tenth of a second, each point at its own time in the field `t` [ns]."""
    offsets = (np.arange(POINTS) * (SWEEP_S * SECOND / POINTS)).astype(np.uint32)
    positions, yaw = pose((stamp_ns - START_NS + offsets) / SECOND)
    bearing = 2 * np.pi * np.arange(POINTS) / POINTS
    ahead = np.stack((np.cos(bearing + yaw), np.sin(bearing + yaw)), axis=1)
    with np.errstate(divide="ignore"):
        distance = ((np.copysign(CORNER, ahead) - positions) / ahead).min(axis=1)
    points = np.zeros(POINTS, [("x", "f4"), ("y", "f4"), ("z", "f4"), ("t", "u4")])
    points["x"], points["y"] = distance * np.cos(bearing), distance * np.sin(bearing)
    points["t"] = offsets
    fields = [
        PointField(name=name, offset=4 * i, datatype=PointField.FLOAT32, count=1)
        for i, name in enumerate("xyz")
    ]
    fields.append(PointField(name="t", offset=12, datatype=PointField.UINT32, count=1))
    return create_cloud(header("lidar", stamp_ns), fields, points)


def messages() -> Iterator[tuple[str, int, Any]]:
    """Yield topics, times of receipt [ns] and messages, in the order of time."""
    yield (
        "/tf_static",
        START_NS,
        TFMessage(transforms=[transform("base_link", "lidar", START_NS, (0.0, 0.0, 0.8), 0.0)]),
    )
    for step in range(int(DURATION_S * 100) + 1):
        stamp = START_NS + step * SECOND // 100
        (position,), (yaw,) = pose(np.array([step / 100]))
        moving = [
            transform("odom", "base_link", stamp, (float(position[0]), float(position[1]), 0.0), float(yaw))
        ]
        if step % 10 == 0:
            moving.append(transform("map", "odom", stamp, (0.0, 0.0, 0.0), 0.0))
        yield "/tf", stamp, TFMessage(transforms=moving)
        if step % 20 == 0 and step / 100 + SWEEP_S <= DURATION_S:
            yield "/points", stamp, sweep(stamp)


def record(folder: Path) -> Path:
    """Write the recording into a folder, which must not exist; return the folder."""
    writer = BagWriter(folder)
    channels: dict[str, int] = {}
    for topic, stamp, message in messages():
        if topic not in channels:
            name = type(message).__module__.split(".")[0] + "/msg/" + type(message).__name__
            definition = find_definition(name)
            channels[topic] = writer.add_topic(Topic(topic, name, "cdr", hash_of(name), "", definition))
        writer.push(channels[topic], serialize_message(message), stamp, stamp)
    writer.close()
    return folder


if __name__ == "__main__":
    print(record(Path(sys.argv[1])))
