"""Pickles of messages: written by the real rclpy and read by tfloom, and the other way round."""

from __future__ import annotations

import os
import sys

import pytest
from tests.conftest import run_to_end
from tools.ros_peer import RosPeer

from .conftest import THEIRS, vendors

pytestmark = pytest.mark.ros

VALUES = """
import pickle, sys
from example_interfaces.action import Fibonacci
from geometry_msgs.msg import PoseStamped, PoseWithCovariance
from sensor_msgs.msg import CameraInfo, LaserScan, PointCloud2, PointField
from std_msgs.msg import Header, String
from std_srvs.srv import SetBool
feedback = Fibonacci.Impl.FeedbackMessage()
feedback.feedback.sequence = [0, 1, 1]
values = [
    String(data="text"),
    PoseStamped(header=Header(frame_id="map")),
    PoseWithCovariance(covariance=[float(number) for number in range(36)]),
    LaserScan(ranges=[1.0, 2.5]),
    PointCloud2(fields=[PointField(name="x", datatype=7, count=1)], data=bytes(range(8))),
    CameraInfo(distortion_model="plumb_bob", d=[0.5], k=[2.0] * 9),
    SetBool.Request(data=True),
    SetBool.Response(message="done"),
    Fibonacci.Goal(order=3),
    feedback,
    [Fibonacci, Fibonacci.Impl.GetResultService, SetBool, SetBool.Event],
]
"""
WRITE = VALUES + "print(pickle.dumps(values, protocol=int(sys.argv[1])).hex())"
READ = VALUES + "assert pickle.loads(bytes.fromhex(sys.stdin.read())) == values; print('equal')"


def run(vendor: str, code: str, peer: RosPeer, protocol: int, pickled: str = "") -> str:
    python = peer.python if vendor == THEIRS else sys.executable
    done = run_to_end(
        [python, "-c", code, str(protocol)],
        env=peer.environment(0) if vendor == THEIRS else os.environ,
        input=pickled,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("protocol", [2, 5])
def test_pickles_are_read_by_the_other(direction: str, protocol: int, peer: RosPeer) -> None:
    writer, reader = vendors(direction)
    pickled = run(writer, WRITE, peer, protocol)
    assert run(reader, READ, peer, protocol, pickled) == "equal\n"
