"""A callback that never returns, on a thread of the wire: its program ends nevertheless, on each wire."""

from __future__ import annotations

import json
import signal
import threading
import time
from collections.abc import Callable, Iterator

import pytest
from tests.conftest import Program
from tests.tf2_ros.conftest import transform_stamped
from tests.zenoh_ports import NEEDS_ZENOH, use_port_of

from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_listener import TransformListener

WIRES = [
    "tfloom_local",
    "rmw_cyclonedds_cpp",
    pytest.param("rmw_zenoh_cpp", marks=NEEDS_ZENOH),
]
END_S = 15.0
"""Longest time of an end, on a busy machine too: each wait for the callback takes a second."""

PROGRAM = """
import sys, threading, time
import rclpy
from geometry_msgs.msg import PointStamped, TransformStamped
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformListener
from tfloom.tf2_ros.message_filter import MessageFilter

kind, end = sys.argv[1:]
rclpy.init()
node, buffer = Node("stuck"), Buffer()
listener, broadcaster = TransformListener(buffer, node), StaticTransformBroadcaster(node)
entered = threading.Event()

def stay(*arguments):
    entered.set()
    while True:
        time.sleep(0.1)

if kind == "future":
    buffer.wait_for_transform_async("map", "base", Time()).add_done_callback(stay)
elif kind == "log":
    buffer.set_log_callback(stay)
else:
    waiting = MessageFilter(None, buffer, "map", 1)
    waiting.registerCallback(stay)
    point = PointStamped()
    point.header.frame_id = "base"
    waiting.add(point)

transform = TransformStamped(child_frame_id="base")
transform.header.frame_id = "base" if kind == "log" else "map"  # a frame that is its own parent is logged
transform.transform.rotation.w = 1.0
threading.Thread(target=broadcaster.sendTransform, args=(transform,), daemon=True).start()
assert entered.wait(30)
if end == "Ctrl-C":
    try:
        print("entered", flush=True)
        rclpy.spin(node)
    except KeyboardInterrupt:
        print("interrupted", flush=True)
else:
    print("entered", flush=True)
if end == "shutdown":
    node.destroy_node()
    rclpy.shutdown()
    print("shut down", flush=True)
"""


@pytest.mark.parametrize("wire", WIRES)
@pytest.mark.parametrize(
    ("kind", "end"),
    [
        ("future", "shutdown"),
        ("future", "the end"),
        ("future", "Ctrl-C"),
        ("log", "shutdown"),
        ("filter", "the end"),
    ],
)
def test_a_program_ends_beside_a_callback_that_never_returns(
    kind: str,
    end: str,
    wire: str,
    domain_id: int,
    monkeypatch: pytest.MonkeyPatch,
    start_program: Callable[..., Program],
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", wire)
    with use_port_of(domain_id):
        program = start_program("python", "-c", PROGRAM, kind, end)
        program.wait_for("entered")
        if end == "Ctrl-C":
            program.signal(signal.SIGINT)
        assert program.wait(END_S) == 0, program.output
        assert program.lines[1:] == {"shutdown": ["shut down"], "Ctrl-C": ["interrupted"]}.get(end, [])


BESIDE = """
import json, sys, threading, time
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.time import Time
from std_msgs.msg import String
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformListener

rclpy.init()
node = Node("stuck")
buffers = [Buffer(), Buffer()]
listeners = [TransformListener(buffer, node) for buffer in buffers]
broadcaster = StaticTransformBroadcaster(node)
entered = threading.Event()
called = [False, False]
heard = []
node.create_subscription(String, "chatter", heard.append, 10)
chatter = node.create_publisher(String, "chatter", 10)

def stay(_):
    entered.set()
    while True:
        time.sleep(0.1)

def call(number):
    called[number] = True

def send(child):
    transform = TransformStamped(child_frame_id=child)
    transform.header.frame_id = "map"
    transform.transform.rotation.w = 1.0
    threading.Thread(target=broadcaster.sendTransform, args=(transform,), daemon=True).start()

buffers[0].wait_for_transform_async("map", "base", Time()).add_done_callback(stay)
for number, buffer in enumerate(buffers):
    buffer.wait_for_transform_async("map", "later", Time()).add_done_callback(lambda _, number=number: call(number))
send("base")
assert entered.wait(30)
send("later")
known = lambda: [buffer.can_transform("map", "later", Time()) for buffer in buffers]
end_s = time.monotonic() + 30
expected = json.loads(sys.argv[1])
while time.monotonic() < end_s and (not heard or [known(), called] != expected):
    chatter.publish(String())
    rclpy.spin_once(node, timeout_sec=0.1)
for _ in range(20):  # and it stays so
    rclpy.spin_once(node, timeout_sec=0.05)
print(json.dumps([known(), called, bool(heard)]), flush=True)
"""
GOES_ON = {
    "tfloom_local": ([False, True], [False, True]),
    "rmw_cyclonedds_cpp": ([True, True], [False, False]),
    "rmw_zenoh_cpp": ([False, True], [False, True]),
}
"""By wire: whether the buffer whose callback never returns, and another one, get later transforms; whether callbacks of
theirs are called."""


@pytest.mark.parametrize("wire", WIRES)
def test_what_goes_on_beside_a_callback_that_never_returns(
    wire: str, domain_id: int, monkeypatch: pytest.MonkeyPatch, start_program: Callable[..., Program]
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", wire)
    with use_port_of(domain_id):
        program = start_program("python", "-c", BESIDE, json.dumps(GOES_ON[wire]))
        assert program.wait(60) == 0, program.output
        assert json.loads(program.lines[-1]) == [*GOES_ON[wire], True]


@pytest.fixture
def context(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[Context]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    context = Context()
    context.init([])
    yield context
    context.destroy()


def test_what_a_callback_waits_for_is_done_beside_the_end_of_its_wire(context: Context) -> None:
    """The end waits a second for a callback, and holds no lock meanwhile that the callback needs."""
    node, buffer = Node("late", context=context), Buffer()
    listener = TransformListener(buffer, node)
    broadcaster = StaticTransformBroadcaster(node)
    entered, closing, asked = threading.Event(), threading.Event(), threading.Event()

    def use_the_context(_: object) -> None:
        entered.set()
        assert closing.wait(30)
        while context._participant is not None:
            time.sleep(0.001)
        context.add_shutdown_hook(asked.set)

    buffer.wait_for_transform_async("map", "base", Time()).add_done_callback(use_the_context)
    broadcaster.sendTransform(transform_stamped("map", "base", 0))
    assert entered.wait(30)
    context.shutdown()
    closing.set()
    listener.unregister()
    node.destroy_node()  # the last one: the wire is closed
    assert asked.is_set()
