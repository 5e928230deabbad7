"""Messages with any bytes: each is drawn, or is a sentence; none ends the viewer, or takes long."""

from __future__ import annotations

import random
import time
import zlib
from typing import Any

import numpy as np
import pytest
from tests.viewer.messages import ARM, camera_info, cloud, depth_image, efforts, header, marker, pose, wrench

from tfloom.interfaces.geometry_msgs.msg import (
    Point,
    Point32,
    PointStamped,
    Polygon,
    PolygonStamped,
    PoseArray,
    PoseStamped,
    PoseWithCovariance,
    PoseWithCovarianceStamped,
    Twist,
    TwistStamped,
    Vector3,
)
from tfloom.interfaces.nav_msgs.msg import GridCells, MapMetaData, OccupancyGrid, Odometry, Path
from tfloom.interfaces.sensor_msgs.msg import CameraInfo, Image, LaserScan, PointCloud, Range
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.turtlesim.msg import Pose as TurtlePose
from tfloom.interfaces.visualization_msgs.msg import MarkerArray
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.viewer.displays.camera_info import pinhole_of
from tfloom.viewer.displays.depth_cloud import DepthCloudDisplay
from tfloom.viewer.displays.kinds import kind_of
from tfloom.viewer.displays.settings import CLOUD_SETTINGS, usual_values
from tfloom.viewer.displays.wrench import EffortDisplay
from tfloom.viewer.feed import Feed
from tfloom.viewer.pictures import picture_of
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.topic_log import TopicLog

TRIES = 300
LONGEST_S = 60.0
CLOUD = np.zeros(4, [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("rgb", "<f4")])
INFO = MapMetaData(resolution=0.1, width=3, height=2, origin=pose())
K = [100.0, 0, 50, 0, 100.0, 40, 0, 0, 1]
URDF = (
    '<robot name="r"><link name="a"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>'
)
MESSAGES: dict[str, Any] = {
    "/points": cloud(CLOUD),
    "/old_points": PointCloud(header=header(), points=[Point32()] * 3),
    "/scan": LaserScan(
        header=header(), angle_increment=0.1, range_max=9.0, ranges=[1.0] * 9, intensities=[2.0] * 9
    ),
    "/range": Range(header=header(), field_of_view=0.5, range=1.0),
    "/camera": CameraInfo(header=header(), width=9, height=9, k=K),
    "/markers": MarkerArray(
        markers=[marker(kind, kind, points=[Point()] * 6, text="t") for kind in range(12)]
    ),
    "/path": Path(header=header(), poses=[PoseStamped(pose=pose())] * 3),
    "/odom": Odometry(header=header(), pose=PoseWithCovariance(pose=pose(), covariance=[0.5] * 36)),
    "/map": OccupancyGrid(header=header(), info=INFO, data=[0, 50, 100, -1, 7, 8]),
    "/pose": PoseStamped(header=header(), pose=pose()),
    "/point": PointStamped(header=header()),
    "/estimate": PoseWithCovarianceStamped(
        header=header(), pose=PoseWithCovariance(pose=pose(), covariance=np.eye(6).ravel())
    ),
    "/poses": PoseArray(header=header(), poses=[pose()] * 3),
    "/polygon": PolygonStamped(header=header(), polygon=Polygon(points=[Point32()] * 3)),
    "/wrench": wrench((9.0, 0.0, 0.0), (0.0, 9.0, 0.0)),
    "/twist": TwistStamped(header=header(), twist=Twist(linear=Vector3(x=9.0), angular=Vector3(z=9.0))),
    "/cells": GridCells(header=header(), cell_width=0.5, cell_height=0.5, cells=[Point()] * 3),
    "/joint_states": efforts(elbow=5.0, rail=4.0),
    "/turtle": TurtlePose(x=1.0),
    "/robot_description": String(data=URDF),
}


def changed(data: bytes, chance: random.Random) -> bytes:
    """Return the bytes with a few of them changed, behind the encapsulation header."""
    octets = bytearray(data)
    for _ in range(chance.randint(1, 6)):
        octets[chance.randrange(4, len(octets))] = chance.choice(
            (0, 1, 0x7F, 0x80, 0xFF, chance.randrange(256))
        )
    return bytes(octets)


@pytest.mark.parametrize("topic", MESSAGES)
def test_changed_bytes_are_drawn_or_are_a_sentence(topic: str) -> None:
    message = MESSAGES[topic]
    kind = kind_of(topic, message._TYPE_NAME)
    assert kind is not None
    log = TopicLog(10**18, lambda data: cdr.decode(type(message), data))
    feed = Feed(topic, kind, log.open())
    if isinstance(feed.display, EffortDisplay):
        feed.display.partner = feed.display.partner_of(String(data=ARM))
    buffer = Buffer()
    buffer.set_log_callback(None)
    buffer.set("map", "base", 1, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), static=True)
    chance = random.Random(zlib.crc32(topic.encode()))
    drawn = 0
    start_s = time.monotonic()
    for number in range(TRIES):
        data = changed(cdr.encode(message), chance) if number else cdr.encode(message)
        log.add(number + 1, data)
        with np.errstate(all="ignore"):
            placed = feed.draw(buffer, "map", None, number + 1)
        drawn += bool(placed)
        feed.status.encode()  # as for a page
        for shape, pose_in_map in placed:
            for value in vars(shape).values():
                if isinstance(value, np.ndarray) and value.dtype.kind == "f":
                    assert np.isfinite(value).all(), shape
            if pose_in_map is not None:
                assert np.isfinite(pose_in_map[0]).all()
    assert drawn, feed.status
    assert time.monotonic() < start_s + LONGEST_S


@pytest.mark.parametrize("encoding", ["16UC1", "32FC1"])
def test_changed_depth_images_and_infos_are_drawn_or_are_a_sentence(encoding: str) -> None:
    image, info = depth_image(np.ones((3, 4)), encoding), camera_info(4, 3)
    chance = random.Random(7)
    drawn = 0
    for number in range(TRIES):
        display = DepthCloudDisplay(usual_values(CLOUD_SETTINGS))
        seen = changed(cdr.encode(info), chance) if number % 2 else cdr.encode(info)
        data = changed(cdr.encode(image), chance) if number % 3 else cdr.encode(image)
        try:
            display.partner = pinhole_of(cdr.decode(CameraInfo, seen))
            display.take(cdr.decode(Image, data), 1)
        except (DisplayError, cdr.DecodeError):
            continue
        for placed in display.shapes(1):
            assert np.isfinite(placed.shape.positions).all()
            drawn += 1
    assert drawn > TRIES / 6


def test_changed_images_are_pictures_or_a_sentence() -> None:
    image = Image(header=header(), width=8, height=6, step=24, encoding="rgb8", data=bytes(144))
    chance = random.Random(5)
    for _ in range(TRIES):
        try:
            kind, data = picture_of(cdr.decode(Image, changed(cdr.encode(image), chance)))
        except (DisplayError, cdr.DecodeError):
            continue
        assert kind == "image/jpeg"
        assert data.startswith(b"\xff\xd8\xff")
