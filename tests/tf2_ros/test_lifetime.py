"""What a buffer and its callbacks refer to is freed with the last reference from outside."""

from __future__ import annotations

import gc
import threading
import weakref

import pytest
from tests.tf2_ros.conftest import transform_stamped

from tfloom._native import ReadyQueue
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.values.time import Time
from tfloom.rosidl.cdr import encode
from tfloom.tf2_ros.buffer import Buffer

IDENTITY = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)


class Robot:
    """Has a buffer whose log callback is its own method, as a node would."""

    def __init__(self) -> None:
        self.buffer = Buffer()
        self.buffer.set_log_callback(self.log)
        self.lines: list[str] = []

    def log(self, severity: int, text: str) -> None:
        self.lines.append(f"{severity} {text}")


def with_a_future(buffer: Buffer) -> None:
    buffer.wait_for_transform_async("a", "b", Time())


def with_a_future_between_two_times(buffer: Buffer) -> None:
    buffer.wait_for_transform_full_async("a", Time(), "b", Time(), "c")


def with_a_log_callback(buffer: Buffer) -> None:
    buffer.set_log_callback(lambda severity, text: print(buffer, severity, text))


def with_both_and_a_cancelled_future(buffer: Buffer) -> None:
    with_a_log_callback(buffer)
    buffer.wait_for_transform_async("a", "b", Time()).cancel()
    with_a_future(buffer)


USES = [
    *(with_a_future, with_a_future_between_two_times, with_a_log_callback, with_both_and_a_cancelled_future)
]


@pytest.mark.parametrize("use", USES)
def test_a_buffer_that_its_callbacks_refer_to_is_freed(use) -> None:
    buffer = Buffer()
    use(buffer)
    freed = weakref.ref(buffer)
    del buffer
    gc.collect()
    assert freed() is None


def test_a_sink_keeps_neither_the_callbacks_nor_their_owner() -> None:
    robot = Robot()
    sink = robot.buffer.tf_sink("wire", static=False)
    freed = weakref.ref(robot)
    del robot
    gc.collect()
    assert freed() is None
    sink.push(b"no message", 1, 2, bytes(16))  # rejected, without a log callback
    assert sink.dropped_count == 1


def test_callbacks_of_a_buffer_that_is_in_use_stay() -> None:
    robot = Robot()
    future = robot.buffer.wait_for_transform_async("a", "b", Time())
    gc.collect()
    robot.buffer.set("a", "", 1, *IDENTITY)
    assert len(robot.lines) == 1
    robot.buffer.set("a", "b", 1, *IDENTITY)
    assert future.result().child_frame_id == "b"


def test_a_future_alone_keeps_what_completes_it() -> None:
    buffer = Buffer()
    sink = buffer.tf_sink("wire", static=False)
    future = buffer.wait_for_transform_async("a", "b", Time())
    del buffer
    gc.collect()
    assert not future.done()
    source = Buffer()
    source.set("a", "b", 1, *IDENTITY)
    sink.push(tf_message("a", "b"), 1, 2, bytes(16))
    assert future.result().header.frame_id == "a"


def tf_message(frame_id: str, child_frame_id: str) -> bytes:
    return encode(TFMessage(transforms=[transform_stamped(frame_id, child_frame_id, 1)]))


def test_a_wire_that_goes_on_while_buffers_are_collected() -> None:
    """A sink logs on its own thread while the collector frees the buffer with its log callback."""
    ended = threading.Event()
    sinks: list[object] = []

    def push() -> None:
        data = tf_message("a", "")
        while not ended.is_set():
            for sink in sinks[-3:]:
                sink.push(data, 1, 2, bytes(16))

    wire = threading.Thread(target=push)
    wire.start()
    robots = weakref.WeakSet()
    try:
        for _ in range(300):
            robot = Robot()
            robots.add(robot)
            sinks.append(robot.buffer.tf_sink("wire", static=False))
            del robot
            gc.collect(1)
    finally:
        ended.set()
        wire.join()
    gc.collect()
    assert not robots


def test_a_result_holds_plain_text() -> None:
    """A str of a subclass could refer to the result that refers to it."""

    class Name(str):
        __slots__ = ("owner",)

    buffer = Buffer()
    buffer.set("a", "b", 1, *IDENTITY)
    result = buffer.lookup(Name("a"), Name("b"))
    assert type(result.frame_id) is type(result.child_frame_id) is str
    assert (result.frame_id, result.child_frame_id) == ("a", "b")


USES_EVERYTHING = """
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.time import Time
from std_srvs.srv import Trigger
from tf2_ros import Buffer, TransformBroadcaster, TransformListener

rclpy.init()
node = rclpy.create_node("leaks_nothing")
buffer = Buffer(node=node)
listener = TransformListener(buffer, node)
broadcaster = TransformBroadcaster(node)
service = node.create_service(Trigger, "trigger", lambda request, response: response)
client = node.create_client(Trigger, "trigger")
buffer.set_log_callback(lambda severity, text: node.get_logger().info(text))
future = buffer.wait_for_transform_async("a", "b", Time())
never = buffer.wait_for_transform_async("a", "c", Time())
transform = TransformStamped(child_frame_id="b")
transform.header.frame_id = "a"
deserialize_message(serialize_message(transform), TransformStamped)
broadcaster.sendTransform(transform)
rclpy.spin_until_future_complete(node, future, timeout_sec=30)
assert future.done()
node.destroy_node()
rclpy.shutdown()
"""


@pytest.fixture
def leak_warnings(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have programs print each object of the extension that lives when the interpreter has ended."""
    monkeypatch.setenv("TFLOOM_LEAK_WARNINGS", "1")


@pytest.mark.usefixtures("leak_warnings")
def test_a_program_leaks_nothing(domain_id: int, start_program) -> None:
    program = start_program("python", "-c", USES_EVERYTHING)
    assert program.wait() == 0, program.output
    assert program.output == ""


@pytest.mark.usefixtures("leak_warnings")
def test_the_extension_prints_what_is_leaked(start_program) -> None:
    leak = "import ctypes, tfloom._native as n; q = n.ReadyQueue(); ctypes.pythonapi.Py_IncRef(ctypes.py_object(q))"
    program = start_program("python", "-c", leak)
    assert program.wait() == 0, program.output
    assert "leaked 1 instances" in program.output
    assert ReadyQueue.__name__ in program.output
