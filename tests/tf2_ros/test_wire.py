"""Broadcasters, listeners and a writer of hostile bytes, each in a separate process, over DDS."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable

import pytest
from tests.conftest import Program

from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener

BROADCASTER = """
import sys
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster


def transform(node, parent, child):
    t = TransformStamped()
    t.header.stamp = node.get_clock().now().to_msg()
    t.header.frame_id = parent
    t.child_frame_id = child
    t.transform.translation.x = 1.5
    return t


rclpy.init()
node = Node("broadcaster")
static = StaticTransformBroadcaster(node)
static.sendTransform(transform(node, "base", "laser"))
moving = TransformBroadcaster(node)
frames = sys.argv[1:] or ["map", "base"]
node.create_timer(0.02, lambda: moving.sendTransform(transform(node, *frames)))
print("broadcasting", flush=True)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException):
    pass
"""
"""Sends base -> laser once, and map -> base, or the two frames of its arguments, each 20 ms."""

LISTENER = """
import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from tf2_ros import Buffer, TransformException, TransformListener

rclpy.init()
node = Node("listener")
buffer = Buffer(node=node)
listener = TransformListener(buffer, node)
while rclpy.ok():
    try:
        t = buffer.lookup_transform("map", "laser", node.get_clock().now(), Duration(seconds=0.5))
        print("x", t.transform.translation.x, "at", t.header.stamp.sec, flush=True)
    except TransformException as error:
        print("none:", error, flush=True)
"""

VANDAL = """
import random
import time

import rclpy
from rclpy.node import Node
from tf2_msgs.msg import TFMessage
from geometry_msgs.msg import TransformStamped
from rclpy.serialization import serialize_message

rclpy.init()
node = Node("vandal")
publisher = node.create_publisher(TFMessage, "/tf", 100)
while publisher.get_subscription_count() == 0:
    time.sleep(0.01)
sound = serialize_message(TFMessage(transforms=[TransformStamped(child_frame_id="x") for _ in range(3)]))
source = random.Random(3)
for n in range(3000):
    kind = n % 4
    if kind == 0:
        data = sound[: source.randrange(5, len(sound))]
    elif kind == 1:
        data = b"\\0\\1\\0\\0" + source.randbytes(source.randrange(1, 200))
    elif kind == 2:
        data = sound[:4] + b"\\xff\\xff\\xff\\xff" + sound[8:]
    else:
        spoilt = bytearray(sound)
        for _ in range(5):
            spoilt[source.randrange(4, len(sound))] = source.randrange(256)
        data = bytes(spoilt)
    publisher.publish(data)
    if n % 100 == 0:
        time.sleep(0.002)
print("vandalised", flush=True)
time.sleep(0.5)
"""


HOLDER = """
import ctypes
import sys
import time
import threading
import time

import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener

HOLD = ctypes.PyDLL(None).usleep  # a call that keeps the interpreter to itself

rclpy.init()
node = Node("holder")
executor = MultiThreadedExecutor()
executor.add_node(node)
threading.Thread(target=executor.spin, daemon=True).start()
buffer = Buffer(node=node)
listener = TransformListener(buffer, node)
while not buffer.can_transform("map", "base", rclpy.time.Time()):
    time.sleep(0.01)
turns = 0
answered = []


def canary():
    global turns
    while True:
        turns += 1
        time.sleep(0)


def newest_ns():
    return buffer.get_latest_common_time("map", "base").nanoseconds


soon = rclpy.time.Time(nanoseconds=newest_ns() + 400_000_000, clock_type=rclpy.clock.ClockType.ROS_TIME)
future = buffer.wait_for_transform_async("map", "base", soon)
future.add_done_callback(answered.append)
threading.Thread(target=canary, daemon=True).start()
print("holding", flush=True)
sys.setswitchinterval(1000)
before = None
while before != turns:  # a thread that has waited since the earlier interval still gets a turn
    before = turns
    HOLD(20_000)
end_ns = newest_ns() + 1_000_000_000
give_up = time.monotonic() + 30
while newest_ns() < end_ns and time.monotonic() < give_up:
    HOLD(1000)
ran, was_answered, heard = turns - before, list(answered), newest_ns() >= end_ns
sys.setswitchinterval(0.005)
print("heard" if heard else "deaf", "while", ran, "turns of Python ran elsewhere", flush=True)
print("answered" if was_answered else "unanswered", flush=True)
while not answered:
    time.sleep(0.01)
print("answered at last:", answered[0].result().child_frame_id, flush=True)
"""

WAITER = """
import rclpy
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener

rclpy.init()
node = Node("waiter")
buffer = Buffer(node=node)
listener = TransformListener(buffer, node)
while not buffer.can_transform("map", "laser", rclpy.time.Time()):
    rclpy.spin_once(node)
print("found", flush=True)
"""


@pytest.fixture
def start(start_program: Callable[..., Program], domain_id: int) -> Callable[[str], Program]:
    return lambda source: start_program("python", "-c", source)


def count(program: Program, start_of_line: str) -> int:
    return sum(line.startswith(start_of_line) for line in list(program.lines))


def test_listener_survives_hostile_bytes_and_a_killed_broadcaster(
    start: Callable[[str], Program], wait_until: Callable[..., None]
) -> None:
    listener = start(LISTENER)
    broadcaster = start(BROADCASTER)
    wait_until(lambda: count(listener, "x 3.0") > 5, what="transforms")

    vandal = start(VANDAL)
    vandal.wait_for("vandalised")
    before = count(listener, "x 3.0")
    wait_until(lambda: count(listener, "x 3.0") > before + 5, what="transforms after hostile bytes")
    warnings = [line for line in listener.lines if "dropped a message" in line]
    assert 1 <= len(warnings) < 30
    assert "that is no tf2_msgs/msg/TFMessage" in warnings[0]

    broadcaster.signal(signal.SIGKILL)
    wait_until(lambda: count(listener, "none:") > 0, what="the lack of transforms")
    before = count(listener, "x 3.0")
    start(BROADCASTER)
    wait_until(lambda: count(listener, "x 3.0") > before + 5, what="transforms of the new broadcaster")
    assert listener.process.poll() is None


def test_spin_once_without_a_timeout_returns_for_a_transform(start: Callable[[str], Program]) -> None:
    waiter = start(WAITER)
    start(BROADCASTER)
    waiter.wait_for("found")


@pytest.mark.skipif(sys.platform == "win32", reason="usleep")
def test_transforms_are_received_while_the_gil_is_held(start: Callable[[str], Program]) -> None:
    start(BROADCASTER)
    holder = start(HOLDER)
    holder.wait_for("answered at last: base", 60)
    # A second of transforms arrived while the GIL was held, after one that a callback waits for.
    assert "heard while 0 turns of Python ran elsewhere" in holder.lines
    assert "unanswered" in holder.lines


def test_ctrl_c_ends_a_wait(start: Callable[[str], Program]) -> None:
    listener = start(
        LISTENER.replace("seconds=0.5", "seconds=60").replace("while", "print('up', flush=True)\nwhile", 1)
    )
    listener.wait_for("up")
    listener.signal(signal.SIGINT)
    listener.wait(timeout_s=20)
    assert not any("Fatal" in line or "terminate" in line for line in listener.lines)


POISONER = """
import select
import sys

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster

rclpy.init()
node = Node("poisoner")
broadcaster = TransformBroadcaster(node)


def send(child_frame_id, poisoned=False):
    t = TransformStamped(child_frame_id=child_frame_id)
    t.header.frame_id = "map"
    t.header.stamp = node.get_clock().now().to_msg()
    if poisoned:
        t.header.stamp.sec = 2147483647
    broadcaster.sendTransform(t)


while not select.select([sys.stdin], [], [], 0.02)[0]:
    send("hello")  # the first ones may be lost, because a subscription is matched before its publisher sends to it
sys.stdin.readline()
for poisoned in (True, False, True, False, True):
    send("base", poisoned)
send("end")
sys.stdin.readline()
rclpy.shutdown()
"""


def test_poisoned_stamp_does_not_hide_later_transforms(
    domain_id: int, start_program: Callable[..., Program], wait_until, capfd
) -> None:
    context = Context()
    context.init(args=[], domain_id=domain_id)
    node = Node("listening", context=context)
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    poisoner = start_program("python", "-c", POISONER, stdin=subprocess.PIPE)
    wait_until(lambda: buffer.can_transform("map", "hello", Time()))
    poisoner.process.stdin.write("go\n")
    poisoner.process.stdin.flush()
    wait_until(lambda: buffer.can_transform("map", "end", Time()))
    stamp = buffer.lookup_transform("map", "base", Time()).header.stamp
    assert abs(stamp.sec - time.time()) < 60
    text = ""

    def warned() -> bool:
        nonlocal text
        text += capfd.readouterr().err
        return "is held" in text or "are held" in text

    wait_until(warned)
    assert len(re.findall(r"The transform of 'base' from /poisoner, GID [0-9a-f]{2}\.", text)) == 1
    assert listener._sink.publisher_count == listener._sink.held_count == 1
    poisoner.process.stdin.close()
    assert poisoner.wait() == 0
    wait_until(lambda: listener._sink.publisher_count == listener._sink.held_count == 0)
    node.destroy_node()
    context.destroy()
