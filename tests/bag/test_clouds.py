"""Clouds of a recording, transformed and deskewed; and what messages show in notebooks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.writer import Writer
from tests.bag.recordings import SECOND, START

from tfloom.bag import BagError, clouds, open_bag
from tfloom.bag.moved_clouds import point_stamps
from tfloom.interfaces.geometry_msgs.msg import PoseStamped
from tfloom.interfaces.sensor_msgs.msg import PointCloud2, PointField
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.rosidl.cdr import encode
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import ExtrapolationException
from tfloom.tf2_ros.point_clouds.point_cloud2 import create_cloud, read_points

KINDS = {
    "t": (PointField.UINT32, 1.0, 0),
    "time": (PointField.FLOAT32, 1e-9, 0),
    "timestamp": (PointField.FLOAT64, 1e-9, START),
}
"""Fields with the time of a point: their type, their unit in nanoseconds, and what they count from."""


def cloud_of(stamp: int, field: str | None, count: int = 100) -> Any:
    """Return a cloud of one wall's point, measured while the sensor moves towards it at 10 m/s, for 0.1 s."""
    offsets = np.arange(count) * (SECOND // 10 // count)
    names = [
        PointField(name=name, offset=4 * i, datatype=PointField.FLOAT32, count=1)
        for i, name in enumerate("xyz")
    ]
    layout: list[tuple[str, str]] = [("x", "f4"), ("y", "f4"), ("z", "f4")]
    if field:
        kind, unit, origin = KINDS[field]
        names.append(PointField(name=field, offset=12, datatype=kind, count=1))
        layout.append(
            (field, {PointField.UINT32: "u4", PointField.FLOAT32: "f4", PointField.FLOAT64: "f8"}[kind])
        )
    points = np.zeros(count, layout)
    points["x"] = 20 - 10 * ((stamp - START) + offsets) / 1e9
    if field:
        points[field] = ((stamp if origin else 0) + offsets) * unit
    header = Header(frame_id="lidar")
    header.stamp.sec, header.stamp.nanosec = divmod(stamp, SECOND)
    return create_cloud(header, names, points)


def write(path: Path, field: str | None) -> Path:
    with path.open("wb") as file:
        writer = Writer(file)
        writer.start("ros2", "a test")
        schema = writer.register_schema("sensor_msgs/msg/PointCloud2", "ros2msg", b"")
        channel = writer.register_channel("/points", "cdr", schema)
        for i in range(4):
            stamp = START + i * SECOND // 5
            writer.add_message(channel, stamp + 7, encode(cloud_of(stamp, field)), stamp)
        text = writer.register_channel(
            "/text", "cdr", writer.register_schema("std_msgs/msg/String", "ros2msg", b"string data")
        )
        writer.add_message(text, START, b"\0\1\0\0\2\0\0\0a\0", START)
        writer.finish()
    return path


@pytest.fixture
def buffer() -> Buffer:
    made = Buffer(None)
    stamps = START + np.arange(101) * (SECOND // 100)
    positions = np.zeros((101, 3))
    positions[:, 0] = np.arange(101) / 10
    made.set_many("odom", "lidar", stamps, positions, np.tile([0, 0, 0, 1.0], (101, 1)))
    return made


@pytest.mark.parametrize("field", KINDS)
def test_deskewed_wall_is_flat(field: str, buffer: Buffer, tmp_path: Path) -> None:
    path = write(tmp_path / "a.mcap", field)
    skewed = [read_points(cloud) for cloud in clouds(path, "/points", buffer, "odom")]
    flat = list(clouds(path, "/points", buffer, "odom", fixed_frame="odom"))
    assert len(skewed) == len(flat) == 4
    tolerance = 2e-5 if field != "timestamp" else 1e-4
    for before, cloud in zip(skewed, flat, strict=True):
        points = read_points(cloud)
        assert np.abs(before["x"] - 20).max() > 0.9
        assert np.abs(points["x"] - 20).max() < tolerance
        assert (points[field] == before[field]).all()
        assert cloud.header.frame_id == "odom"


def test_stamps_of_the_clouds_are_kept(buffer: Buffer, tmp_path: Path) -> None:
    path = write(tmp_path / "a.mcap", "t")
    with open_bag(path) as bag:
        stamps = bag.stamps("/points").tolist()
        found = clouds(bag, "/points", buffer, "odom", fixed_frame="odom", start_ns=START + SECOND // 5)
        assert [cloud.header.stamp.sec * SECOND + cloud.header.stamp.nanosec for cloud in found] == stamps[1:]
        assert bag.stamps("/points", "log").tolist() == [stamp + 7 for stamp in stamps]
        assert bag.stamps("/points", "publish").tolist() == stamps
        with pytest.raises(BagError, match="messages of /text, of type std_msgs/msg/String, have no header"):
            bag.stamps("/text", "header")
        with pytest.raises(ValueError, match="of must be header, log or publish, not 'sent'"):
            bag.stamps("/text", "sent")


def test_time_of_a_point_in_a_unit(tmp_path: Path) -> None:
    cloud = cloud_of(START, "t", 5)
    expected = START + np.arange(5) * 20_000_000
    assert point_stamps(cloud).tolist() == expected.tolist()
    micro = point_stamps(cloud, "t", 1e-6)
    assert micro.tolist() == (START + np.arange(5) * 20_000_000_000).tolist()


def test_clouds_without_a_transform_or_a_time(buffer: Buffer, tmp_path: Path) -> None:
    path = write(tmp_path / "a.mcap", None)
    with pytest.raises(
        BagError, match="a cloud on /points can't be deskewed: the points have no field one of t, time"
    ):
        list(clouds(path, "/points", buffer, "odom", fixed_frame="odom"))
    with pytest.raises(BagError, match="the points have no field 'when'; they have: x, y, z"):
        list(clouds(path, "/points", buffer, "odom", fixed_frame="odom", time_field="when"))
    with pytest.raises(BagError, match="the topic /text has the type std_msgs/msg/String, not sensor_msgs"):
        list(clouds(path, "/text", buffer, "odom"))
    short = Buffer(None)
    short.set("odom", "lidar", START, (0, 0, 0), (0, 0, 0, 1))
    short.set("odom", "lidar", START + SECOND // 5, (0, 0, 0), (0, 0, 0, 1))
    with pytest.raises(ExtrapolationException):
        list(clouds(path, "/points", short, "odom"))
    assert len(list(clouds(path, "/points", short, "odom", skip_unknown=True))) == 2


def test_what_messages_show_in_a_notebook() -> None:
    pose = PoseStamped(header=Header(frame_id="<map>"))
    shown = pose._repr_html_()
    assert "<b>geometry_msgs/msg/PoseStamped</b>" in shown
    assert "&lt;map&gt;" in shown
    assert shown.count("<table ") == shown.count("</table>") == 6
    cloud = cloud_of(START, "t")
    assert "1600: [" in cloud._repr_html_()
    assert len(cloud._repr_html_()) < 20_000
    assert PointCloud2()._repr_html_().count("<tr ") >= 9
