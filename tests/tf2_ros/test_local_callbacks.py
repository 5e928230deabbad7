"""Users' functions that a wire calls: it holds no lock meanwhile, so that they may write, match and close on it.

They run in a separate program, because a deadlock would hang also what ends the test's process.
"""

from __future__ import annotations

import subprocess
import sys

import pytest
from tests.conftest import run_to_end

TIMEOUT_S = 60

PROGRAM = """
import threading
import rclpy
from geometry_msgs.msg import PointStamped, TransformStamped
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformBroadcaster, TransformListener
from tfloom.tf2_ros.message_filter import MessageFilter

IS_LOCAL = rclpy.get_rmw_implementation_identifier() == "tfloom_local"
LATEST = Time(seconds=1)
rclpy.init()
wait = Duration(seconds=30)

def send(parent, child):
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id, message.header.stamp.sec, message.transform.rotation.w = parent, 1, 1.0
    broadcaster.sendTransform(message)

def send_another(_):
    send("base", "tool")
    # On the wire in the process, a write delivers before it returns, in a callback too.
    assert not IS_LOCAL or buffer.can_transform("map", "tool", LATEST)
    done.set()

def publish():
    buffer.wait_for_transform_async("map", "base", LATEST).add_done_callback(send_another)

def filter_without_a_node():
    waiting = MessageFilter(None, buffer, "map", 10)
    waiting.registerCallback(send_another)
    point = PointStamped()
    point.header.frame_id, point.header.stamp.sec = "base", 1
    waiting.add(point)

def open_and_close():
    def change(_):
        other = TransformListener(Buffer(), node)
        static = StaticTransformBroadcaster(node)
        fixed = TransformStamped(child_frame_id="fixed")
        fixed.header.frame_id, fixed.transform.rotation.w = "map", 1.0
        static.sendTransform(fixed)
        other.unregister()
        send_another(None)

    buffer.wait_for_transform_async("map", "base", LATEST).add_done_callback(change)

def publish_elsewhere():
    # What other threads write meanwhile is stored by the thread of the callback, after it.
    def change(_):
        writer = threading.Thread(target=lambda: [send("base", f"tool{number}") for number in range(20)], daemon=True)
        writer.start()
        writer.join()
        send_another(None) if not IS_LOCAL else (send("base", "tool"), done.set())

    buffer.wait_for_transform_async("map", "base", LATEST).add_done_callback(change)

for case in (publish, filter_without_a_node, open_and_close, publish_elsewhere):
    node = rclpy.create_node("calls_back")
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    broadcaster = TransformBroadcaster(node)
    done = threading.Event()
    print(case.__name__, flush=True)
    case()
    while not done.wait(0.1):  # the two ends on DDS may not have met yet
        send("map", "base")
    frames = ["tool"] + [f"tool{number}" for number in range(20)] * (case is publish_elsewhere)
    assert all(buffer.can_transform("map", frame, LATEST, wait) for frame in frames)
    node.destroy_node()
"""
CASES = ["publish", "filter_without_a_node", "open_and_close", "publish_elsewhere"]


@pytest.mark.parametrize("wire", ["tfloom_local", "rmw_cyclonedds_cpp"])
def test_callback_uses_the_wire(wire: str, monkeypatch: pytest.MonkeyPatch, domain_id: int) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", wire)
    try:
        ended = run_to_end([sys.executable, "-c", PROGRAM], timeout_s=TIMEOUT_S)
    except subprocess.TimeoutExpired as error:
        pytest.fail(f"the last of these does not return: {error.stdout!r} {error.stderr!r}")
    assert (ended.returncode, ended.stdout.split(), ended.stderr) == (0, CASES, "")
